// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "metrics/detection.h"

namespace hydrabench {

/// Counts at every kappa at once. A pair opens at kappa = distance / d_diag, so counts are step
/// functions of kappa; they are kept exactly, by the kappas at which one changes, and sampled only
/// for a plot.
struct KappaSweep {
  /// `counts` hold for all kappas in (kappa, next kappa]: a threshold is strict, so the step itself
  /// is still outside.
  struct Step {
    double kappa = 0;
    DetectionCounts counts;
    friend bool operator==(const Step&, const Step&) = default;
  };
  Matching matching = Matching::kExists;
  std::vector<Step> steps;  ///< ascending; the first at 0. From the last on, nothing changes

  DetectionCounts at(double kappa) const;
};

/// All steps, up to the kappa that opens the last pair. Equal to matching anew at every kappa.
KappaSweep sweepKappa(std::span<const DetectionObject> estimates,
                      std::span<const DetectionObject> truths, Matching matching);

/// Exact integral of F1(kappa) over [0, kappa_max]; divide by kappa_max for the mean. No unit, [0,
/// kappa_max], higher is better. Both sets empty: undefined. Over classes (macro): the mean of the
/// areas, because the integral is linear.
std::optional<double> areaUnderF1(const KappaSweep& sweep, double kappa_max);

struct KappaSample {
  double kappa = 0;
  DetectionCounts counts;
};
/// `count` samples at even spacing over [0, kappa_max], both ends included. At least 2.
std::vector<KappaSample> sampled(const KappaSweep& sweep, double kappa_max, std::size_t count);

}  // namespace hydrabench
