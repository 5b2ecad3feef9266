// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/max_iou_tracker.h"

#include <initializer_list>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/objects/cell_camera.h"

namespace hydrabench {
namespace {

constexpr Label kChair = 5;
constexpr Label kCouch = 7;
constexpr std::int64_t kSecond = 1'000'000'000;

/// Voxels along x.
std::vector<GlobalVoxel> row(std::initializer_list<int> xs) {
  std::vector<GlobalVoxel> voxels;
  for (const int x : xs) voxels.emplace_back(x, 0, 0);
  return voxels;
}

ObjectCandidate candidate(Label label, std::initializer_list<int> xs) {
  ObjectCandidate c;
  c.label = label;
  c.voxels = row(xs);
  c.pixels = {0};
  return c;
}

ObjectCandidate moving(double x, std::initializer_list<int> xs = {}) {
  ObjectCandidate c = candidate(kUnknownLabel, xs);
  c.dynamic = true;
  c.centroid = {x, 0, 0};
  return c;
}

/// A tracker that is fed candidates, one second apart.
class Feed {
 public:
  explicit Feed(const MaxIouTracker::Config& config = {}) : tracker(config) {}
  void see(std::vector<ObjectCandidate> candidates) {
    SensorView view = cellView(cellFrame(now_ns));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      candidates[i].id = static_cast<std::uint16_t>(i + 1);
    }
    tracker.update(view, {Image<std::uint16_t>(16, 12), std::move(candidates)});
    now_ns += kSecond;
  }
  MaxIouTracker tracker;
  std::int64_t now_ns = kSecond;
};

TEST(VoxelSetIou, IsIntersectionOverUnion) {
  EXPECT_DOUBLE_EQ(voxelSetIou(row({0, 1, 2}), row({1, 2, 3})), 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(voxelSetIou(row({0, 1}), row({1, 2, 3, 4, 5})), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(voxelSetIou(row({0, 1}), row({0, 1})), 1.0);
  EXPECT_DOUBLE_EQ(voxelSetIou(row({0}), row({1})), 0.0);
  EXPECT_DOUBLE_EQ(voxelSetIou({}, row({1})), 0.0);
  EXPECT_DOUBLE_EQ(voxelSetIou({}, {}), 0.0);
}

TEST(MaxIouTracker, AnOverlapAboveTheThresholdContinuesATrack) {
  Feed feed;
  feed.see({candidate(kChair, {0, 1, 2})});
  feed.see({candidate(kChair, {2, 3})});  // 1 / 4: not above 0.25
  feed.see({candidate(kChair, {2})});     // 1 / 3 with the first, 1 / 2 with the second
  ASSERT_EQ(feed.tracker.tracks().size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[0].observations.size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[1].observations.size(), 1u);
}

TEST(MaxIouTracker, FollowsInstancesWhoseIdsPersistWhereverTheyAre) {
  MaxIouTracker::Config config;
  config.track_by = "instances";
  Feed feed(config);
  const auto instance = [](InstanceId id, std::initializer_list<int> xs) {
    ObjectCandidate c = candidate(kChair, xs);
    c.instance = id;
    return c;
  };
  feed.see({instance(7, {0}), instance(8, {1}), instance(kNoInstance, {2})});
  feed.see({instance(8, {0}), instance(7, {1}), instance(kNoInstance, {2})});
  ASSERT_EQ(feed.tracker.tracks().size(), 4u);  // those without an id stay alone
  EXPECT_EQ(feed.tracker.tracks()[0].last_voxels, row({1}));
  EXPECT_EQ(feed.tracker.tracks()[1].last_voxels, row({0}));
}

TEST(MaxIouTracker, TracksChooseInTheOrderOfTheirIds) {
  Feed feed;
  feed.see({candidate(kChair, {0, 1, 2}), candidate(kChair, {3, 4, 5})});
  // 2 / 5 with the first track, 3 / 4 with the second; the first comes first.
  feed.see({candidate(kChair, {1, 2, 3, 4}), candidate(kChair, {20})});
  EXPECT_EQ(feed.tracker.tracks()[0].observations.size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[1].observations.size(), 1u);
  EXPECT_EQ(feed.tracker.tracks().size(), 3u);
}

TEST(MaxIouTracker, ATrackTakesTheBestCandidate) {
  Feed feed;
  feed.see({candidate(kChair, {0, 1, 2})});
  feed.see({candidate(kChair, {0, 1}), candidate(kChair, {0, 1, 2, 3})});  // 2 / 3, 3 / 4
  EXPECT_EQ(feed.tracker.tracks()[0].observations.back().candidate_id, 2);
  EXPECT_EQ(feed.tracker.tracks()[0].last_voxels, row({0, 1, 2, 3}));
  EXPECT_EQ(feed.tracker.tracks().size(), 2u);
}

TEST(MaxIouTracker, OnlyTheLastObservationCounts) {
  Feed feed;
  feed.see({candidate(kChair, {0, 1, 2, 3})});
  feed.see({candidate(kChair, {2, 3, 4, 5})});
  feed.see({candidate(kChair, {0, 1})});  // of the first alone it would be 1 / 2
  EXPECT_EQ(feed.tracker.tracks().size(), 2u);
}

TEST(MaxIouTracker, ACandidateOfAnotherClassNeverContinuesATrack) {
  Feed feed;
  feed.see({candidate(kChair, {0, 1, 2})});
  feed.see({candidate(kCouch, {0, 1, 2})});
  feed.see({candidate(kChair, {0, 1, 2})});
  ASSERT_EQ(feed.tracker.tracks().size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[0].observations.size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[1].label, kCouch);
}

TEST(MaxIouTracker, ATrackEndsWhenUnseenForLongerThanTheWindow) {
  Feed feed;
  feed.see({candidate(kChair, {0}), candidate(kChair, {10})});  // at 1 s
  feed.see({candidate(kChair, {10})});                          // at 2 s
  EXPECT_TRUE(feed.tracker.takeEnded(4 * kSecond).empty());     // exactly 3 s
  const std::vector<Track> ended = feed.tracker.takeEnded(4 * kSecond + 1);
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_EQ(ended[0].id, 0u);
  EXPECT_EQ(ended[0].lastSeenNs(), kSecond);
  EXPECT_EQ(feed.tracker.tracks().size(), 1u);
  EXPECT_TRUE(feed.tracker.takeEnded(4 * kSecond + 1).empty());
}

TEST(MaxIouTracker, EndedTracksComeInTheOrderOfTheirIdsAndIdsAreNotUsedAgain) {
  Feed feed;
  feed.see({candidate(kChair, {0}), candidate(kChair, {10}), candidate(kChair, {20})});
  const std::vector<Track> all = feed.tracker.takeAll();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].id, 0u);
  EXPECT_EQ(all[2].id, 2u);
  EXPECT_TRUE(feed.tracker.tracks().empty());
  feed.see({candidate(kChair, {0})});
  EXPECT_EQ(feed.tracker.tracks()[0].id, 3u);
}

TEST(MaxIouTracker, ConfidenceIsOneHalfAtTheGivenNumberOfObservations) {
  Feed feed;
  for (int i = 0; i < 15; ++i) feed.see({candidate(kChair, {0})});
  EXPECT_DOUBLE_EQ(feed.tracker.confidence(feed.tracker.tracks()[0]), 0.5);
  feed.see({candidate(kChair, {0})});
  EXPECT_DOUBLE_EQ(feed.tracker.confidence(feed.tracker.tracks()[0]), 16.0 / 30.0);
  for (int i = 0; i < 20; ++i) feed.see({candidate(kChair, {0})});
  EXPECT_DOUBLE_EQ(feed.tracker.confidence(feed.tracker.tracks()[0]), 1.0);
}

TEST(MaxIouTracker, ListsObservedStampsOnce) {
  Feed feed;
  feed.see({candidate(kChair, {0}), candidate(kChair, {10})});
  feed.see({candidate(kChair, {10})});
  EXPECT_THAT(feed.tracker.observedStamps(), testing::ElementsAre(kSecond, 2 * kSecond));
}

TEST(MaxIouTracker, AMovingTrackTakesTheNearestMovingCandidate) {
  Feed feed;
  feed.see({moving(0)});
  feed.see({moving(0.75), moving(-0.5)});
  ASSERT_EQ(feed.tracker.tracks().size(), 2u);
  EXPECT_EQ(feed.tracker.tracks()[0].observations.back().candidate_id, 2);
  feed.see({moving(-1.5)});  // exactly 1 m from the first: too far
  EXPECT_EQ(feed.tracker.tracks().size(), 3u);
}

TEST(MaxIouTracker, AMovingTrackGoesOnAsACandidateOfAClass) {
  Feed feed;
  feed.see({moving(0, {0, 1, 2, 3, 4, 5})});
  feed.see({candidate(kChair, {5, 6, 7, 8})});  // 1 / 9, above 0.1: it stands still now
  ASSERT_EQ(feed.tracker.tracks().size(), 1u);
  const Track& track = feed.tracker.tracks()[0];
  EXPECT_EQ(track.observations.size(), 2u);
  EXPECT_EQ(track.label, kChair);
  EXPECT_TRUE(track.dynamic);
}

TEST(MaxIouTracker, TheCrossThresholdIsStrict) {
  Feed feed;
  feed.see({moving(0, {0, 1, 2, 3, 4})});
  feed.see({candidate(kChair, {4, 5, 6, 7, 8, 9})});  // 1 / 10
  ASSERT_EQ(feed.tracker.tracks().size(), 2u);
  EXPECT_FALSE(feed.tracker.tracks()[1].dynamic);
}

TEST(MaxIouTracker, ThePartOfAMovingThingThatHasAClassBeginsNoTrack) {
  Feed feed;
  feed.see({moving(0, {0, 1, 2}), candidate(kChair, {2, 3})});
  ASSERT_EQ(feed.tracker.tracks().size(), 1u);
  EXPECT_EQ(feed.tracker.tracks()[0].label, kChair);
  EXPECT_EQ(feed.tracker.tracks()[0].observations.size(), 1u);
}

TEST(MaxIouTracker, ByBoxesComparesVolumes) {
  MaxIouTracker::Config config;
  config.track_by = "boxes";
  Feed feed(config);
  ObjectCandidate a = candidate(kChair, {});
  a.box = Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 1, 1));
  ObjectCandidate b = a;
  b.box.translate(Eigen::Vector3d(1, 0, 0));  // 1 / 3
  ObjectCandidate c = b;
  c.box.translate(Eigen::Vector3d(1.25, 0, 0));  // 0.75 / 3.25
  feed.see({a});
  feed.see({b});
  EXPECT_EQ(feed.tracker.tracks().size(), 1u);
  feed.see({c});
  EXPECT_EQ(feed.tracker.tracks().size(), 2u);
}

