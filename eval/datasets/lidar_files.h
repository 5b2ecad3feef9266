// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/config/config_reader.h"
#include "core/types/lidar_scan.h"

namespace hydrabench {

/// What all scans of a folder have in common.
struct LidarDescription {
  LidarModel model;
  bool intensity = true;  ///< false: the fourth number of a point says nothing
  bool rings = false;     ///< there are files .ring, .time, .label
  bool times = false;
  bool labels = false;

  friend bool operator==(const LidarDescription&, const LidarDescription&) = default;
};
/// By one scan. One without points does not tell which lists it would have.
LidarDescription describe(const LidarScan& scan);

/// Keys rows, columns, top_deg, bottom_deg: of a sensor that a config describes.
void readLidarModel(ConfigReader& reader, LidarModel& model);
/// Section `lidar` of dataset.yaml: the model and intensity, rings, times, labels.
LidarDescription readLidarDescription(ConfigReader& reader);
std::string lidarYaml(const LidarDescription& lidar);

// A scan is a few files of one name and one value per point each, little-endian without a header,
// so that one line of NumPy reads it:
//   .bin    x, y, z [m], intensity: 32-bit floats, as in KITTI
//   .ring   16-bit row of the sensor, 0 the highest
//   .time   32-bit float, 0 at the start of the sweep, 1 at its end
//   .label  32 bits, the class in the lower 16, as in SemanticKITTI

/// @param stem  path without extension
void writeScan(const std::filesystem::path& stem, const LidarScan& scan);
/// Files that `lidar` asks for and a scan without points did not write are made, empty.
void renameScan(const std::filesystem::path& from, const std::filesystem::path& to,
                const LidarDescription& lidar);
/// All but stamps and poses. Points that are not finite or lie at the origin are kept: they are no
/// fault. Throws InputError naming the file for a wrong number of bytes, a ring that the sensor
/// does not have, an intensity or a time outside of [0, 1].
LidarScan readScan(const std::filesystem::path& stem, const LidarDescription& lidar);

}  // namespace hydrabench
