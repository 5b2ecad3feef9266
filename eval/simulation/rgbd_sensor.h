// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/config/config_reader.h"
#include "eval/simulation/depth_noise.h"
#include "eval/simulation/mask_corruption.h"
#include "eval/simulation/rgbd_renderer.h"

namespace hydrabench {

/// An RGB-D camera with an instance segmentation behind it, and everything that goes wrong in both.
struct RgbdSensorConfig {
  Camera camera = {720, 480, 415.7, 415.7, 360, 240};  ///< the uHumans2 camera
  double min_depth_m = 0.1;
  double max_depth_m = 5.0;
  double color_noise_levels = 2.0;  ///< sigma per channel, of 255
  DepthNoiseConfig depth_noise;
  MaskCorruptionConfig masks;

  static RgbdSensorConfig clean();  ///< exact depth, exact masks; ids are shuffled all the same
  static RgbdSensorConfig hard();
};
/// Puts a RealSense D455 in place of the camera, whatever the preset: its lens and baseline, depth
/// up to 6 m, beyond which its stereo matching fails, and errors that grow with the square of the
/// depth as its baseline has it. Where the preset has no noise there still is none.
void useOutdoorCamera(RgbdSensorConfig& config);

/// Sections camera, depth_noise and masks.
void read(ConfigReader& reader, RgbdSensorConfig& config);

/// Frame `index` as the sensor gives it at a time, which tells where the movers are: a pure
/// function of (scene, pose, config, seed, index, time). The reported pose is left to the caller.
Frame observe(const Scene& scene, const RgbdRenderer& renderer, const Transform& T_world_camera,
              const RgbdSensorConfig& config, std::uint64_t seed, std::size_t index,
              std::int64_t stamp_ns = 0);

}  // namespace hydrabench
