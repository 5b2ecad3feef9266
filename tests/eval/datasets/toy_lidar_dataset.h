// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "core/types/random.h"
#include "tests/eval/datasets/toy_dataset.h"

namespace hydrabench {

/// The toy with a LiDAR at 20 Hz that is not synchronised with its camera at 10 Hz: two sweeps a
/// frame, none in frame 0; one of them without a single point.
class ToyLidarDataset : public ToyDataset {
 public:
  Frame frame(std::size_t index) const override {
    Frame frame = ToyDataset::frame(index);
    if (index == 0) return frame;
    frame.scans.push_back(scan(2 * index, frame.stamp_ns - 70'000'000));
    frame.scans.push_back(scan(2 * index + 1, frame.stamp_ns - 20'000'000));
    return frame;
  }

  bool with_lists = true;  ///< false: points only

 private:
  LidarScan scan(std::size_t number, std::int64_t stamp_ns) const {
    constexpr double kDegree = std::numbers::pi / 180;
    Random random(number);
    LidarScan scan;
    scan.stamp_ns = stamp_ns;
    scan.start_ns = stamp_ns - 50'000'000;
    scan.lidar = {.columns = 360,
                  .rows = 5,
                  .top_rad = 7.3 * kDegree,
                  .bottom_rad = (-8 - 5.0 / 6) * kDegree};
    scan.T_world_lidar = pose(3000 + number);
    scan.T_world_lidar_start = pose(2000 + number);
    if (number == 2) return scan;
    for (int i = 0; i < 40; ++i) {
      scan.points.emplace_back(random.normal(), random.normal(), random.normal());
      if (i == 7) scan.points.back().setZero();
      if (i == 8) scan.points.back().y() = std::numeric_limits<float>::quiet_NaN();
      if (!with_lists) continue;
      scan.intensity.push_back(static_cast<float>(random.uniform()));
      scan.rings.push_back(static_cast<std::uint16_t>(random.index(5)));
      scan.times.push_back(static_cast<float>(random.uniform()));
      scan.labels.push_back(static_cast<Label>(random.index(65536)));
    }
    return scan;
  }
};

/// A LiDAR alone.
class ToyLidarOnlyDataset : public ToyLidarDataset {
 public:
  const Camera& camera() const override { return none_; }
  bool hasGroundTruth() const override { return false; }
  Frame frame(std::size_t index) const override {
    Frame frame;
    frame.scans.push_back(ToyLidarDataset::frame(index + 1).scans.at(1));
    frame.stamp_ns = frame.scans[0].stamp_ns;
    frame.T_world_camera = frame.scans[0].T_world_lidar;
    return frame;
  }
  std::size_t numFrames() const override { return 3; }

 private:
  Camera none_;
};

}  // namespace hydrabench
