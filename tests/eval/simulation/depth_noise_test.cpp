// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/depth_noise.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

const Camera kCamera = {320, 240, 415.7, 415.7, 160, 120};

RenderedView flatView(float depth, std::uint8_t incidence = 255) {
  RenderedView view;
  view.depth = Image<float>(kCamera.width, kCamera.height, depth);
  view.incidence = Image<std::uint8_t>(kCamera.width, kCamera.height, incidence);
  return view;
}

struct Statistics {
  double mean = 0;
  double deviation = 0;
  double lost = 0;
};
Statistics statisticsOf(const Image<float>& depth) {
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (const float z : depth) {
    if (z == 0) continue;
    sum += z;
    squares += static_cast<double>(z) * z;
    ++count;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean),
          1 - count / static_cast<double>(depth.size())};
}

TEST(DepthNoise, SwitchedOffChangesNothing) {
  const RenderedView view = flatView(2.345678f);
  EXPECT_EQ(noisyDepth(view, kCamera, DepthNoiseConfig::off(), 1), view.depth);
}

TEST(DepthNoise, DeviationFollowsTheModel) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.axial_constant_m = 0.001;
  config.axial_quadratic = 0.0015;
  for (const double correlated : {0.0, 0.5}) {
    config.correlated_share = correlated;
    for (const float z : {1.0f, 3.0f}) {
      const Statistics statistics = statisticsOf(noisyDepth(flatView(z), kCamera, config, 7));
      const double sigma = 0.001 + 0.0015 * z * z;  // 2.5 mm at 1 m, 14.5 mm at 3 m
      EXPECT_DOUBLE_EQ(axialSigma(config, z), sigma);
      // A correlation length of 6 px leaves some 2000 independent patches: the deviation is known
      // to about 2 %.
      EXPECT_NEAR(statistics.deviation, sigma, 0.05 * sigma);
      EXPECT_NEAR(statistics.mean, z, 0.1 * sigma);
      EXPECT_EQ(statistics.lost, 0);
    }
  }
}

TEST(DepthNoise, CorrelatedPartIsSharedByNeighbours) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.axial_constant_m = 0.01;
  config.correlation_px = 8;
  const auto correlation = [&](double share) {
    config.correlated_share = share;
    const Image<float> depth = noisyDepth(flatView(2), kCamera, config, 3);
    double product = 0;
    double square = 0;
    for (int v = 0; v < kCamera.height; ++v) {
      for (int u = 0; u + 1 < kCamera.width; ++u) {
        product += (depth(u, v) - 2.0) * (depth(u + 1, v) - 2.0);
        square += (depth(u, v) - 2.0) * (depth(u, v) - 2.0);
      }
    }
    return product / square;
  };
  EXPECT_NEAR(correlation(0), 0, 0.02);
  EXPECT_GT(correlation(1), 0.9);
}

TEST(DepthNoise, QuantisesToMultiplesOfTheQuantum) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.axial_constant_m = 0.01;
  config.quantum_m = 0.001;
  for (const float z : noisyDepth(flatView(2), kCamera, config, 1)) {
    EXPECT_NEAR(z * 1000, std::round(z * 1000), 1e-3);
  }
}

TEST(DepthNoise, DisparityStepsGrowWithTheSquareOfTheDepth) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.axial_constant_m = 0.05;
  config.disparity_step_px = 0.125;
  config.baseline_m = 0.075;
  // Steps of disparity per metre: z = 415.7 * 0.075 / 0.125 / n = 249.42 / n.
  std::vector<float> values;
  for (const float z : noisyDepth(flatView(3), kCamera, config, 1)) values.push_back(z);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  ASSERT_GT(values.size(), 3u);
  for (const float z : values) EXPECT_NEAR(249.42 / z, std::round(249.42 / z), 1e-3);
}

TEST(DepthNoise, LosesTheShareOfPixelsItIsTold) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.random_dropout = 0.1;
  // 76800 pixels: the share is known to 0.1 %.
  EXPECT_NEAR(statisticsOf(noisyDepth(flatView(2), kCamera, config, 1)).lost, 0.1, 0.005);
}

TEST(DepthNoise, GrazingSurfacesAreLostMoreTheFlatterTheyAreSeen) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.grazing_start_deg = 60;  // cosine 0.5
  const auto lost = [&](double cosine) {
    const auto incidence = static_cast<std::uint8_t>(std::lround(255 * cosine));
    return statisticsOf(noisyDepth(flatView(2, incidence), kCamera, config, 1)).lost;
  };
  EXPECT_EQ(lost(0.6), 0);
  EXPECT_NEAR(lost(0.25), 0.5, 0.02);
  EXPECT_NEAR(lost(0.1), 0.8, 0.02);
}

TEST(DepthNoise, DropsPixelsBesideDepthEdgesOnly) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.edge_dropout = 1;
  config.edge_radius_px = 2;
  RenderedView view = flatView(2);
  for (int v = 0; v < kCamera.height; ++v) {
    for (int u = 160; u < kCamera.width; ++u) view.depth(u, v) = 3;
  }
  const Image<float> depth = noisyDepth(view, kCamera, config, 1);
  for (int u = 0; u < kCamera.width; ++u) EXPECT_EQ(depth(u, 100) == 0, u >= 158 && u < 162) << u;
}

TEST(DepthNoise, LateralJitterMixesBothSidesOfAnEdge) {
  DepthNoiseConfig config = DepthNoiseConfig::off();
  config.lateral_px = 1;
  RenderedView view = flatView(2);
  for (int v = 0; v < kCamera.height; ++v) {
    for (int u = 160; u < kCamera.width; ++u) view.depth(u, v) = 3;
  }
  const Image<float> depth = noisyDepth(view, kCamera, config, 1);
  int far = 0;
  for (int v = 10; v < 230; ++v) {
    far += depth(159, v) == 3 ? 1 : 0;
    EXPECT_EQ(depth(150, v), 2);
  }
  // The neighbour is taken where the offset rounds to 1 or more: with sigma 1 in 31 % of all cases.
  EXPECT_NEAR(far / 220.0, 0.31, 0.12);
}

TEST(DepthNoise, IsAFunctionOfTheSeedForAnyNumberOfThreads) {
  const RenderedView view = flatView(2);
  setNumThreads(1);
  const Image<float> one = noisyDepth(view, kCamera, {}, 5);
  setNumThreads(7);
  EXPECT_EQ(noisyDepth(view, kCamera, {}, 5), one);
  setNumThreads(0);
  EXPECT_NE(noisyDepth(view, kCamera, {}, 6), one);
}

TEST(ColorNoise, HasTheDeviationItIsTold) {
  Image<Rgb> color(200, 200, Rgb{128, 128, 128});
  addColorNoise(4, 1, color);
  double sum = 0;
  double squares = 0;
  for (const Rgb& pixel : color) {
    for (const double value : {pixel.r, pixel.g, pixel.b}) {
      sum += value - 128;
      squares += (value - 128) * (value - 128);
    }
  }
  EXPECT_NEAR(sum / 120000, 0, 0.05);
  // Rounding to whole levels adds a variance of 1/12.
  EXPECT_NEAR(std::sqrt(squares / 120000), std::sqrt(16 + 1.0 / 12), 0.05);
}

}  // namespace
}  // namespace hydrabench
