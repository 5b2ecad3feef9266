// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/flow_sampler.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(FollowFlow, EndsAtTheTargetOfAStraightFlowWhateverTheSteps) {
  // All data are one point: the velocity towards it is (target - x) / (1 - t), and paths are
  // straight, so that every number of steps is exact.
  const torch::Tensor target = torch::tensor({{2.0f, -1.0f, 0.5f}});
  const Velocity velocity = [&](const torch::Tensor& x, double t) {
    return (target - x) / (1 - t);
  };
  for (const int steps : {1, 4, 25}) {
    const torch::Tensor end = followFlow(velocity, normalNoise({1, 3}, 7), steps);
    EXPECT_LE((end - target).abs().max().item<double>(), 1e-5) << steps;
  }
}

TEST(FollowFlow, TurnsNoiseIntoANormalOfTheDataByItsMeanVelocity) {
  // Data N(m, s^2) and noise N(0, 1), independent: the mean velocity is linear in x, and the flow
  // carries the normal x_t with mean t m and variance (1 - t)^2 + t^2 s^2.
  const double m = 3;
  const double s = 0.5;
  const Velocity velocity = [&](const torch::Tensor& x, double t) {
    const double variance = (1 - t) * (1 - t) + t * t * s * s;
    return m + (t * s * s - (1 - t)) / variance * (x - t * m);
  };
  const torch::Tensor end = followFlow(velocity, normalNoise({20000}, 1), 200);
  EXPECT_NEAR(end.mean().item<double>(), m, 0.02);
  EXPECT_NEAR(end.std().item<double>(), s, 0.02);
}

TEST(FollowFlow, AsksAtTheBeginningOfEveryStep) {
  std::vector<double> times;
  followFlow(
      [&](const torch::Tensor& x, double t) {
        times.push_back(t);
        return torch::zeros_like(x);
      },
      torch::zeros({1}), 4);
  EXPECT_EQ(times, (std::vector{0.0, 0.25, 0.5, 0.75}));
}

TEST(GuidedVelocity, GoesFromTheOneWithoutThroughTheOneWithTheCondition) {
  const torch::Tensor with = torch::tensor({1.0f, 4.0f});
  const torch::Tensor without = torch::tensor({3.0f, 2.0f});
  EXPECT_TRUE(torch::equal(guidedVelocity(with, without, 0), without));
  EXPECT_TRUE(torch::equal(guidedVelocity(with, without, 1), with));
  EXPECT_TRUE(torch::equal(guidedVelocity(with, without, 2), torch::tensor({-1.0f, 6.0f})));
}

TEST(NormalNoise, IsAFunctionOfItsSeedAlone) {
  torch::manual_seed(1);
  const torch::Tensor a = normalNoise({4, 5}, 3);
  torch::rand({100});
  EXPECT_TRUE(torch::equal(a, normalNoise({4, 5}, 3)));
  EXPECT_FALSE(torch::equal(a, normalNoise({4, 5}, 4)));
  const torch::Tensor many = normalNoise({100000}, 5);
  EXPECT_NEAR(many.mean().item<double>(), 0, 0.02);
  EXPECT_NEAR(many.std().item<double>(), 1, 0.02);
}

}  // namespace
}  // namespace hydrabench
