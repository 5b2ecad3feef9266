// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/best_view.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/objects/cell_camera.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;

Observation observation(std::int64_t stamp_ns) {
  Observation result;
  result.stamp_ns = stamp_ns;
  return result;
}

/// Stamps of the views kept of a track with these volumes, in their order; stamps count from 1.
std::vector<std::int64_t> kept(const std::vector<double>& volumes, std::size_t max_views,
                               int* num_frames = nullptr) {
  BestViews views(max_views);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    views.add(observation(static_cast<std::int64_t>(i) + 1), volumes[i], [&] {
      if (num_frames) ++*num_frames;
      return nullptr;
    });
  }
  std::vector<std::int64_t> stamps;
  for (const TrackView& view : views.ordered()) stamps.push_back(view.observation.stamp_ns);
  return stamps;
}

TEST(BestViews, TheLargestBoxComesFirstTheEarliestOfEquals) {
  EXPECT_THAT(kept({2, 5, 3, 5, 1}, 8), ElementsAre(2, 4, 3, 1, 5));
  EXPECT_THAT(kept({2, 5, 3, 5, 1}, 1), ElementsAre(2));
  EXPECT_THAT(kept({0, 0, 0}, 1), ElementsAre(1));
}

TEST(BestViews, FramesAreMadeOnlyForViewsThatAreKept) {
  int num_frames = 0;
  kept({2, 1, 5, 3, 5, 4}, 1, &num_frames);
  EXPECT_EQ(num_frames, 2);
}

TEST(BestViews, AreSpreadOverTheTrack) {
  // 16 observations for four views: spans of four, of each its best.
  EXPECT_THAT(kept({1, 9, 2, 3, 4, 5, 4, 3, 8, 8, 8, 8, 1, 2, 3, 7}, 4), ElementsAre(2, 9, 16, 6));
  // Of a growing object the last of each span, of a shrinking one the first.
  std::vector<double> growing;
  for (int i = 1; i <= 64; ++i) growing.push_back(i);
  EXPECT_THAT(kept(growing, 4), ElementsAre(64, 48, 32, 16));
  EXPECT_THAT(kept({growing.rbegin(), growing.rend()}, 4), ElementsAre(1, 17, 33, 49));
}

TEST(BestViews, AnOddNumberOfSpansJoinsInPairsFromTheStart) {
  // Three spans of one; the fourth observation makes spans of two.
  EXPECT_THAT(kept({1, 2, 3, 9}, 3), ElementsAre(4, 2));
}

TEST(BestViews, TheBestOfALongTrackIsNeverLost) {
  for (std::size_t best = 0; best < 100; ++best) {
    std::vector<double> volumes(100, 1);
    volumes[best] = 2;
    for (const std::size_t max_views : {1u, 2u, 3u, 5u, 8u}) {
      const auto stamps = kept(volumes, max_views);
      EXPECT_EQ(stamps.front(), static_cast<std::int64_t>(best) + 1);
      EXPECT_LE(stamps.size(), max_views);
      EXPECT_GE(2 * stamps.size(), max_views);
    }
  }
}

TEST(SeenVolume, IsThatOfTheBoxAndTrimmedThatWithoutAFewFarPoints) {
  // 8 x 8 pixels of the wall, 0.1 m apart, all of them shifted by their number in depth so that the
  // box has a volume; one of them is 4 m off.
  Frame frame = cellFrame();
  ObjectCandidate candidate;
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 8; ++u) {
      candidate.pixels.push_back(pixelAt(u, v));
      frame.depth(u, v) = kCellDepth + 0.01f * static_cast<float>(u);
    }
  }
  frame.depth(7, 7) = 5;
  for (const std::uint32_t pixel : candidate.pixels) {
    const int u = static_cast<int>(pixel) % 16;
    const int v = static_cast<int>(pixel) / 16;
    candidate.box.extend(frame.camera.backproject(u, v, double{frame.depth(u, v)}));
  }
  EXPECT_EQ(seenVolume(frame, candidate, 0), candidate.box.volume());
  EXPECT_GT(candidate.box.volume(), 20);
  EXPECT_NEAR(seenVolume(frame, candidate, 0.02), 0.7 * 0.7 * 0.07, 0.012);
  candidate.pixels.resize(1);
  EXPECT_EQ(seenVolume(frame, candidate, 0.02), 0);
}

TEST(InstanceMasks, GiveUnmeasuredPixelsOfTheInstanceToItsCandidate) {
  Frame frame = cellFrame();
  frame.instances(3, 2) = frame.instances(4, 2) = frame.instances(5, 2) = 7;
  frame.instances(8, 2) = 9;  // measured, but no candidate's: passed over by its range, say
  frame.depth(4, 2) = 0;
  frame.depth(8, 2) = 0;
  FrameCandidates candidates{Image<std::uint16_t>(16, 12), {}};
  candidates.ids(3, 2) = 1;
  ObjectCandidate& candidate = candidates.candidates.emplace_back();
  candidate.id = 1;
  candidate.pixels = {pixelAt(3, 2)};
  const Image<std::uint16_t> ids = instanceMasks(frame, candidates);
  EXPECT_EQ(ids(3, 2), 1);
  EXPECT_EQ(ids(4, 2), 1);
  EXPECT_EQ(ids(5, 2), 0);
  EXPECT_EQ(ids(8, 2), 0);
}

TEST(ShapeObservation, HasTheImagesAndTheMaskOfOneCandidate) {
  const Frame frame = cellFrame(42);
  Image<std::uint16_t> ids(16, 12);
  ids(3, 2) = 1;
  ids(4, 2) = ids(5, 2) = 2;
  Observation second = observation(42);
  second.candidate_id = 2;
  const ShapeObservation view = shapeObservation({bufferedFrame(frame, ids), second, 1.0}, 5);
  EXPECT_EQ(view.stamp_ns, 42);
  EXPECT_EQ(view.camera, frame.camera);
  EXPECT_EQ(view.depth, frame.depth);
  EXPECT_EQ(view.label, 5);
  EXPECT_EQ(std::count(view.mask.begin(), view.mask.end(), 1), 2);
  EXPECT_EQ(view.mask(3, 2), 0);
  EXPECT_EQ(view.mask(4, 2), 1);
}

}  // namespace
}  // namespace hydrabench
