// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/evaluation/self_test_check.h"

namespace hydrabench {

struct SelfTestReport {
  std::vector<SelfTestCheck> checks;
  MethodEvaluation ground_truth;  ///< ground truth scored against itself

  bool passed() const;
};

/// Scores ground truth, and predictions made from it by known damage, against ground truth: the
/// right answer is known for each. Shows that measures, meshes and files of a dataset can be
/// trusted before a method is scored on it. damage_checks.h says what each damage must score.
/// @param shuffles  how often order and ids are drawn anew (order_check.h)
/// @param on_check  called after each check
SelfTestReport runSelfTest(const std::string& dataset_name, const std::string& seed,
                           const LabelSpace& label_space, const GroundTruth& truth,
                           const EvaluationConfig& config, std::size_t shuffles = 1,
                           const std::function<void(const SelfTestCheck&)>& on_check = {});

}  // namespace hydrabench
