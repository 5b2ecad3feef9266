// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// The prediction of a method that knows everything: every ground-truth object of an object class,
/// as it is. Named "ground_truth".
Prediction groundTruthPrediction(const LabelSpace& label_space, const GroundTruth& truth);

}  // namespace hydrabench
