// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/pose_tokens.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;

LocalFrame anyFrame(Random random) {
  LocalFrame frame;
  for (int axis = 0; axis < 3; ++axis) frame.center[axis] = random.uniform(-4, 4);
  frame.bearing = random.uniform(-kPi, kPi);
  frame.scale = random.uniform(0.1, 3);
  return frame;
}

TEST(PoseTokens, GiveBackTheFrameTheyWereMadeOf) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const LocalFrame object = anyFrame(Random(i));
    const LocalFrame view = anyFrame(Random(i, 1));
    const LocalFrame back = fromPoseTokens(toPoseTokens(object, view), view);
    EXPECT_LE((back.center - object.center).norm(), 1e-5);
    EXPECT_NEAR(std::remainder(back.bearing - object.bearing, 2 * kPi), 0, 1e-6);
    EXPECT_NEAR(back.scale / object.scale, 1, 1e-6);
  }
}

TEST(PoseTokens, AreZeroButForTheRotationWhereTheFramesAgree) {
  const LocalFrame view = anyFrame(Random(3));
  const PoseTokens tokens = toPoseTokens(view, view);
  EXPECT_FLOAT_EQ(tokens.numbers[0], 1);
  for (std::size_t i = 1; i < tokens.numbers.size(); ++i) EXPECT_NEAR(tokens.numbers[i], 0, 1e-6);
}

TEST(PoseTokens, DoNotChangeWhenTheWorldTurnsAndGrowsWithTheView) {
  const LocalFrame object = anyFrame(Random(5));
  const LocalFrame view = anyFrame(Random(6));
  const auto moved = [](LocalFrame frame) {
    const double angle = 0.7;
    frame.center = 2 * (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * frame.center) +
                   Eigen::Vector3d(1, -2, 3);
    frame.bearing += angle;
    frame.scale *= 2;
    return frame;
  };
  const PoseTokens a = toPoseTokens(object, view);
  const PoseTokens b = toPoseTokens(moved(object), moved(view));
  for (std::size_t i = 0; i < a.numbers.size(); ++i) EXPECT_NEAR(a.numbers[i], b.numbers[i], 1e-5);
}

TEST(PoseTokens, OfAFlowThatWentAstrayStillMakeAFrame) {
  PoseTokens tokens;
  tokens.numbers.fill(1000);
  const LocalFrame frame = fromPoseTokens(tokens, LocalFrame());
  EXPECT_TRUE(std::isfinite(frame.scale) && frame.scale < 100);
  EXPECT_NEAR(frame.bearing, kPi / 4, 1e-6);  // cosine and sine of no unit length
}

}  // namespace
}  // namespace hydrabench
