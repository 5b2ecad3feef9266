// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/candidate_extractor.h"

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/objects/pixel_groups.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/core/objects/cell_camera.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;

constexpr Label kChair = 5;
constexpr Label kCouch = 7;
constexpr Label kWall = 19;

LabelSpace chairsAndCouches() {
  return {{{kChair, "chair", {}, true, true},
           {kCouch, "couch", {}, true, true},
           {kWall, "wall", {}, false, false}}};
}

CandidateExtractor::Config smallest() {
  CandidateExtractor::Config config;
  config.min_pixels = 1;
  return config;
}

FrameCandidates extract(const Frame& frame, const CandidateExtractor::Config& config,
                        const MotionDetection* motion = nullptr) {
  return CandidateExtractor(config, chairsAndCouches()).extract(frame, cellView(frame), motion);
}

TEST(CandidateExtractor, DescribesACandidate) {
  Frame frame = cellFrame();
  for (const int u : {4, 5, 6}) frame.labels(u, 2) = kChair;
  const FrameCandidates found = extract(frame, smallest());
  ASSERT_EQ(found.candidates.size(), 1u);
  const ObjectCandidate& chair = found.candidates[0];
  EXPECT_EQ(chair.id, 1);
  EXPECT_EQ(chair.label, kChair);
  EXPECT_FALSE(chair.dynamic);
  EXPECT_THAT(chair.pixels, ElementsAre(pixelAt(4, 2), pixelAt(5, 2), pixelAt(6, 2)));
  EXPECT_EQ(chair.region.u_begin, 4);
  EXPECT_EQ(chair.region.u_end, 7);
  EXPECT_EQ(chair.region.v_begin, 2);
  EXPECT_EQ(chair.region.v_end, 3);
  EXPECT_TRUE(chair.box.min().isApprox(Eigen::Vector3d(0.45, 0.25, 1.05), 1e-6));
  EXPECT_TRUE(chair.box.max().isApprox(Eigen::Vector3d(0.65, 0.25, 1.05), 1e-6));
  EXPECT_TRUE(chair.centroid.isApprox(Eigen::Vector3d(0.55, 0.25, 1.05), 1e-6));
  EXPECT_EQ(found.ids(5, 2), 1);
  EXPECT_EQ(found.ids(7, 2), 0);
}

TEST(CandidateExtractor, ListsEachTrackingVoxelOnceInOrder) {
  Frame frame = cellFrame();
  for (const int v : {1, 0}) {
    for (const int u : {1, 2, 3, 4}) frame.labels(u, v) = kChair;
  }
  const FrameCandidates found = extract(frame, smallest());  // voxels of 0.2 m
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_THAT(found.candidates[0].voxels,
              ElementsAre(GlobalVoxel(0, 0, 5), GlobalVoxel(1, 0, 5), GlobalVoxel(2, 0, 5)));
}

TEST(CandidateExtractor, CellsThatShareACornerAreConnected) {
  Frame frame = cellFrame();
  frame.labels(3, 3) = frame.labels(4, 4) = kChair;
  EXPECT_EQ(extract(frame, smallest()).candidates.size(), 1u);
}

TEST(CandidateExtractor, ACellInBetweenSeparates) {
  Frame frame = cellFrame();
  frame.labels(3, 3) = frame.labels(5, 5) = kChair;
  EXPECT_EQ(extract(frame, smallest()).candidates.size(), 2u);
}

TEST(CandidateExtractor, NeighboursInTheImageButNotInSpaceAreTwo) {
  Frame frame = cellFrame();
  frame.labels(3, 3) = frame.labels(4, 3) = kChair;
  frame.depth(4, 3) = 2 * kCellDepth;
  EXPECT_EQ(extract(frame, smallest()).candidates.size(), 2u);
}

TEST(CandidateExtractor, ClassesNeverJoinAndOnlyObjectsCount) {
  Frame frame = cellFrame();
  frame.labels(3, 3) = kChair;
  frame.labels(4, 3) = kCouch;
  frame.labels(5, 3) = kWall;
  const FrameCandidates found = extract(frame, smallest());
  ASSERT_EQ(found.candidates.size(), 2u);
  EXPECT_EQ(found.candidates[0].label, kChair);
  EXPECT_EQ(found.candidates[1].label, kCouch);
}

TEST(CandidateExtractor, PixelsWithoutDepthNeverCount) {
  Frame frame = cellFrame();
  for (int u = 0; u < 8; ++u) frame.labels(u, 5) = kChair;
  for (int u = 4; u < 8; ++u) frame.depth(u, 5) = 0;
  const FrameCandidates found = extract(frame, smallest());
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_EQ(found.candidates[0].pixels.size(), 4u);
  EXPECT_EQ(found.ids(4, 5), 0);
}

