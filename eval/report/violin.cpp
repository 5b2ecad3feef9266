// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/violin.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hydrabench {
namespace {

constexpr int kSteps = 80;  ///< of an outline

double rank(const std::vector<double>& ascending, double share) {
  const double position = std::ceil(share * static_cast<double>(ascending.size()));
  return ascending[static_cast<std::size_t>(std::max(1.0, position)) - 1];
}

double bandwidth(const std::vector<double>& ascending) {
  const auto n = static_cast<double>(ascending.size());
  double mean = 0;
  for (const double value : ascending) mean += value / n;
  double variance = 0;
  for (const double value : ascending) variance += (value - mean) * (value - mean) / n;
  const double quartiles = rank(ascending, 0.75) - rank(ascending, 0.25);
  const double deviation = std::sqrt(variance);
  const double spread = quartiles > 0 ? std::min(deviation, quartiles / 1.34) : deviation;
  return 0.9 * spread * std::pow(n, -0.2);
}

double density(const std::vector<double>& values, double x, double width) {
  double sum = 0;
  for (const double value : values) {
    const double z = (x - value) / width;
    sum += std::exp(-0.5 * z * z);
  }
  return sum;
}

}  // namespace

std::optional<ViolinShape> violinShape(std::vector<double> values, bool logarithmic) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  assert(!logarithmic || values.front() > 0);
  ViolinShape shape;
  shape.p25 = rank(values, 0.25);
  shape.median = rank(values, 0.5);
  shape.p75 = rank(values, 0.75);
  if (values.front() == values.back()) {
    shape.outline = {{values.front(), 1}};
    return shape;
  }
  if (logarithmic) {
    for (double& value : values) value = std::log(value);
  }
  const double width = bandwidth(values);
  double densest = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = values.front() + (values.back() - values.front()) * i / kSteps;
    const double at = density(values, x, width);
    densest = std::max(densest, at);
    shape.outline.push_back({logarithmic ? std::exp(x) : x, at});
  }
  for (ViolinShape::Width& at : shape.outline) at.width /= densest;
  return shape;
}

}  // namespace hydrabench
