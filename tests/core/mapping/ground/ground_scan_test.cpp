// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// What every segmenter of the table must do with a scan.
#include "core/mapping/ground/ground_scan.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/ground/ground_table.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

const LabelSpace kSpace{{{9, "road", {}, false, false}}};

class EverySegmenter : public ::testing::TestWithParam<std::string> {
 protected:
  EverySegmenter() {
    GroundConfig config;
    config.type = GetParam();
    config.semantic.labels = {"road"};
    segmenter_ = makeGroundSegmenter(config, kSpace);
  }
  /// What it has to say of a scan; empty: nothing.
  std::string faultOf(const GroundScan& scan) {
    try {
      segmenter_->segment(scan);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  std::unique_ptr<GroundSegmenter> segmenter_;
};
INSTANTIATE_TEST_SUITE_P(Table, EverySegmenter, testing::ValuesIn(groundTypes()),
                         [](const auto& type) { return type.param; });

TEST_P(EverySegmenter, AnEmptyScanHasNoClasses) {
  const GroundMask mask = segmenter_->segment({0, {}, {}, {}, {}, 1.7});
  EXPECT_TRUE(mask.classes.empty());
  EXPECT_EQ(mask.num_invalid, 0u);
}

TEST_P(EverySegmenter, PointsThatMeasuredNothingAreCountedAndNotJudged) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  std::vector<Eigen::Vector3f> points{{0, 0, 0}, {kNan, 5, -1.7f}, {5, 0, kNan}, {kInf, 5, -1.7f}};
  for (int i = 0; i < 400; ++i) {
    points.emplace_back(5 + 0.1f * static_cast<float>(i % 20), 0.1f * static_cast<float>(i / 20),
                        -1.7f);
  }
  const std::vector<Label> labels(points.size(), 9);
  const GroundMask mask = segmenter_->segment({0, points, {}, {}, labels, 1.7});
  EXPECT_EQ(mask.num_invalid, 4u);
  ASSERT_EQ(mask.classes.size(), points.size());
  for (int i = 0; i < 4; ++i) EXPECT_EQ(mask.classes[i], GroundClass::kNotJudged) << i;
  EXPECT_EQ(mask.count(GroundClass::kGround), GetParam() == "none" ? 0u : 400u);
}

TEST_P(EverySegmenter, NamesTheListOfTheWrongLength) {
  const std::vector<Eigen::Vector3f> points(3, {5, 0, -1.7f});
  const std::vector<std::uint16_t> lines(2);
  const std::vector<float> intensity(4);
  const std::vector<Label> labels(3, 9), few_labels(1, 9);
  EXPECT_EQ(faultOf({42, points, {}, lines, labels, 1.7}),
            "the scan at 42 ns has 2 entries in 'lines'; expected 3, one per point, or none");
  EXPECT_EQ(faultOf({42, points, intensity, {}, labels, 1.7}),
            "the scan at 42 ns has 4 entries in 'intensity'; expected 3, one per point, or none");
  EXPECT_EQ(faultOf({42, points, {}, {}, few_labels, 1.7}),
            "the scan at 42 ns has 1 entries in 'labels'; expected 3, one per point, or none");
}

TEST_P(EverySegmenter, RefusesASensorThatIsNotAboveTheGround) {
  const std::vector<Eigen::Vector3f> points(3, {5, 0, -1.7f});
  const std::vector<Label> labels(3, 9);
  EXPECT_EQ(faultOf({42, points, {}, {}, labels, 0}),
            "the scan at 42 ns has a sensor_height_m of 0; expected the height of the sensor above "
            "the ground, above 0");
  EXPECT_THAT(faultOf({42, points, {}, {}, labels, std::numeric_limits<double>::quiet_NaN()}),
              testing::HasSubstr("sensor_height_m of nan"));
}

}  // namespace
}  // namespace hydrabench
