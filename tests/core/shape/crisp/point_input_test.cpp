// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/point_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "tests/core/shape/crisp/toy_points.h"

namespace hydrabench {
namespace {

using Input = PointInput;

Eigen::Vector3f point(const Input& input, std::size_t i) {
  const float* values = &input.points[i * Input::kFeatures];
  return {values[0], values[1], values[2]};
}

ObjectPoints turned(ObjectPoints points, double angle) {
  const Eigen::Matrix3f R =
      Eigen::AngleAxisf(static_cast<float>(angle), Eigen::Vector3f::UnitZ()).toRotationMatrix();
  for (Eigen::Vector3f& p : points.object) p = R * p;
  for (Eigen::Vector3f& p : points.context) p = R * p;
  return points;
}

TEST(LocalFrame, GoesThereAndBack) {
  const LocalFrame frame{{1, -2, 0.5}, 0.7, 0.4};
  const Eigen::Vector3d p(3, 4, -1);
  EXPECT_LT((frame.toLevel(frame.toLocal(p)) - p).norm(), 1e-12);
  EXPECT_LT(frame.toLocal(frame.center).norm(), 1e-12);
  // One unit along its x axis is 0.4 m in the direction of the bearing.
  const Eigen::Vector3d ahead =
      frame.center + 0.4 * Eigen::Vector3d(std::cos(0.7), std::sin(0.7), 0);
  EXPECT_LT((frame.toLocal(ahead) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(PointInput, XPointsFromTheCameraToTheObject) {
  const Input input = *makePointInput(toyPoints(501), 1);
  const Eigen::Vector3d camera = input.frame.toLocal(Eigen::Vector3d::Zero());
  EXPECT_NEAR(camera.y(), 0, 1e-9);
  EXPECT_LT(camera.x(), -2);
  EXPECT_NEAR(input.frame.bearing, std::atan2(0.6, 2), 0.03);
}

TEST(PointInput, TheScaleIsTheExtentOfMostPoints) {
  ObjectPoints points = toyPoints(500);
  for (Eigen::Vector3f& p : points.object) p.y() = 0;  // a strip of 0.8 m along the bearing
  const double scale = makePointInput(points, 1)->frame.scale;
  EXPECT_NEAR(scale, 0.9 * 0.8, 0.03);
  points.object.back() = {40, 0, 0};
  EXPECT_NEAR(makePointInput(points, 1)->frame.scale, scale, 0.01);
}

TEST(PointInput, IndicesAreInRangeAndWeightsAddUpToOne) {
  for (const std::size_t count : {std::size_t{5}, std::size_t{100}, std::size_t{768}}) {
    const Input input = *makePointInput(toyPoints(count), 1);
    ASSERT_EQ(input.points.size(), std::size_t{Input::kPoints * Input::kFeatures});
    ASSERT_EQ(input.patches.size(), std::size_t{Input::kTokens * Input::kPatch});
    ASSERT_EQ(input.near.size(), std::size_t{Input::kObjectPoints * Input::kNear});
    ASSERT_EQ(input.near_weights.size(), input.near.size());
    ASSERT_EQ(input.source.size(), std::size_t{Input::kObjectPoints});
    for (const float value : input.points) EXPECT_TRUE(std::isfinite(value));
    for (const float value : input.globals) EXPECT_TRUE(std::isfinite(value));
    for (std::size_t i = 0; i < input.patches.size(); ++i) {
      const bool object = i < std::size_t{Input::kObjectTokens * Input::kPatch};
      EXPECT_GE(input.patches[i], object ? 0 : Input::kObjectPoints);
      EXPECT_LT(input.patches[i], object ? Input::kObjectPoints : Input::kPoints);
    }
    for (std::size_t i = 0; i < input.near.size(); ++i) {
      EXPECT_GE(input.near[i], 0);
      EXPECT_LT(input.near[i], Input::kObjectTokens);
      EXPECT_GT(input.near_weights[i], 0);
    }
    for (std::size_t i = 0; i < input.near.size(); i += 3) {
      EXPECT_NEAR(input.near_weights[i] + input.near_weights[i + 1] + input.near_weights[i + 2], 1,
                  1e-6);
    }
    for (const std::uint32_t source : input.source) EXPECT_LT(source, count);
  }
}

TEST(PointInput, APatchIsACentreAndItsNearestPoints) {
  const Input input = *makePointInput(toyPoints(768), 1);
  for (std::size_t token = 0; token < Input::kObjectTokens; token += 7) {
    const auto* patch = &input.patches[token * Input::kPatch];
    const Eigen::Vector3f center = point(input, static_cast<std::size_t>(patch[0]));
    float farthest = 0;
    for (int k = 0; k < Input::kPatch; ++k) {
      const float d = (point(input, static_cast<std::size_t>(patch[k])) - center).norm();
      EXPECT_GE(d, farthest);
      farthest = d;
    }
    int nearer = 0;
    for (std::size_t i = 0; i < Input::kObjectPoints; ++i) {
      nearer += (point(input, i) - center).norm() < farthest;
    }
    EXPECT_LT(nearer, Input::kPatch);
  }
}

TEST(PointInput, FeaturesAreThePlaceTheHeightAndTheSide) {
  const ObjectPoints points = toyPoints(400);
  const Input input = *makePointInput(points, 1);
  for (std::size_t i = 0; i < Input::kObjectPoints; ++i) {
    const Eigen::Vector3f& p = points.object[input.source[i]];
    const Eigen::Vector3d expected = input.frame.toLocal(p.cast<double>());
    EXPECT_LT((point(input, i) - expected.cast<float>()).norm(), 1e-6f);
    EXPECT_NEAR(input.points[i * Input::kFeatures + 3], p.z() + 1, 1e-6);  // the floor is at -1 m
    EXPECT_EQ(input.points[i * Input::kFeatures + 4], 1);
  }
  for (std::size_t i = Input::kObjectPoints; i < Input::kPoints; ++i) {
    EXPECT_LE(point(input, i).cwiseAbs().maxCoeff(), 4);
    EXPECT_NEAR(input.points[i * Input::kFeatures + 3], 0, 1e-6);
    EXPECT_EQ(input.points[i * Input::kFeatures + 4], 0);
  }
  EXPECT_NEAR(input.globals[0], std::log(input.frame.scale), 1e-6);
  EXPECT_NEAR(input.globals[1], input.frame.center.z() + 1, 1e-6);
  EXPECT_NEAR(input.globals[2], 1, 1e-6);
  EXPECT_NEAR(input.globals[3], input.frame.center.norm(), 1e-6);
  EXPECT_NEAR(input.globals[4], std::log(400), 1e-6);
  EXPECT_EQ(input.globals[7], 1);
  EXPECT_EQ(input.globals[9], 0);
}

TEST(PointInput, DoesNotChangeWhenTheWorldTurnsByARightAngle) {
  // Medians are taken along the axes of the world; with an odd number of points a quarter turn
  // keeps them.
  const ObjectPoints points = toyPoints(401);
  const Input before = *makePointInput(points, 1);
  for (const double turn : {0.5 * std::numbers::pi, std::numbers::pi}) {
    const Input after = *makePointInput(turned(points, turn), 1);
    EXPECT_NEAR(
        std::remainder(after.frame.bearing - before.frame.bearing - turn, 2 * std::numbers::pi), 0,
        1e-5);
    EXPECT_NEAR(after.frame.scale, before.frame.scale, 1e-5);
    for (std::size_t i = 0; i < Input::kPoints; ++i) {
      ASSERT_LT((point(after, i) - point(before, i)).norm(), 2e-5f);
    }
    EXPECT_EQ(after.patches, before.patches);
    EXPECT_EQ(after.source, before.source);
  }
}

TEST(PointInput, ChangesLittleWhenTheWorldTurnsByAnyAngle) {
  const ObjectPoints points = toyPoints(401);
  const Input before = *makePointInput(points, 1);
  for (const double turn : {0.3, 1.1, 2.5}) {
    const Input after = *makePointInput(turned(points, turn), 1);
    EXPECT_NEAR(after.frame.scale, before.frame.scale, 0.05 * before.frame.scale);
    float most = 0;
    for (std::size_t i = 0; i < Input::kObjectPoints; ++i) {
      most = std::max(most, (point(after, i) - point(before, i)).norm());
    }
    EXPECT_LT(most, 0.15f);
  }
}

TEST(PointInput, TheFrameDoesNotDependOnTheOrderOfThePoints) {
  ObjectPoints points = toyPoints(401);
  const Input before = *makePointInput(points, 1);
  std::reverse(points.object.begin(), points.object.end());
  std::rotate(points.context.begin(), points.context.begin() + 50, points.context.end());
  const Input after = *makePointInput(points, 1);
  EXPECT_EQ(after.frame.center, before.frame.center);
  EXPECT_EQ(after.frame.bearing, before.frame.bearing);
  EXPECT_EQ(after.frame.scale, before.frame.scale);
  EXPECT_EQ(after.globals, before.globals);
}

TEST(PointInput, UsesEveryPointBeforeItRepeatsOne) {
  const Input few = *makePointInput(toyPoints(100), 1);
  EXPECT_EQ(std::set(few.source.begin(), few.source.end()).size(), 100u);
  const Input many = *makePointInput(toyPoints(700), 1);
  EXPECT_EQ(std::set(many.source.begin(), many.source.end()).size(),
            std::size_t{Input::kObjectPoints});
}

TEST(PointInput, NeedsFivePoints) {
  EXPECT_FALSE(makePointInput(ObjectPoints(), 1));
  EXPECT_FALSE(makePointInput(toyPoints(4), 1));
  EXPECT_TRUE(makePointInput(toyPoints(5), 1));
}

TEST(PointInput, WorksWithoutContextAndSaysSo) {
  ObjectPoints points = toyPoints(50);
  points.context.clear();
  const Input input = *makePointInput(points, 1);
  EXPECT_EQ(input.globals[9], 1);
  for (std::size_t i = 0; i < Input::kPoints; ++i) {
    EXPECT_EQ(input.points[i * Input::kFeatures + 4], 1);
  }
}

TEST(PointInput, OfPointsInOnePlaceIsFinite) {
  ObjectPoints points;
  points.object.assign(20, {1, 0, -0.5f});
  const Input input = *makePointInput(points, 1);
  EXPECT_DOUBLE_EQ(input.frame.scale, 0.03);
  for (const float value : input.points) EXPECT_TRUE(std::isfinite(value));
  for (const float value : input.near_weights) EXPECT_NEAR(value, 1.0f / 3, 1e-6);
}

}  // namespace
}  // namespace hydrabench
