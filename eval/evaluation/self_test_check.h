// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "eval/evaluation/evaluator.h"

namespace hydrabench {

/// One thing that must hold for any dataset, whatever it contains.
struct SelfTestCheck {
  std::string claim;
  bool passed = false;
  std::string detail;  ///< what was seen
};

/// Takes each check as it is done.
/// @param fault  what is wrong; empty: passed
/// @param seen   what to say of a check that passed
using AddCheck = std::function<void(const std::string& claim, const std::string& fault,
                                    const std::string& seen)>;

/// Rows of a metric that are not `expected`, as "n of m, e.g. ..."; empty if all are. No such rows
/// are a fault.
/// @param matching  empty: both
/// @param tau_m     only rows of this tau; nullopt: of every threshold
std::string wrongRows(const MethodEvaluation& evaluation, const std::string& metric,
                      const std::string& matching, std::optional<double> expected,
                      std::optional<double> tau_m = std::nullopt);

}  // namespace hydrabench
