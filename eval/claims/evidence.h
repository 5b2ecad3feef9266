// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "eval/evaluation/score_row.h"
#include "eval/experiment/timing.h"

namespace hydrabench {

/// What result folders tell about one dataset in one of them.
struct Evidence {
  std::string result;   ///< folder, as given
  std::string dataset;  ///< its name there
  std::size_t num_worlds = 0;
  /// By method, all its worlds together; only methods that have every world.
  std::map<std::string, MethodEvaluation> methods;
  std::vector<ScoreRow> scores;   ///< pooled where there are several worlds
  std::vector<TimingRow> timing;  ///< world by world

  /// Whether anything is known of a method here.
  bool has(const std::string& method) const;
};

/// One per dataset and result, in the order given. Throws InputError where a folder is no result of
/// run or evaluate.
std::vector<Evidence> readEvidence(const std::vector<std::filesystem::path>& results);

}  // namespace hydrabench