TEST(CandidateExtractor, FartherPointsArePassedOver) {
  Frame frame = cellFrame();
  frame.labels(0, 0) = frame.labels(8, 0) = kChair;
  frame.depth(8, 0) = 2 * kCellDepth;
  CandidateExtractor::Config config = smallest();
  config.max_range_m = 2;
  EXPECT_EQ(extract(frame, config).candidates.size(), 1u);
}

TEST(CandidateExtractor, LimitsOfThePixelCountAreInclusive) {
  Frame frame = cellFrame();
  for (const int u : {0, 1, 2}) frame.labels(u, 0) = kChair;
  CandidateExtractor::Config config = smallest();
  config.min_pixels = config.max_pixels = 3;
  EXPECT_EQ(extract(frame, config).candidates.size(), 1u);
  config.min_pixels = config.max_pixels = 4;
  EXPECT_EQ(extract(frame, config).candidates.size(), 0u);
  config.min_pixels = config.max_pixels = 2;
  EXPECT_EQ(extract(frame, config).candidates.size(), 0u);
}

TEST(CandidateExtractor, LimitsTheVolumeOfTheBox) {
  Frame frame = cellFrame();
  frame.instances(0, 0) = frame.instances(9, 9) = 4;
  frame.instance_labels = {{4, kChair}};
  frame.depth(9, 9) = 2 * kCellDepth;
  // From (0.05, 0.05, 1.05) to (1.9, 1.9, 2.1): 1.85 * 1.85 * 1.05 = 3.593625 m^3.
  CandidateExtractor::Config config = smallest();
  config.source = "instances";
  const auto count = [&](double min_m3, double max_m3) {
    config.min_volume_m3 = min_m3;
    config.max_volume_m3 = max_m3;
    return extract(frame, config).candidates.size();
  };
  EXPECT_EQ(count(3.59, 3.60), 1u);
  EXPECT_EQ(count(3.60, 0), 0u);
  EXPECT_EQ(count(0, 3.59), 0u);
  EXPECT_EQ(count(0, 0), 1u);
}

TEST(CandidateExtractor, ADroppedCandidateLeavesNoGapInTheNumbers) {
  Frame frame = cellFrame();
  frame.labels(0, 0) = kChair;
  for (const int u : {6, 7, 8}) frame.labels(u, 0) = kCouch;
  CandidateExtractor::Config config = smallest();
  config.min_pixels = 2;
  const FrameCandidates found = extract(frame, config);
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_EQ(found.candidates[0].id, 1);
  EXPECT_EQ(found.ids(0, 0), 0);
  EXPECT_EQ(found.ids(7, 0), 1);
}

TEST(CandidateExtractor, InstancesAreTakenAsTheyAreGiven) {
  Frame frame = cellFrame();
  frame.instances(0, 0) = frame.instances(9, 9) = 70;  // one instance in two places
  frame.instances(5, 0) = -3;
  frame.instances(6, 0) = 8;  // no class
  frame.instances(7, 0) = 9;  // no object
  frame.instance_labels = {{-3, kCouch}, {9, kWall}, {70, kChair}};
  CandidateExtractor::Config config = smallest();
  config.source = "instances";
  const FrameCandidates found = extract(frame, config);
  ASSERT_EQ(found.candidates.size(), 2u);
  EXPECT_EQ(found.candidates[0].label, kChair);
  EXPECT_THAT(found.candidates[0].pixels, ElementsAre(pixelAt(0, 0), pixelAt(9, 9)));
  EXPECT_EQ(found.candidates[1].label, kCouch);
}

TEST(CandidateExtractor, RefusesAFrameWithoutTheImageItNeeds) {
  Frame frame = cellFrame();
  frame.instances = {};
  CandidateExtractor::Config config = smallest();
  EXPECT_NO_THROW(extract(frame, config));
  config.source = "instances";
  EXPECT_THROW(extract(frame, config), InputError);
  frame = cellFrame();
  frame.labels = {};
  EXPECT_NO_THROW(extract(frame, config));
  config.source = "connected_semantics";
  EXPECT_THROW(extract(frame, config), InputError);
}

