// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"

namespace hydrabench {

/// A row per estimate and per missed ground-truth object, threshold and matching (docs/metrics.md).
std::string objectsCsv(const std::vector<MethodEvaluation>& evaluations);

/// What objects.csv tells of each dataset, seed and method: the objects that count, and the scores
/// of pairs matched one_to_one; enough to match and compare again. Rows of several worlds together
/// (seed "pooled") are left out. Throws InputError naming file and line.
std::vector<MethodEvaluation> readObjectsCsv(const std::filesystem::path& path);

}  // namespace hydrabench
