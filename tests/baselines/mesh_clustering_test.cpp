// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/mesh_clustering.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Points = std::vector<Eigen::Vector3d>;

TEST(EuclideanClusters, JoinPointsOverAChainOfSteps) {
  // Two at the far end of a chain are much farther apart than the radius.
  const Points points = {{0, 0, 0}, {9, 0, 0}, {0.2, 0, 0}, {0.4, 0, 0}, {9.2, 0, 0}};
  EXPECT_THAT(euclideanClusters(points, 0.25),
              ElementsAre(ElementsAre(0, 2, 3), ElementsAre(1, 4)));
}

TEST(EuclideanClusters, CountAStepOfExactlyTheRadius) {
  EXPECT_THAT(euclideanClusters(Points{{0, 0, 0}, {0, 0.25, 0}}, 0.25),
              ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(euclideanClusters(Points{{0, 0, 0}, {0, 0.2500001, 0}}, 0.25),
              ElementsAre(ElementsAre(0), ElementsAre(1)));
}

TEST(EuclideanClusters, OfNothingAreNone) {
  EXPECT_THAT(euclideanClusters(Points{}, 0.25), IsEmpty());
}

/// Every pair is looked at, until nothing changes.
std::vector<std::vector<std::uint32_t>> plainClusters(const Points& points, double radius) {
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) first[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        if ((points[i] - points[j]).squaredNorm() > radius * radius || first[j] <= first[i]) {
          continue;
        }
        first[j] = first[i];
        changed = true;
      }
    }
  }
  std::vector<std::vector<std::uint32_t>> clusters;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    auto& cluster = first[i] == i
                        ? clusters.emplace_back()
                        : *std::find_if(clusters.begin(), clusters.end(),
                                        [&](const auto& c) { return c.front() == first[i]; });
    cluster.push_back(i);
  }
  return clusters;
}

TEST(EuclideanClusters, AgreeWithEveryPairTried) {
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    Points points;
    for (int i = 0; i < 300; ++i) {
      points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    }
    const double radius = random.uniform(0.1, 0.35);
    EXPECT_EQ(euclideanClusters(points, radius), plainClusters(points, radius));
  }
}

}  // namespace
}  // namespace hydrabench
