// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/transform.h"
#include "core/types/color.h"
#include "core/types/ids.h"
#include "core/types/image.h"
#include "core/types/lidar_scan.h"

namespace hydrabench {

/// What a method sees at one instant. All images have the size of the camera; an image may be empty
/// where a dataset has none.
struct Frame {
  std::int64_t stamp_ns = 0;
  Camera camera;
  Transform T_world_camera = Transform::Identity();  ///< as given by odometry, drift included
  Image<Rgb> color;
  Image<float> depth;   ///< z-depth [m]; 0: nothing measured
  Image<Label> labels;  ///< semantic class of each pixel; kUnknownLabel where none is known
  Image<InstanceId>
      instances;  ///< per-frame instance of each pixel; kNoInstance where there is none
  std::map<InstanceId, Label>
      instance_labels;  ///< class of every instance that occurs in `instances`
  /// Sweeps that ended after the frame before this one and not after stamp_ns, in the order of
  /// time.
  std::vector<LidarScan> scans;
};

}  // namespace hydrabench
