// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/nocs_pose.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A camera that looks 20 degrees down and is rolled by 5: where the world's up points in it.
Eigen::Vector3d upInCamera() {
  return Eigen::AngleAxisd(0.09, Eigen::Vector3d::UnitZ()) *
         (Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitX()) * -Eigen::Vector3d::UnitY());
}

/// Object coordinates on the three visible sides of a box.
Points visibleSides(std::size_t count, std::uint64_t seed) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, i);
    Eigen::Vector3d p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(-1, 1);
    p[static_cast<int>(i % 3)] = 1;
    points.push_back(p.cwiseProduct(Eigen::Vector3d(0.6, 0.4, 1)));
  }
  return points;
}

Eigen::Vector3d anyVector(Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  return {x, y, random.normal()};
}

Similarity truePose(NocsFreedom freedom) {
  Similarity pose;
  pose.scale = freedom == NocsFreedom::kRigid ? 1 : 0.47;
  const Eigen::Quaterniond level =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), upInCamera());
  pose.T_target_source.linear() =
      freedom == NocsFreedom::kUpright
          ? (level * Eigen::AngleAxisd(2.2, Eigen::Vector3d::UnitZ())).toRotationMatrix()
          : Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  pose.T_target_source.translation() = Eigen::Vector3d(0.3, -0.2, 2.5);
  return pose;
}

Points placed(const Similarity& pose, const Points& nocs) {
  Points points;
  for (const Eigen::Vector3d& p : nocs) points.push_back(pose(p));
  return points;
}

/// Moves `percent` of the points elsewhere.
void spoil(Points& points, int percent) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    Random random(77, i);
    if (static_cast<int>(i % 100) < percent) points[i] += anyVector(random);
  }
}

void expectPose(const std::optional<NocsPose>& found, const Similarity& expected,
                double tolerance) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->similarity.scale, expected.scale, tolerance);
  EXPECT_LE((found->similarity.T_target_source.matrix() - expected.T_target_source.matrix())
                .cwiseAbs()
                .maxCoeff(),
            tolerance);
}

class NocsPoseTest : public ::testing::TestWithParam<NocsFreedom> {
 protected:
  std::optional<NocsPose> solve(const Points& nocs, const Points& points,
                                std::uint64_t seed = 1) const {
    return solveNocsPose(nocs, points, GetParam(), upInCamera(), NocsPoseConfig{}, seed);
  }
  Similarity pose() const { return truePose(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Freedoms, NocsPoseTest,
                         ::testing::Values(NocsFreedom::kSimilarity, NocsFreedom::kRigid,
                                           NocsFreedom::kUpright));

TEST_P(NocsPoseTest, IsExactWithoutNoise) {
  const Points nocs = visibleSides(200, 1);
  const auto found = solve(nocs, placed(pose(), nocs));
  expectPose(found, pose(), 1e-9);
  EXPECT_EQ(found->inlier_ratio, 1);
}

TEST_P(NocsPoseTest, IsExactFromTheSmallestSample) {
  const Points nocs = visibleSides(5, 2);
  expectPose(solve(nocs, placed(pose(), nocs)), pose(), 1e-9);
}

TEST_P(NocsPoseTest, IsExactWhereFourInTenPointsAreWrong) {
  const Points nocs = visibleSides(400, 3);
  Points points = placed(pose(), nocs);
  spoil(points, 40);
  NocsPoseConfig config;
  config.final_threshold = 1e-3;  // no wrong point comes that near
  const auto found = solveNocsPose(nocs, points, GetParam(), upInCamera(), config, 1);
  expectPose(found, pose(), 1e-9);
  EXPECT_NEAR(found->inlier_ratio, 0.6, 1e-12);
}

TEST_P(NocsPoseTest, HoldsAgainstWildObjectCoordinates) {
  Points nocs = visibleSides(400, 4);
  const Points points = placed(pose(), nocs);
  for (std::size_t i = 0; i < nocs.size(); i += 10) nocs[i] *= 1e4;
  NocsPoseConfig config;
  config.final_threshold = 1e-3;
  const auto found = solveNocsPose(nocs, points, GetParam(), upInCamera(), config, 1);
  expectPose(found, pose(), 1e-9);
}

TEST_P(NocsPoseTest, AveragesNoise) {
  const Points nocs = visibleSides(400, 5);
  Points points = placed(pose(), nocs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Random random(6, i);
    points[i] += 0.01 * anyVector(random);
  }
  spoil(points, 20);
  expectPose(solve(nocs, points), pose(), 0.01);
}

TEST_P(NocsPoseTest, IsAFunctionOfTheSeed) {
  const Points nocs = visibleSides(300, 7);
  Points points = placed(pose(), nocs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Random random(8, i);
    points[i] += 0.03 * anyVector(random);
  }
  spoil(points, 40);
  const auto first = solve(nocs, points, 3);
  const auto second = solve(nocs, points, 3);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->similarity.T_target_source.matrix(),
            second->similarity.T_target_source.matrix());
  EXPECT_EQ(first->similarity.scale, second->similarity.scale);
}

TEST_P(NocsPoseTest, NeverMirrors) {
  const Points nocs = visibleSides(200, 9);
  Points mirrored = nocs;
  for (Eigen::Vector3d& p : mirrored) p.x() = -p.x();
  NocsPoseConfig config;
  config.final_threshold = 0.5;  // so that something is found
  config.threshold = 0.5;
  const auto found =
      solveNocsPose(nocs, placed(pose(), mirrored), GetParam(), upInCamera(), config, 1);
  ASSERT_TRUE(found);
  EXPECT_GT(found->similarity.scale, 0);
  EXPECT_NEAR(found->similarity.T_target_source.linear().determinant(), 1, 1e-12);
}

TEST_P(NocsPoseTest, IsUndefinedForTooFewPoints) {
  const Points nocs = visibleSides(4, 10);
  EXPECT_FALSE(solve(nocs, placed(pose(), nocs)));
  EXPECT_FALSE(solve({}, {}));
}

TEST_P(NocsPoseTest, IsUndefinedOnALineThatLeavesARotationOpen) {
  Points nocs;
  for (int i = 0; i < 50; ++i) nocs.emplace_back(0.1, 0.2, 0.03 * i - 0.7);
  EXPECT_FALSE(solve(nocs, placed(pose(), nocs)));
}

TEST_P(NocsPoseTest, DrawsSamplesAgainThatLeaveThePoseOpen) {
  Points nocs = visibleSides(200, 16);
  for (std::size_t i = 10; i < nocs.size(); ++i) {  // a sample is on this line three times in four
    nocs[i] = Eigen::Vector3d(0.1, 0.2, 0.005 * static_cast<double>(i) - 0.5);
  }
  NocsPoseConfig config;
  config.max_iterations = 3;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    expectPose(solveNocsPose(nocs, placed(pose(), nocs), GetParam(), upInCamera(), config, seed),
               pose(), 1e-9);
  }
}

