// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "core/lidar/deskew.h"
#include "core/mapping/ground/patchwork.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

struct Counts {
  double hit = 0;
  double taken = 0;
  double there = 0;
  double f1() const { return 2 * hit / (taken + there); }
};

/// Of the points within 40 m, over every tenth sweep of the short campus. What is not judged is not
/// taken for ground.
Counts groundFound(const std::string& lidar, const std::string& settings) {
  SimulatedConfig config = SimulatedConfig::forWorld("campus_quick");
  config.seed = 101;
  config.lidar = LidarSensorConfig::forPattern(lidar, "default");
  config.lidar.enabled = true;
  config.lidar.labels = true;
  config.sensor.camera = {64, 48, 37, 37, 31.5, 23.5};  // nobody looks at it
  const SimulatedDataset campus(config);
  const std::vector<std::string> ground = campus.labelSpace().groundNames();
  Patchwork patchwork(Patchwork::Config::forSensor(settings));
  Counts counts;
  for (std::size_t i = 1; i < campus.numFrames(); i += 10) {
    for (const LidarScan& scan : campus.frame(i).scans) {
      const std::vector<Eigen::Vector3f> points = levelled(deskewed(scan), scan.T_world_lidar);
      const GroundMask mask = patchwork.segment({.stamp_ns = scan.stamp_ns,
                                                 .points = points,
                                                 .intensity = scan.intensity,
                                                 .lines = scan.rings,
                                                 .labels = {},
                                                 .sensor_height_m = 0.5});
      for (std::size_t p = 0; p < points.size(); ++p) {
        if (points[p].norm() > 40) continue;
        const bool taken = mask.classes[p] == GroundClass::kGround;
        const bool there = std::count(ground.begin(), ground.end(),
                                      campus.labelSpace().nameOf(scan.labels[p])) > 0;
        counts.taken += taken;
        counts.there += there;
        counts.hit += taken && there;
      }
    }
  }
  return counts;
}

TEST(CampusGroundSegmentation, IsFoundBySixtyFourBeams) {
  const Counts counts = groundFound("hdl64", "vlp16");
  EXPECT_GT(counts.there, 1e6);
  EXPECT_GT(counts.f1(), 0.95);
  RecordProperty("f1", std::to_string(counts.f1()));
}

TEST(CampusGroundSegmentation, IsFoundBySixteenBeams) {
  const Counts counts = groundFound("vlp16", "vlp16");
  EXPECT_GT(counts.there, 1e5);
  EXPECT_GT(counts.f1(), 0.95);
  RecordProperty("f1", std::to_string(counts.f1()));
}

}  // namespace
}  // namespace hydrabench
