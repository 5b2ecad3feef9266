// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"
#include "eval/datasets/folder_poses.h"
#include "eval/datasets/lidar_files.h"

namespace hydrabench {

/// A dataset in plain files: images, LiDAR scans, poses, ground-truth meshes (docs/datasets.md).
/// What exportDataset writes, and the easiest form to bring own data in. A frame is read when it is
/// asked for.
class FolderDataset : public Dataset {
 public:
  struct Config {
    std::filesystem::path folder;
    std::string name = "folder";
    std::uint64_t seed = 0;        ///< of the generated world it was exported from; 0: none
    std::optional<Camera> camera;  ///< none: every sweep of the LiDAR is a frame
    std::optional<LidarDescription> lidar;  ///< none: no scans
    Extrinsics extrinsics;
    double depth_quantum_m = 0.001;  ///< depth of one unit in depth/*.png
    bool require_depth = true;       ///< a frame without any depth is a fault
    LabelSpace label_space;
  };
  /// Throws InputError naming the file at fault.
  explicit FolderDataset(Config config);

  std::string name() const override { return config_.name; }
  std::uint64_t seed() const override { return config_.seed; }
  const LabelSpace& labelSpace() const override { return config_.label_space; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return poses_.frames.size(); }
  Frame frame(std::size_t index) const override;
  const GroundTruth& groundTruth() const override { return ground_truth_; }
  bool hasGroundTruth() const override { return !ground_truth_.objects.empty(); }

 private:
  bool has(const char* kind) const { return std::filesystem::is_directory(config_.folder / kind); }
  void readDepth(std::size_t index, Frame& frame) const;
  void readInstances(std::size_t index, Frame& frame) const;

  void readImages(std::size_t index, Frame& frame) const;
  LidarScan scan(const FolderScan& scan) const;

  Config config_;
  Camera camera_;
  FolderPoses poses_;
  std::vector<std::map<InstanceId, Label>> instance_labels_;  ///< per frame
  GroundTruth ground_truth_;
};

DatasetConfig readFolder(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench
