// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace hydrabench {

/// What is drawn of a distribution as a violin (Hintze and Nelson, The American Statistician 1998).
struct ViolinShape {
  struct Width {
    double value = 0;
    double width = 0;  ///< density as a share of the greatest, in [0, 1]
  };
  std::vector<Width> outline;  ///< from the least value to the greatest
  double p25 = 0;
  double median = 0;
  double p75 = 0;
};

/// Density by a Gaussian kernel as wide as Silverman's rule says (1986, eq. 3.31: 0.9
/// min(deviation, interquartile range / 1.34) n^(-1/5)), cut off at the values themselves. With
/// `logarithmic`, that of the logarithms; all values above 0 then. Percentiles are nearest ranks.
/// nullopt for no values; equal values are a line of full width.
std::optional<ViolinShape> violinShape(std::vector<double> values, bool logarithmic);

}  // namespace hydrabench
