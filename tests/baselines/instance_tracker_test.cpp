// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/instance_tracker.h"

#include <map>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "baselines/template_cad/landmark_map.h"
#include "core/geometry/transform.h"
#include "tests/support/miniature_world.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using ::testing::ElementsAre;
namespace id = miniature_label;

constexpr std::int64_t kSecond = 1'000'000'000;

// ---------------------------------------------------------------- one instance of one frame

/// A frame of one row, in which pixel i of instance 1 is at depth (i + 1) cm and 1 m above the
/// other, seen by a camera that looks along the world's x axis.
Frame rowOfDepths(int count) {
  Frame frame;
  frame.camera = {count, 1, 100, 100, 0, 0};
  frame.T_world_camera = lookAt(Vector3d(0, 0, 1), Vector3d(1, 0, 1));
  frame.depth = Image<float>(count, 1);
  for (int u = 0; u < count; ++u) frame.depth(u, 0) = 0.01f * static_cast<float>(u + 1);
  return frame;
}

FrameCandidates oneCandidate(int count) {
  FrameCandidates candidates;
  ObjectCandidate& candidate = candidates.candidates.emplace_back();
  candidate.label = id::kChair;
  for (int u = 0; u < count; ++u) candidate.pixels.push_back(static_cast<std::uint32_t>(u));
  return candidates;
}

TEST(InstanceMeasurement, TakesThePointsBetweenThePercentilesOfDepth) {
  // 101 depths from 1 to 101 cm: the 35th and the 45th percentile are 36 and 46 cm.
  const auto measured = measureInstances(rowOfDepths(101), oneCandidate(101), {35, 45, 0.0});
  ASSERT_EQ(measured.size(), 1u);
  EXPECT_EQ(measured[0].label, id::kChair);
  ASSERT_EQ(measured[0].points.size(), 11u);
  EXPECT_NEAR(measured[0].points.front().x(), 0.36, 1e-6);
  EXPECT_NEAR(measured[0].points.back().x(), 0.46, 1e-6);
  // Medians by coordinate: the sixth of eleven, pixel 40 at 41 cm, which is 0.40 * 0.41 m to the
  // right (-y).
  EXPECT_NEAR(measured[0].center.x(), 0.41, 1e-6);
  EXPECT_NEAR(measured[0].center.y(), -0.164, 1e-6);
}

TEST(InstanceMeasurement, AnInstanceSmallerThanTheLeastExtentIsNone) {
  // y runs from -0.35 * 0.36 to -0.45 * 0.46 m: 0.081 m; x over 0.10 m.
  EXPECT_EQ(measureInstances(rowOfDepths(101), oneCandidate(101), {35, 45, 0.099}).size(), 1u);
  EXPECT_EQ(measureInstances(rowOfDepths(101), oneCandidate(101), {35, 45, 0.101}).size(), 0u);
}

TEST(InstanceMeasurement, InstancesAreOrderedByWhereTheyAreNotByTheirIds) {
  FrameCandidates candidates;
  for (const std::uint32_t first : {60u, 0u}) {
    ObjectCandidate& candidate = candidates.candidates.emplace_back();
    candidate.id = static_cast<std::uint16_t>(candidates.candidates.size());
    for (std::uint32_t u = first; u < first + 40; ++u) candidate.pixels.push_back(u);
  }
  const auto measured = measureInstances(rowOfDepths(101), candidates, {35, 45, 0.0});
  ASSERT_EQ(measured.size(), 2u);
  EXPECT_LT(measured[0].center.x(), measured[1].center.x());
}

// ---------------------------------------------------------------- tracks

InstanceMeasurement at(double x, double y, Label label = id::kChair) {
  return {label, {x, y}, {Vector3d(x, y, 0.5)}};
}
const std::map<Label, double> kGates = {{id::kChair, 0.75}, {id::kBin, 1.0}};

TEST(InstanceTracker, TheCenterIsAMovingAverage) {
  InstanceTracker tracker({}, kGates);
  tracker.update(kSecond, {at(0, 0)});
  tracker.update(2 * kSecond, {at(0.5, 0)});  // 0.1 * 0.5 = 0.05
  tracker.update(3 * kSecond, {at(0.5, 0)});  // 0.05 + 0.1 * 0.45 = 0.095
  const auto tracks = tracker.takeAll();
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(tracks[0].center.x(), 0.095, 1e-12);
  EXPECT_THAT(tracks[0].stamps_ns, ElementsAre(kSecond, 2 * kSecond, 3 * kSecond));
}

TEST(InstanceTracker, TwoInOneFrameStayTwoHoweverNear) {
  InstanceTracker tracker({}, kGates);
  for (int i = 0; i < 5; ++i) tracker.update(i * kSecond, {at(0, 0), at(0.3, 0)});
  const auto tracks = tracker.takeAll();
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(tracks[0].center.x(), 0.0, 1e-12);
  EXPECT_NEAR(tracks[1].center.x(), 0.3, 1e-12);
}

