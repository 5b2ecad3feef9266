// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/mask_corruption.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr Label kChair = 5;
constexpr Label kDesk = 16;
constexpr Label kBin = 18;
constexpr Label kWall = 19;

/// Objects 0 and 1 are chairs that touch, 2 is a desk that touches chair 1, 3 is a bin apart from
/// all. The rest is wall.
struct Picture {
  Image<std::int32_t> objects = Image<std::int32_t>(120, 80, -1);
  Image<Label> labels = Image<Label>(120, 80, kWall);
  std::vector<Label> object_labels = {kChair, kChair, kDesk, kBin};

  Picture() {
    paint(0, 10, 20);
    paint(1, 30, 20);
    paint(2, 50, 20);
    paint(3, 90, 20);
  }
  void paint(int object, int u0, int size) {
    for (int v = 30; v < 30 + size; ++v) {
      for (int u = u0; u < u0 + size; ++u) {
        objects(u, v) = object;
        labels(u, v) = object_labels[static_cast<std::size_t>(object)];
      }
    }
  }
  Segmentation corrupted(const MaskCorruptionConfig& config, std::uint64_t seed) const {
    return corruptMasks(objects, labels, object_labels, config, seed);
  }
};

void expectConsistent(const Segmentation& segmentation) {
  std::set<InstanceId> occurring;
  for (int v = 0; v < segmentation.instances.height(); ++v) {
    for (int u = 0; u < segmentation.instances.width(); ++u) {
      const InstanceId id = segmentation.instances(u, v);
      if (id == kNoInstance) continue;
      occurring.insert(id);
      ASSERT_TRUE(segmentation.instance_labels.contains(id));
      ASSERT_EQ(segmentation.instance_labels.at(id), segmentation.labels(u, v));
    }
  }
  ASSERT_EQ(occurring.size(), segmentation.instance_labels.size());
}

/// Share of seeds for which something holds.
template <typename Condition>
double shareOf(const MaskCorruptionConfig& config, const Condition& condition) {
  const Picture picture;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Segmentation segmentation = picture.corrupted(config, seed);
    expectConsistent(segmentation);
    count += condition(segmentation) ? 1 : 0;
  }
  return count / 400.0;
}

TEST(MaskCorruption, SwitchedOffKeepsEveryMask) {
  const Picture picture;
  const Segmentation result = picture.corrupted(MaskCorruptionConfig::off(), 1);
  EXPECT_EQ(result.labels, picture.labels);
  EXPECT_EQ(result.instance_labels.size(), 4u);
  expectConsistent(result);
  for (int v = 0; v < 80; ++v) {
    for (int u = 0; u < 120; ++u) {
      EXPECT_EQ(result.instances(u, v) == kNoInstance, picture.objects(u, v) < 0);
    }
  }
}

TEST(MaskCorruption, IdsAreShuffledInEveryFrame) {
  const Picture picture;
  std::set<std::vector<InstanceId>> orders;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Segmentation result = picture.corrupted(MaskCorruptionConfig::off(), seed);
    std::vector<InstanceId> ids;
    for (const int u : {20, 40, 60, 100}) ids.push_back(result.instances(u, 40));
    orders.insert(ids);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (std::vector<InstanceId>{1, 2, 3, 4}));
  }
  EXPECT_EQ(orders.size(), 24u);  // all 4! orders occur
}

TEST(MaskCorruption, MissedObjectsLoseInstanceAndLabel) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.miss_probability = 0.3;
  // 400 draws: deviation 2.3 %.
  EXPECT_NEAR(shareOf(config,
                      [](const Segmentation& s) {
                        EXPECT_EQ(s.instances(100, 40) == kNoInstance,
                                  s.labels(100, 40) == kUnknownLabel);
                        return s.instances(100, 40) == kNoInstance;
                      }),
              0.3, 0.08);
}

TEST(MaskCorruption, SmallMasksAreMissed) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.min_pixels = 401;  // each has 400
  EXPECT_TRUE(Picture().corrupted(config, 1).instance_labels.empty());
  config.min_pixels = 400;
  EXPECT_EQ(Picture().corrupted(config, 1).instance_labels.size(), 4u);
}

