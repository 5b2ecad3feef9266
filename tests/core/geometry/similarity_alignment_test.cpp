// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/similarity_alignment.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d drawPoint(Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  return {x, y, random.normal()};
}

Points drawPoints(std::size_t count, std::uint64_t seed) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, i);
    points.push_back(drawPoint(random));
  }
  return points;
}

Similarity knownSimilarity(double scale = 0.37) {
  Similarity similarity;
  similarity.scale = scale;
  similarity.T_target_source.linear() =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  similarity.T_target_source.translation() = Eigen::Vector3d{10, -20, 3};
  return similarity;
}

Points mapped(const Similarity& similarity, const Points& points) {
  Points result;
  for (const Eigen::Vector3d& p : points) result.push_back(similarity(p));
  return result;
}

void expectEqual(const Similarity& a, const Similarity& b, double tolerance) {
  EXPECT_NEAR(a.scale, b.scale, tolerance);
  EXPECT_TRUE(a.T_target_source.matrix().isApprox(b.T_target_source.matrix(), tolerance));
}

TEST(AlignSimilarity, RecoversAKnownSimilarity) {
  const Points source = drawPoints(50, 1);
  const auto found = alignSimilarity(source, mapped(knownSimilarity(), source));
  ASSERT_TRUE(found);
  expectEqual(*found, knownSimilarity(), 1e-13);
}

TEST(AlignSimilarity, RecoversItFromThreePointsAndFromAPlane) {
  const Points three = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const auto from_three = alignSimilarity(three, mapped(knownSimilarity(), three));
  ASSERT_TRUE(from_three);
  expectEqual(*from_three, knownSimilarity(), 1e-13);
}

TEST(AlignSimilarity, KeepsTheScaleOnRequest) {
  const Points source = drawPoints(50, 2);
  const auto rigid = alignSimilarity(source, mapped(knownSimilarity(1), source), false);
  ASSERT_TRUE(rigid);
  expectEqual(*rigid, knownSimilarity(1), 1e-13);
  EXPECT_EQ(alignSimilarity(source, mapped(knownSimilarity(2), source), false)->scale, 1);
}

TEST(AlignSimilarity, NeverMirrors) {
  const Points source = drawPoints(50, 3);
  Points mirrored = source;
  for (Eigen::Vector3d& p : mirrored) p.z() = -p.z();
  const auto found = alignSimilarity(source, mirrored);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->T_target_source.linear().determinant(), 1, 1e-12);
}

TEST(AlignSimilarity, IsUndefinedForTooFewPointsALineOrNan) {
  const Points two = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(alignSimilarity(two, two));
  const Points line = {{0.1, 0.2, 0.3}, {1.1, 2.2, 3.3}, {2.1, 4.2, 6.3}, {4.1, 8.2, 12.3}};
  EXPECT_FALSE(alignSimilarity(line, line));
  const Points same(5, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(alignSimilarity(same, same));
  Points broken = drawPoints(5, 4);
  broken[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(alignSimilarity(broken, drawPoints(5, 4)));
}

class RobustAlignmentTest : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(OutlierPercent, RobustAlignmentTest, ::testing::Values(0, 30, 50));

TEST_P(RobustAlignmentTest, RecoversAKnownSimilarityAmongOutliers) {
  const Points source = drawPoints(200, 5);
  Points target = mapped(knownSimilarity(), source);
  std::vector<std::size_t> inliers;
  for (std::size_t i = 0; i < target.size(); ++i) {
    Random random(6, i);
    if (static_cast<int>(i % 100) < GetParam())
      target[i] += 3 * drawPoint(random) + Eigen::Vector3d(1, 1, 1);
    else
      inliers.push_back(i);
  }
  const auto found = alignSimilarityRobust(source, target, 0.01, 200, 1);
  ASSERT_TRUE(found);
  expectEqual(found->similarity, knownSimilarity(), 1e-9);
  EXPECT_EQ(found->inliers, inliers);
}

TEST_P(RobustAlignmentTest, AveragesNoiseOverAllInliers) {
  const Points source = drawPoints(400, 7);
  Points target = mapped(knownSimilarity(), source);
  for (std::size_t i = 0; i < target.size(); ++i) {
    Random random(8, i);
    target[i] += 0.005 * drawPoint(random);
    if (static_cast<int>(i % 100) < GetParam())
      target[i] += 3 * drawPoint(random) + Eigen::Vector3d(1, 1, 1);
  }
  const auto found = alignSimilarityRobust(source, target, 0.03, 200, 1);
  ASSERT_TRUE(found);
  expectEqual(found->similarity, knownSimilarity(), 2e-3);
}

TEST(RobustAlignment, IsAFunctionOfTheSeed) {
  const Points source = drawPoints(60, 9);
  Points target = mapped(knownSimilarity(), source);
  for (std::size_t i = 0; i < 25; ++i) target[i] += Eigen::Vector3d(1, 2, 3);
  const auto first = alignSimilarityRobust(source, target, 0.01, 50, 3);
  const auto second = alignSimilarityRobust(source, target, 0.01, 50, 3);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->similarity.T_target_source.matrix(),
            second->similarity.T_target_source.matrix());
  EXPECT_EQ(first->inliers, second->inliers);
}

TEST(RobustAlignment, IsUndefinedWhereNoThreePointsAgree) {
  EXPECT_FALSE(alignSimilarityRobust(Points(2), Points(2), 0.1, 10, 1));
  const Points line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_FALSE(alignSimilarityRobust(line, line, 0.1, 50, 1));
}

}  // namespace
}  // namespace hydrabench
