// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/evaluation/evaluator.h"

namespace hydrabench {

/// Says on standard error what a table does not show of a prediction: objects left out, objects
/// without a mesh.
void printRemarks(const MethodEvaluation& method);

}  // namespace hydrabench