TEST(MaxIouTracker, ByPixelsProjectsTheLastPointsIntoTheImage) {
  MaxIouTracker::Config config;
  config.track_by = "pixels";
  MaxIouTracker tracker(config);
  ObjectCandidate c = candidate(kChair, {});
  c.pixels = {pixelAt(4, 2), pixelAt(5, 2), pixelAt(6, 2)};
  tracker.update(cellView(cellFrame(1)), {Image<std::uint16_t>(16, 12), {c}});

  // The camera moves by two pixels: the points fall on columns 2 to 4.
  Frame frame = cellFrame(2);
  frame.T_world_camera.translation() = Eigen::Vector3d(0.2, 0, 0);
  c.pixels = {pixelAt(3, 2), pixelAt(4, 2), pixelAt(5, 2)};  // 2 / 4
  tracker.update(cellView(frame), {Image<std::uint16_t>(16, 12), {c}});
  ASSERT_EQ(tracker.tracks().size(), 1u);

  // By ten more: the points at x = 0.55 to 0.75 m leave the image.
  frame.stamp_ns = 3;
  frame.T_world_camera.translation() = Eigen::Vector3d(1.2, 0, 0);
  c.pixels = {pixelAt(0, 2), pixelAt(1, 2)};
  tracker.update(cellView(frame), {Image<std::uint16_t>(16, 12), {c}});
  EXPECT_EQ(tracker.tracks().size(), 2u);
}

TEST(MaxIouTracker, ByPixelsFindsAThingAgainFarFromTheOrigin) {
  // At 3000 km floats are 0.25 m apart, more than two pixels.
  MaxIouTracker::Config config;
  config.track_by = "pixels";
  config.min_same_label_iou = 0.9;
  MaxIouTracker tracker(config);
  ObjectCandidate c = candidate(kChair, {});
  c.pixels = {pixelAt(4, 2), pixelAt(5, 2), pixelAt(6, 2)};
  for (const int stamp_ns : {1, 2}) {
    Frame frame = cellFrame(stamp_ns);
    frame.T_world_camera.translation() = Eigen::Vector3d(3e6, 3e6, 0);
    tracker.update(cellView(frame), {Image<std::uint16_t>(16, 12), {c}});
  }
  EXPECT_EQ(tracker.tracks().size(), 1u);
}

}  // namespace
}  // namespace hydrabench
