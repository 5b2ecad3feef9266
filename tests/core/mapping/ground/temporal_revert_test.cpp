// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/temporal_revert.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr double kThickness = 0.125;
const std::optional<MeanDeviation> kRing = MeanDeviation{0.001, 0.0004};  // mu = 0.0016

Patch patchOf(double flatness, std::size_t count = 100, double line_ratio = 2) {
  Patch patch;
  patch.plane.variances = {line_ratio, 1, flatness};
  patch.points.resize(count);
  return patch;
}

TEST(TemporalRevert, ComparesAPatchWithItsRing) {
  EXPECT_DOUBLE_EQ(revertProbability(patchOf(0.0016), kRing, kThickness, {}), 0.5);
  // One tenth of mu above: 1 / (1 + e).
  EXPECT_NEAR(revertProbability(patchOf(0.00176), kRing, kThickness, {}), 1 / (1 + std::exp(1)),
              1e-9);
  EXPECT_GT(revertProbability(patchOf(0.0010), kRing, kThickness, {}), 0.97);
}

TEST(TemporalRevert, ALineIsNoGround) {
  EXPECT_GT(revertProbability(patchOf(0.0001, 100, 8), kRing, kThickness, {}), 0.5);
  EXPECT_EQ(revertProbability(patchOf(0.0001, 100, 8.1), kRing, kThickness, {}), 0);
  EXPECT_EQ(revertProbability(patchOf(0.0001, 2000, 8.1), kRing, kThickness, {}), 0);
}

TEST(TemporalRevert, ADensePatchNeedsNoRing) {
  EXPECT_EQ(revertProbability(patchOf(0.0156, 1501), kRing, kThickness, {}), 1);
  EXPECT_EQ(revertProbability(patchOf(0.0156, 1501), std::nullopt, kThickness, {}), 1);
  EXPECT_LT(revertProbability(patchOf(0.0156, 1500), kRing, kThickness, {}), 0.01);
  EXPECT_LT(revertProbability(patchOf(0.0157, 1501), kRing, kThickness, {}), 0.01);
}

TEST(TemporalRevert, WithoutARingNothingIsReverted) {
  EXPECT_EQ(revertProbability(patchOf(0), std::nullopt, kThickness, {}), 0);
  EXPECT_EQ(revertProbability(patchOf(0), MeanDeviation{0, 0}, kThickness, {}), 0);
}

}  // namespace
}  // namespace hydrabench
