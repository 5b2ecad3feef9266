// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// A labelled scan of a real sensor. It is not part of the project: the tests look for it below
// HYDRABENCH_DATA and skip where it is absent.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/ground/patchwork.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;

fs::path scanFolder() {
  const char* variable = std::getenv("HYDRABENCH_DATA");
  return fs::path(variable ? variable : "") / "lidar/semantickitti_one_scan";
}

template <typename Value>
std::vector<Value> readValues(const fs::path& path) {
  std::vector<Value> values(fs::file_size(path) / sizeof(Value));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(Value)));
  return values;
}

/// A scan of SemanticKITTI: a 64-beam sensor 1.73 m above the road.
struct LabelledScan {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;
  std::vector<int> labels;

  static LabelledScan read() {
    LabelledScan scan;
    const auto values = readValues<float>(scanFolder() / "000000.bin");
    for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
      scan.points.emplace_back(values[i], values[i + 1], values[i + 2]);
      scan.intensity.push_back(values[i + 3]);
    }
    for (const std::uint32_t label : readValues<std::uint32_t>(scanFolder() / "000000.label")) {
      scan.labels.push_back(static_cast<int>(label & 0xffff));  // the upper half is the instance
    }
    return scan;
  }
  GroundScan scan() const { return {0, points, intensity, {}, {}, 1.73}; }
};

/// Counts over the points that have a class and none of those passed over. Ground that is not
/// judged is a miss.
struct Counts {
  int hits = 0, false_alarms = 0, misses = 0;
  double precision() const { return 1.0 * hits / (hits + false_alarms); }
  double recall() const { return 1.0 * hits / (hits + misses); }
  double f1() const { return 2.0 * hits / (2.0 * hits + false_alarms + misses); }
};
template <typename IsGround>
Counts score(const LabelledScan& truth, const GroundMask& mask, const std::set<int>& passed_over,
             const IsGround& isGround) {
  Counts counts;
  for (std::size_t i = 0; i < truth.labels.size(); ++i) {
    if (passed_over.contains(truth.labels[i])) continue;
    const bool is_ground = isGround(i);
    const bool said = mask.classes[i] == GroundClass::kGround;
    counts.hits += is_ground && said;
    counts.false_alarms += !is_ground && said;
    counts.misses += is_ground && !said;
  }
  return counts;
}

/// Road, parking, sidewalk, other ground, lane marking and terrain.
const std::set<int> kGroundLabels{40, 44, 48, 49, 60, 72};
constexpr int kUnlabelled = 0, kOutlier = 1, kVegetation = 70;

class LabelledStreet : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(scanFolder())) {
      GTEST_SKIP() << "no " << scanFolder().string() << "; set HYDRABENCH_DATA";
    }
    truth_ = LabelledScan::read();
    ASSERT_EQ(truth_.points.size(), 123389u);
    ASSERT_EQ(truth_.labels.size(), truth_.points.size());
    mask_ = Patchwork{{}}.segment(truth_.scan());
  }
  void report(const Counts& counts) {
    RecordProperty("precision", fmt::format("{:.4f}", counts.precision()));
    RecordProperty("recall", fmt::format("{:.4f}", counts.recall()));
    RecordProperty("f1", fmt::format("{:.4f}", counts.f1()));
    fmt::print("precision {:.4f}, recall {:.4f}, F1 {:.4f}\n", counts.precision(), counts.recall(),
               counts.f1());
  }
  LabelledScan truth_;
  GroundMask mask_;
};

/// The protocol of the Patchwork++ paper: vegetation, under which SemanticKITTI has high grass as
/// well as bushes and crowns, does not count either way.
TEST_F(LabelledStreet, PatchworkFindsTheGround) {
  const Counts counts =
      score(truth_, mask_, {kUnlabelled, kOutlier, kVegetation},
            [&](std::size_t i) { return kGroundLabels.contains(truth_.labels[i]); });
  report(counts);
  EXPECT_GE(counts.f1(), 0.98);
  EXPECT_GE(counts.precision(), 0.98);
  EXPECT_GE(counts.recall(), 0.97);
}

/// The protocol of the Patchwork paper: vegetation below three quarters of the sensor's height is
/// ground, other vegetation is not.
TEST_F(LabelledStreet, PatchworkFindsTheGroundWithLowVegetation) {
  const Counts counts = score(truth_, mask_, {kUnlabelled, kOutlier}, [&](std::size_t i) {
    return kGroundLabels.contains(truth_.labels[i]) ||
           (truth_.labels[i] == kVegetation && truth_.points[i].z() < -0.75f * 1.73f);
  });
  report(counts);
  EXPECT_GE(counts.f1(), 0.90);
}

/// Every point counts; whatever has no ground label is not ground.
TEST_F(LabelledStreet, PatchworkFindsTheGroundAmongAllPoints) {
  const Counts counts = score(
      truth_, mask_, {}, [&](std::size_t i) { return kGroundLabels.contains(truth_.labels[i]); });
  report(counts);
  EXPECT_GE(counts.f1(), 0.90);
}

}  // namespace
}  // namespace hydrabench
