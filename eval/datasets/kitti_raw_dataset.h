// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"

namespace hydrabench {

/// Real scans of a KITTI raw drive (Geiger et al., IJRR 2013): NNNNNNNNNN.bin, and a file of poses,
/// line N for scan N. Every scan is a frame; there is no camera, and T_world_camera is the pose of
/// the LiDAR. The sensor turned for 0.1 s while the car moved, and nothing undoes that: the files
/// do not tell when a point was measured. No ground truth.
class KittiRawDataset : public Dataset {
 public:
  struct Config {
    std::filesystem::path scans;
    std::filesystem::path poses;
    std::string name = "kitti_raw";
    double rate_hz = 10;  ///< scan numbers count turns of the sensor
    /// Of the HDL-64E as it stands on KITTI's car; 0.18 degrees a column.
    LidarModel lidar = {.columns = 2000,
                        .rows = 64,
                        .top_rad = 2.5 * (std::numbers::pi / 180),
                        .bottom_rad = -24.5 * (std::numbers::pi / 180)};
    LabelSpace label_space;
  };
  /// Throws InputError naming the file at fault.
  explicit KittiRawDataset(Config config);

  std::string name() const override { return config_.name; }
  const LabelSpace& labelSpace() const override { return config_.label_space; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return numbers_.size(); }
  Frame frame(std::size_t index) const override;
  const GroundTruth& groundTruth() const override { return ground_truth_; }
  bool hasGroundTruth() const override { return false; }

 private:
  Config config_;
  Camera camera_;                     ///< none
  std::vector<std::size_t> numbers_;  ///< of the scans, ascending
  GroundTruth ground_truth_;
};

/// Which laser measured each point, 0 the highest: KITTI's files hold laser after laser, each
/// counterclockwise from straight ahead. Empty where that gives more than `rows` lasers, so that
/// the file cannot be in this order.
std::vector<std::uint16_t> ringsByOrder(const std::vector<Eigen::Vector3f>& points, int rows);

DatasetConfig readKittiRaw(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench
