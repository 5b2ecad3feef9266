// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/lidar_pattern.h"

#include <cstdlib>
#include <numbers>

namespace hydrabench {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kColumns = 1800;  // both: 0.2 degrees at 10 turns a second

void appendLasers(int count, double first_deg, double step_deg, LidarPattern& pattern) {
  for (int i = 0; i < count; ++i) {
    pattern.elevations_rad.push_back((first_deg - i * step_deg) * kDegree);
  }
}

struct NamedPattern {
  const char* name;
  LidarPattern (*make)();
};
constexpr NamedPattern kPatterns[] = {{"vlp16", LidarPattern::vlp16},
                                      {"hdl64", LidarPattern::hdl64}};

}  // namespace

LidarModel LidarPattern::model() const {
  return {.columns = columns,
          .rows = static_cast<int>(elevations_rad.size()),
          .top_rad = elevations_rad.front(),
          .bottom_rad = elevations_rad.back()};
}

LidarPattern LidarPattern::vlp16() {
  LidarPattern pattern{.columns = kColumns, .elevations_rad = {}};
  appendLasers(16, 15, 2, pattern);
  return pattern;
}

LidarPattern LidarPattern::hdl64() {
  LidarPattern pattern{.columns = kColumns, .elevations_rad = {}};
  appendLasers(32, 2, 1.0 / 3, pattern);
  appendLasers(32, -8 - 5.0 / 6, 0.5, pattern);
  return pattern;
}

LidarPattern lidarPattern(const std::string& name) {
  for (const NamedPattern& pattern : kPatterns) {
    if (name == pattern.name) return pattern.make();
  }
  std::abort();  // configs are checked against the names
}

const std::vector<std::string>& lidarPatternNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const NamedPattern& pattern : kPatterns) result.push_back(pattern.name);
    return result;
  }();
  return names;
}

}  // namespace hydrabench
