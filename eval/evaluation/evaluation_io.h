// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "eval/evaluation/evaluator.h"

namespace hydrabench {

/// What took time to find out, as JSON: objects and pair scores, to the last bit. Scores, curves
/// and rows are left out; rescore() makes them again, in the blink of an eye.
std::string evaluationJson(const MethodEvaluation& evaluation);

/// Throws InputError naming the file.
MethodEvaluation readEvaluation(const std::filesystem::path& path);

}  // namespace hydrabench
