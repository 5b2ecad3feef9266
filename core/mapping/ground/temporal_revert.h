// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/config/config_reader.h"
#include "core/mapping/ground/adaptive_thresholds.h"
#include "core/mapping/ground/patch_fit.h"

namespace hydrabench {

/// Patchwork++'s TGR: a second chance for upright patches that are too high and not flat enough for
/// the thresholds learned so far, by comparison with their own ring in this scan.
struct TemporalRevertConfig {
  bool enabled = true;
  double flatness_deviations = 1.5;  ///< mu = mean + this * deviation
  double max_line_ratio = 8;         ///< longer than that, a patch says nothing of a plane
  int dense_points = 1500;  ///< a patch of more points, flatter than thickness^2, needs no ring
  double min_probability = 0.5;
};
void read(ConfigReader& reader, TemporalRevertConfig& config);

/// Probability that a patch is ground, in [0, 1]: 1 / (1 + exp((f - mu) / (mu / 10))) of its
/// flatness f, 0 where it is a line, 1 where it is dense and flat. 0 also where mu is not known or
/// is 0.
/// @param ring         flatness of the patches of its ring in this scan that are upright and not
/// elevated
/// @param thickness_m  of the fit
double revertProbability(const Patch& patch, const std::optional<MeanDeviation>& ring,
                         double thickness_m, const TemporalRevertConfig& config);

}  // namespace hydrabench
