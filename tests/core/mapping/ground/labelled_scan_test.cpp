// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// A labelled scan of a real sensor. It is not part of the project: the tests look for it below
// HYDRABENCH_DATA and skip where it is absent.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
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

  LabelledScan() {
    const auto values = readValues<float>(scanFolder() / "000000.bin");
    for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
      points.emplace_back(values[i], values[i + 1], values[i + 2]);
      intensity.push_back(values[i + 3]);
    }
    for (const std::uint32_t label : readValues<std::uint32_t>(scanFolder() / "000000.label")) {
      labels.push_back(static_cast<int>(label & 0xffff));  // the upper half is the instance
    }
  }
  GroundScan scan() const { return {0, points, intensity, {}, {}, 1.73}; }
};

struct Counts {
  std::size_t hits = 0, false_alarms = 0, misses = 0;
  double precision() const { return double(hits) / double(hits + false_alarms); }
  double recall() const { return double(hits) / double(hits + misses); }
  double f1() const { return 2.0 * double(hits) / double(2 * hits + false_alarms + misses); }
};

constexpr int kUnlabelled = 0, kOutlier = 1, kVegetation = 70;

/// As Patchwork++ is scored by its authors: road, parking, sidewalk, other ground, lane marking and
/// terrain are ground; vegetation, which is grass as well as bushes, and points without a class do
/// not count. Ground that is not judged is a miss.
Counts score(const LabelledScan& truth, const GroundMask& mask) {
  const std::set<int> ground{40, 44, 48, 49, 60, 72};
  const std::set<int> passed_over{kUnlabelled, kOutlier, kVegetation};
  Counts counts;
  for (std::size_t i = 0; i < truth.labels.size(); ++i) {
    if (passed_over.contains(truth.labels[i])) continue;
    const bool is_ground = ground.contains(truth.labels[i]);
    const bool said = mask.classes[i] == GroundClass::kGround;
    counts.hits += is_ground && said;
    counts.false_alarms += !is_ground && said;
    counts.misses += is_ground && !said;
  }
  return counts;
}

TEST(LabelledScan, PatchworkFindsTheGroundOfARealStreet) {
  if (!fs::exists(scanFolder())) {
    GTEST_SKIP() << "no " << scanFolder().string() << "; set HYDRABENCH_DATA";
  }
  const LabelledScan truth;
  ASSERT_EQ(truth.points.size(), 123389u);
  ASSERT_EQ(truth.labels.size(), truth.points.size());
  Patchwork patchwork{{}};
  for (int pass = 0; pass < 3; ++pass) {
    const Counts counts = score(truth, patchwork.segment(truth.scan()));
    fmt::print("{} hits {} false {} missed: P {:.4f} R {:.4f} F1 {:.4f}\n", counts.hits,
               counts.false_alarms, counts.misses, counts.precision(), counts.recall(),
               counts.f1());
  }
}

}  // namespace
}  // namespace hydrabench
