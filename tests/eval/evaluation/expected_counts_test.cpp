// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/expected_counts.h"

#include <gtest/gtest.h>

#include "core/types/random.h"
#include "metrics/matching.h"

namespace hydrabench {
namespace {

DetectionObject at(ObjectId id, double x, Label label = 5) {
  return {id, label, Eigen::Vector3d(x, 0, 0), 0.5};
}

TEST(ExpectedCounts, CountsBothSidesApartUnderExists) {
  const std::vector<DetectionObject> estimates = {at(0, 0.1), at(1, -0.1), at(2, 3)};
  const std::vector<DetectionObject> truths = {at(0, 0), at(1, 7)};
  const CountsByClass counts =
      expectedCounts(estimates, truths, Matching::kExists, Threshold::tau(0.2));
  EXPECT_EQ(counts.at(5), (DetectionCounts{3, 2, 2, 1}));
}

TEST(ExpectedCounts, MovesOthersAsideUnderOneToOne) {
  // Either truth would do for the first estimate, the second can have the first one only.
  const std::vector<DetectionObject> estimates = {at(0, 0.5), at(1, -0.4)};
  const std::vector<DetectionObject> truths = {at(0, 0), at(1, 1)};
  const CountsByClass counts =
      expectedCounts(estimates, truths, Matching::kOneToOne, Threshold::tau(0.6));
  EXPECT_EQ(counts.at(5), (DetectionCounts{2, 2, 2, 2}));
}

TEST(ExpectedCounts, AgreesWithTheMatcherOnCrowdedWorlds) {
  for (std::uint64_t world = 0; world < 200; ++world) {
    Random random(3, world);
    std::vector<DetectionObject> estimates;
    std::vector<DetectionObject> truths;
    for (ObjectId i = 0; i < 14; ++i) {
      estimates.push_back(at(i, random.uniform(0, 4), static_cast<Label>(random.index(2))));
      truths.push_back(at(i, random.uniform(0, 4), static_cast<Label>(random.index(2))));
    }
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      for (const Threshold& threshold : {Threshold::tau(0.3), Threshold::kappa(0.8)}) {
        EXPECT_EQ(expectedCounts(estimates, truths, matching, threshold),
                  countsByClass(match(matching, estimates, truths, threshold), estimates, truths))
            << "world " << world << ", " << name(matching);
      }
    }
  }
}

}  // namespace
}  // namespace hydrabench