TEST(MaskCorruption, SplitsAMaskIntoTwoHalvesOfOneClass) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.split_probability = 1;
  const Segmentation result = Picture().corrupted(config, 1);
  expectConsistent(result);
  ASSERT_EQ(result.instance_labels.size(), 8u);
  std::map<InstanceId, int> pixels;
  for (int v = 30; v < 50; ++v) {
    for (int u = 90; u < 110; ++u) ++pixels[result.instances(u, v)];
  }
  ASSERT_EQ(pixels.size(), 2u);
  // A line through the centre of a square cuts it into equal parts, up to the pixels on the line.
  EXPECT_NEAR(pixels.begin()->second, 200, 25);
  config.split_probability = 0.25;
  EXPECT_NEAR(shareOf(config,
                      [](const Segmentation& s) {
                        std::set<InstanceId> ids;
                        for (int v = 30; v < 50; ++v) {
                          for (int u = 90; u < 110; ++u) ids.insert(s.instances(u, v));
                        }
                        return ids.size() == 2;
                      }),
              0.25, 0.08);
}

TEST(MaskCorruption, MergesTouchingMasksOfOneClassOnly) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.merge_probability = 1;
  const Segmentation result = Picture().corrupted(config, 1);
  expectConsistent(result);
  EXPECT_EQ(result.instances(20, 40), result.instances(40, 40));  // the two chairs
  EXPECT_NE(result.instances(40, 40),
            result.instances(60, 40));  // chair and desk touch, but differ
  EXPECT_EQ(result.instance_labels.size(), 3u);
  config.merge_probability = 0.4;
  EXPECT_NEAR(
      shareOf(config,
              [](const Segmentation& s) { return s.instances(20, 40) == s.instances(40, 40); }),
      0.4, 0.08);
}

TEST(MaskCorruption, ConfusedMasksCarryAnotherClassEverywhere) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.confusion_probability = 1;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Segmentation result = Picture().corrupted(config, seed);
    expectConsistent(result);
    EXPECT_NE(result.labels(100, 40), kBin);
    EXPECT_TRUE(result.labels(100, 40) == kChair || result.labels(100, 40) == kDesk);
    EXPECT_EQ(result.labels(0, 0), kWall);
  }
  config.confusion_probability = 0.2;
  EXPECT_NEAR(shareOf(config, [](const Segmentation& s) { return s.labels(100, 40) != kBin; }), 0.2,
              0.08);
}

TEST(MaskCorruption, JitterMovesOutlinesByAboutItsSigma) {
  MaskCorruptionConfig config = MaskCorruptionConfig::off();
  config.boundary_jitter_px = 2;
  config.boundary_correlation_px = 8;
  double squares = 0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Segmentation result = Picture().corrupted(config, seed);
    expectConsistent(result);
    // The left outline of the bin, true at u = 90.
    int u = 80;
    while (result.labels(u, 40) != kBin) ++u;
    squares += (u - 90) * (u - 90);
    ++count;
    EXPECT_EQ(result.labels(100, 40), kBin);  // the middle stays
  }
  // The looked-up place moves by sigma 2; the outline's first crossing is biased outwards a little.
  EXPECT_NEAR(std::sqrt(squares / count), 2, 0.8);
}

TEST(MaskCorruption, EverythingAtOnceStaysConsistent) {
  MaskCorruptionConfig config;
  config.boundary_jitter_px = 3;
  config.miss_probability = config.split_probability = config.merge_probability = 0.5;
  config.confusion_probability = 0.5;
  shareOf(config, [](const Segmentation&) { return true; });
}

TEST(MaskCorruption, IsAFunctionOfTheSeed) {
  const Picture picture;
  const MaskCorruptionConfig config;
  const Segmentation first = picture.corrupted(config, 9);
  const Segmentation again = picture.corrupted(config, 9);
  EXPECT_EQ(first.instances, again.instances);
  EXPECT_EQ(first.labels, again.labels);
  EXPECT_EQ(first.instance_labels, again.instance_labels);
}

}  // namespace
}  // namespace hydrabench