TEST_P(NocsPoseTest, IsUndefinedWhereAllPointsAreOne) {
  const Points different = visibleSides(50, 11);
  const Points same(50, Eigen::Vector3d(0.1, 0.2, 2));
  EXPECT_FALSE(solve(same, same));
  EXPECT_FALSE(solve(different, same));
  EXPECT_FALSE(solve(same, different));
}

TEST_P(NocsPoseTest, IsUndefinedForValuesThatAreNotFinite) {
  const Points nocs = visibleSides(50, 12);
  EXPECT_FALSE(solve(nocs, Points(50, Eigen::Vector3d::Constant(kNan))));
  EXPECT_FALSE(solve(Points(50, Eigen::Vector3d::Constant(kNan)), nocs));
  Points one_wrong = placed(pose(), nocs);
  one_wrong[17].y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(solve(nocs, one_wrong));
}

TEST_P(NocsPoseTest, IsUndefinedWhereTooFewPointsAgree) {
  const Points nocs = visibleSides(200, 13);
  Points points;
  for (std::size_t i = 0; i < nocs.size(); ++i) {
    Random random(14, i);
    points.push_back(anyVector(random));
  }
  EXPECT_FALSE(solve(nocs, points));
}

TEST(NocsPoseUpright, IsExactOnALevelLine) {
  Points nocs;
  for (int i = 0; i < 50; ++i) nocs.emplace_back(0.03 * i - 0.7, 0.2, 0.1);
  const Similarity pose = truePose(NocsFreedom::kUpright);
  expectPose(solveNocsPose(nocs, placed(pose, nocs), NocsFreedom::kUpright, upInCamera(),
                           NocsPoseConfig{}, 1),
             pose, 1e-9);
}

TEST(NocsPoseUpright, StaysUprightWhereThePointsAreNot) {
  const Points nocs = visibleSides(200, 15);
  const auto found =
      solveNocsPose(nocs, placed(truePose(NocsFreedom::kSimilarity), nocs), NocsFreedom::kUpright,
                    upInCamera(), {.threshold = 1, .final_threshold = 1}, 1);
  ASSERT_TRUE(found);
  EXPECT_LE((found->similarity.T_target_source.linear().col(2) - upInCamera()).norm(), 1e-12);
}

}  // namespace
}  // namespace hydrabench
