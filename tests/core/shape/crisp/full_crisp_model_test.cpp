// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/full_crisp_model.h"

#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/crisp_estimator.h"
#include "tests/core/shape/crisp/ball_view.h"

namespace hydrabench {
namespace {

/// The published network, but tiny and with random weights.
CrispNetwork tinyNetwork() {
  torch::manual_seed(4);
  CrispNetworkImpl::Options options;
  options.vit = {.dim = 16, .depth = 4, .heads = 2, .patch = 14, .grid = 4};
  options.taps = {0, 1, 2, 3};
  options.head = {.dim = 16,
                  .tap_channels = {8, 8, 16, 16},
                  .channels = 16,
                  .head_channels = 8,
                  .last_channels = 8};
  options.code_width = 32;
  options.decoder = {.layers = 2, .width = 16, .residual_gain = false, .first_range = 10};
  options.input_side = 56;
  return CrispNetwork(options);
}

TEST(FullCrispModel, RunsFromColorsToAnOutcomeThatDoesNotDependOnThreads) {
  CrispManifest manifest;
  manifest.mode = "normalised";
  CrispEstimator::Config config;
  config.pose.min_inlier_ratio = 0;
  config.pose.threshold = config.pose.final_threshold = 1;
  config.min_size_m = 1e-4;
  config.max_size_m = 1e3;
  const CrispEstimator estimator(makeFullCrisp(tinyNetwork(), manifest, "cpu"), config);
  const ShapeObservation view = viewOfABall();
  setNumThreads(1);
  const ShapeOutcome alone = estimator.estimate(view, {}, 1);
  setNumThreads(3);
  std::vector<ShapeOutcome> together(6);
  parallelFor(together.size(),
              [&](std::size_t i) { together[i] = estimator.estimate(view, {}, 1); });
  setNumThreads(0);
  EXPECT_EQ(alone.estimate.has_value(), alone.failure.empty());
  for (const ShapeOutcome& outcome : together) {
    EXPECT_EQ(outcome.failure, alone.failure);
    ASSERT_EQ(outcome.estimate.has_value(), alone.estimate.has_value());
    if (!alone.estimate) continue;
    EXPECT_EQ(outcome.estimate->mesh.vertices, alone.estimate->mesh.vertices);
    EXPECT_EQ(outcome.estimate->scale, alone.estimate->scale);
  }
}

TEST(FullCrispModel, WithWeightsThatAreNotFiniteFails) {
  CrispNetwork network = tinyNetwork();
  {
    const torch::NoGradGuard no_grad;
    network->named_parameters()["backbone.patch_embed.proj.bias"].fill_(
        std::numeric_limits<float>::quiet_NaN());
  }
  const CrispEstimator estimator(makeFullCrisp(network, CrispManifest{}, "cpu"), {});
  const ShapeOutcome outcome = estimator.estimate(viewOfABall(), {}, 1);
  EXPECT_FALSE(outcome.estimate);
  EXPECT_EQ(outcome.failure, "network output is not finite");
}

}  // namespace
}  // namespace hydrabench