TEST(CandidateExtractor, RefusesMoreClassesThanItCanTellApart) {
  const auto classes = [](Label count) {
    LabelSpace space;
    for (Label label = 1; label <= count; ++label) {
      space.entries.push_back({label, std::to_string(label), {}, true, true});
    }
    return space;
  };
  Frame frame = cellFrame();
  frame.labels(4, 2) = 1023;
  const CandidateExtractor most(smallest(), classes(1023));
  const FrameCandidates found = most.extract(frame, cellView(frame));
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_EQ(found.candidates[0].label, 1023);
  EXPECT_THROW(CandidateExtractor(smallest(), classes(1024)), InputError);
  CandidateExtractor::Config instances = smallest();
  instances.source = "instances";
  EXPECT_NO_THROW(CandidateExtractor(instances, classes(1024)));
}

TEST(CandidateExtractor, MovingThingsComeFirstAndKeepTheirPixels) {
  Frame frame = cellFrame();
  for (const int u : {2, 3, 4}) frame.labels(u, 1) = kChair;
  MotionDetection motion{Image<std::uint8_t>(16, 12), {}};
  motion.ids(3, 1) = motion.ids(3, 2) = 1;
  motion.clusters.emplace_back().pixels = {pixelAt(3, 1), pixelAt(3, 2)};
  CandidateExtractor::Config config = smallest();
  config.grid_size_m = 0.3;  // the chair's two halves are one all the same
  const FrameCandidates found = extract(frame, config, &motion);
  ASSERT_EQ(found.candidates.size(), 2u);
  EXPECT_TRUE(found.candidates[0].dynamic);
  EXPECT_EQ(found.candidates[0].label, kUnknownLabel);
  EXPECT_EQ(found.candidates[0].pixels.size(), 2u);
  EXPECT_FALSE(found.candidates[1].dynamic);
  EXPECT_THAT(found.candidates[1].pixels, ElementsAre(pixelAt(2, 1), pixelAt(4, 1)));
  EXPECT_EQ(found.ids(3, 1), 1);
  EXPECT_EQ(found.ids(4, 1), 2);
}

/// A frame of random classes and depths, with holes.
Frame randomFrame(std::uint64_t seed) {
  Frame frame = cellFrame();
  Random random(seed);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    frame.depth.data()[i] =
        random.chance(0.1) ? 0.0f : static_cast<float>(random.uniform(1.0, 1.6));
    frame.labels.data()[i] = random.chance(0.6) ? kWall : random.chance(0.5) ? kChair : kCouch;
  }
  return frame;
}

/// Number of the connected group of each pixel, by comparing all pixels with each other.
std::vector<int> plainGroups(const Frame& frame) {
  const SensorView view = cellView(frame);
  const PixelPoints points(view);
  std::vector<int> group(frame.labels.size(), 0);
  std::vector<GlobalVoxel> cells(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Label label = frame.labels.data()[i];
    if ((label != kChair && label != kCouch) || view.range.data()[i] == 0) continue;
    group[i] = static_cast<int>(i) + 1;
    cells[i] = floored(points(static_cast<std::uint32_t>(i)) / 0.1);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = 0; j < group.size(); ++j) {
        if (group[i] == 0 || group[j] >= group[i] || group[j] == 0) continue;
        if (frame.labels.data()[i] != frame.labels.data()[j]) continue;
        if ((cells[i] - cells[j]).cwiseAbs().maxCoeff() > 1) continue;
        group[i] = group[j];
        changed = true;
      }
    }
  }
  return group;
}

TEST(CandidateExtractor, AgreesWithComparingAllPixels) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Frame frame = randomFrame(seed);
    const std::vector<int> expected = plainGroups(frame);
    const FrameCandidates found = extract(frame, smallest());
    std::map<int, int> id_of_group{{0, 0}};  // a group's number is its first pixel: same order
    for (const int group : expected) {
      id_of_group.try_emplace(group, static_cast<int>(id_of_group.size()));
    }
    ASSERT_EQ(found.candidates.size() + 1, id_of_group.size()) << seed;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(found.ids.data()[i], id_of_group[expected[i]]) << seed << ' ' << i;
    }
  }
}

TEST(CandidateExtractor, IsTheSameForAnyNumberOfThreads) {
  const Frame frame = randomFrame(7);
  setNumThreads(1);
  const FrameCandidates one = extract(frame, smallest());
  setNumThreads(4);
  const FrameCandidates four = extract(frame, smallest());
  setNumThreads(0);
  EXPECT_EQ(one.ids, four.ids);
  ASSERT_EQ(one.candidates.size(), four.candidates.size());
  for (std::size_t i = 0; i < one.candidates.size(); ++i) {
    EXPECT_EQ(one.candidates[i].centroid, four.candidates[i].centroid);
    EXPECT_EQ(one.candidates[i].voxels, four.candidates[i].voxels);
  }
}

}  // namespace
}  // namespace hydrabench