TEST(InstanceTracker, TheCheapestPairsWinNotTheNearestFirst) {
  // From tracks at 0 and 0.5, measurements at 0.4 and 1.1. The nearest pair (0.4 to 0.5) would
  // leave 1.1 beyond the gate of track 0: 0.1 + 0.75 for the two left over. Straight: 0.4 + 0.6
  // = 1.0. With 0.9 in place of 1.1: 0.4 + 0.4 = 0.8 is cheaper than 0.85.
  const auto centers = [&](double second) {
    InstanceTracker tracker({.centroid_update = 1}, kGates);
    tracker.update(kSecond, {at(0, 0), at(0.5, 0)});
    tracker.update(2 * kSecond, {at(0.4, 0), at(second, 0)});
    std::vector<double> x;
    for (const InstanceTrack& track : tracker.takeAll()) x.push_back(track.center.x());
    return x;
  };
  EXPECT_THAT(centers(0.9), ElementsAre(0.4, 0.9));
  EXPECT_THAT(centers(1.1), ElementsAre(0.0, 0.4, 1.1));
}

TEST(InstanceTracker, BeyondTheGateANewTrackBegins) {
  InstanceTracker near({}, kGates);
  near.update(kSecond, {at(0, 0)});
  near.update(2 * kSecond, {at(0.74, 0)});
  EXPECT_EQ(near.takeAll().size(), 1u);
  InstanceTracker far({}, kGates);
  far.update(kSecond, {at(0, 0)});
  far.update(2 * kSecond, {at(0.76, 0)});
  EXPECT_EQ(far.takeAll().size(), 2u);
}

TEST(InstanceTracker, ClassesAreAssignedApart) {
  InstanceTracker tracker({}, kGates);
  tracker.update(kSecond, {at(0, 0)});
  tracker.update(2 * kSecond, {at(0, 0, id::kBin), at(0, 0, id::kCouch)});
  const auto tracks = tracker.takeAll();
  ASSERT_EQ(tracks.size(), 2u) << "a class without a gate is passed over";
  EXPECT_EQ(tracks[1].label, id::kBin);
}

TEST(InstanceTracker, ATrackEndsWhenItWasNotSeenForHalfAMinute) {
  InstanceTracker tracker({}, kGates);
  tracker.update(kSecond, {at(0, 0)});
  EXPECT_TRUE(tracker.update(31 * kSecond, {}).empty());
  EXPECT_EQ(tracker.update(31 * kSecond + 1, {}).size(), 1u);
  EXPECT_TRUE(tracker.takeAll().empty());
}

TEST(ThinnedPoints, KeepsEverySecondPointOfTheWholeStream) {
  ThinnedPoints thinned(4);
  for (int i = 0; i < 11; ++i) {
    const Vector3d point(i, 0, 0);
    thinned.add({&point, 1});
  }
  // 0 1 2 3 | 4 is one too many: 0 2 4, then 6, then 8 is one too many: 0 4 8.
  std::vector<double> x;
  for (const Vector3d& point : thinned.points()) x.push_back(point.x());
  EXPECT_THAT(x, ElementsAre(0, 4, 8));
}

// ---------------------------------------------------------------- landmarks

InstanceTrack track(double x, std::vector<std::int64_t> seconds, Label label = id::kChair) {
  InstanceTrack result;
  result.label = label;
  result.center = {x, 0};
  for (std::int64_t& stamp : seconds) stamp *= kSecond;
  result.stamps_ns = std::move(seconds);
  return result;
}

TEST(LandmarkMap, ATrackOfOneFrameIsNoObject) {
  LandmarkMap map({});
  map.add(track(0, {1}));
  EXPECT_TRUE(map.landmarks().empty());
  map.add(track(0, {1, 2}));
  EXPECT_EQ(map.landmarks().size(), 1u);
}

TEST(LandmarkMap, WhatIsSeenAgainJoinsTheNearestOfItsClass) {
  LandmarkMap map({});
  map.add(track(0, {1, 2, 3}));
  map.add(track(0.1, {1, 2, 3}, id::kBin));
  map.add(track(0.4, {50, 51, 52, 53, 54, 55}));
  ASSERT_EQ(map.landmarks().size(), 2u);
  EXPECT_NEAR(map.landmarks()[0].center.x(), 0.4 * 6 / 9, 1e-12) << "3 frames at 0, 6 at 0.4";
  EXPECT_EQ(map.landmarks()[0].stamps_ns.size(), 9u);
  map.add(track(1.02, {90, 91}));
  EXPECT_EQ(map.landmarks().size(), 3u) << "farther than 0.75 m";
}

TEST(LandmarkMap, WhatIsSeenSideBySideStaysTwo) {
  LandmarkMap map({});
  map.add(track(0, {1, 2, 3, 4}));
  map.add(track(0.4, {2, 3, 4, 5}));  // three of four frames in common
  EXPECT_EQ(map.landmarks().size(), 2u);
  map.add(track(0.1, {4, 8, 9, 10}));  // one of four
  EXPECT_EQ(map.landmarks().size(), 2u);
}

}  // namespace
}  // namespace hydrabench
