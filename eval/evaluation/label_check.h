// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/evaluation/submission_check.h"

namespace hydrabench {

/// The topic "labels" of checkSubmission(), by the rule given there.
SubmissionFinding checkLabels(const LabelSpace& label_space, const GroundTruth& truth,
                              const Prediction& prediction);

}  // namespace hydrabench
