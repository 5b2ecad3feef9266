// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"

namespace hydrabench {

/// One thing that must hold for any dataset, whatever it contains.
struct SelfTestCheck {
  std::string claim;
  bool passed = false;
  std::string detail;  ///< what was seen
};

struct SelfTestReport {
  std::vector<SelfTestCheck> checks;
  MethodEvaluation ground_truth;  ///< ground truth scored against itself

  bool passed() const;
};

/// Scores ground truth, and predictions made from it by known damage, against ground truth: the
/// right answer is known for each. Shows that measures, meshes and files of a dataset can be
/// trusted before a method is scored on it.
/// @param on_check  called after each check
SelfTestReport runSelfTest(const std::string& dataset_name, const std::string& seed,
                           const LabelSpace& label_space, const GroundTruth& truth,
                           const EvaluationConfig& config,
                           const std::function<void(const SelfTestCheck&)>& on_check = {});

}  // namespace hydrabench
