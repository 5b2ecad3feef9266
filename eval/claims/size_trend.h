// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "eval/report/matched_method.h"

namespace hydrabench {

/// How much worse (or better) a pair score gets with how far the size of an object is from what is
/// usual in its class: slope of the score over |ln(d / geometric mean of d in the class)|, d the
/// half diagonal, by least squares over the objects found, each class with a level of its own. Unit
/// of the score per e-fold. With `b` the slope of `a` less that of `b`. Undefined where sizes do
/// not vary.
std::optional<PairedComparison> sizeTrend(const MatchedMethod& a, const MatchedMethod* b,
                                          const PairScoreColumn& column,
                                          const BootstrapConfig& config);

}  // namespace hydrabench
