// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/lidar/camera_points.h"
#include "core/types/frame.h"

namespace hydrabench {

/// Depth images from lidar points, for whatever wants the depth of a camera's pixels (paper:
/// "I_depth is the depth image obtained from either an RGBD camera or a LiDAR point cloud projected
/// onto the image plane").
class LidarDepth {
 public:
  struct Config {
    int scans = 5;  ///< the last so many are projected, each by its own pose
    OcclusionConfig occlusion = {};
    /// Pixels without a point take the depth of the nearest one that is at most so far away and of
    /// the same instance, the upper left of equals: a lidar has few rows on an object. 0: none do.
    int fill_px = 8;
  };
  explicit LidarDepth(const Config& config) : config_(config) {}

  /// @param points  of a scan, in the frame of T_world_points
  void add(std::vector<Eigen::Vector3f> points, const Transform& T_world_points);
  /// z-depth [m] per pixel of the frame's camera; 0: no point nearby.
  Image<float> depth(const Frame& frame) const;

 private:
  struct Scan {
    std::vector<Eigen::Vector3f> points;
    Transform T_world_points;
  };
  Config config_;
  std::deque<Scan> scans_;
};

void read(ConfigReader& reader, LidarDepth::Config& config);

/// Copies depth over gaps, see LidarDepth::Config::fill_px.
/// @param instances  of the same size, or empty: then one instance fills the image
Image<float> filledDepth(const Image<float>& depth, const Image<InstanceId>& instances,
                         int radius_px);

}  // namespace hydrabench
