// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/datasets/dataset.h"
#include "eval/evaluation/self_test_check.h"

namespace hydrabench {

/// What each damage of damage.h must score, and whether the evaluator gives it. Counts of P and R
/// come from expectedCounts() over the centres, for every threshold, class and semantics; on top of
/// that, in closed form:
///
///  - empty: P undefined, R = 0. Twice: P = 1 under exists, 1/2 under one_to_one.
///  - merged: completeness of a pair with one of the parts is exactly 0, b_iou is the quotient of
///    the boxes' volumes.
///  - moved by v inside every gate: P = R = 1, b_iou of boxes of size s is
///    prod(s - |v|) / (2 prod(s) - prod(s - |v|)), every surface distance is at most |v|, and every
///    centre off by |v|. By 0.999 tau: P = R = 1 at that tau. Far: R = 0.
///  - inside out: P = R = 1, surface distances exactly 0; closed meshes are turned back, so their
///    v_iou_solid is exactly 1.
///  - not a number, millimetres: refused with one line.
/// The mistakes that submission_check.h looks for must be seen there as well, wherever the layout
/// can tell.
/// @param config   without intervals and jittered grids: only values matter
/// @param perfect  groundTruthPrediction() of the same truth
void checkDamaged(const Evaluator& evaluator, const EvaluationConfig& config,
                  const LabelSpace& label_space, const GroundTruth& truth,
                  const Prediction& perfect, const AddCheck& add);

}  // namespace hydrabench
