// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/folder_dataset.h"

#include <charconv>
#include <string_view>

#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "eval/datasets/dataset_config.h"
#include "eval/datasets/depth_image.h"
#include "eval/datasets/folder_layout.h"
#include "eval/datasets/frame_images.h"
#include "eval/datasets/ground_truth_io.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace layout = folder_layout;
namespace {

std::vector<std::map<InstanceId, Label>> readInstanceLabels(const fs::path& path,
                                                            std::size_t num_frames) {
  const std::string text = readFile(path);
  std::vector<std::map<InstanceId, Label>> labels(num_frames);
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || (number == 1 && line == layout::kInstanceLabelsHeader)) continue;

    std::int64_t values[3] = {};
    const char* at = line.data();
    const char* const stop = line.data() + line.size();
    bool good = true;
    for (int i = 0; i < 3 && good; ++i) {
      const auto [next, error] = std::from_chars(at, stop, values[i]);
      const bool separated = i < 2 ? next != stop && *next == ',' : next == stop;
      good = error == std::errc() && separated && values[i] >= 0;
      at = next + (i < 2 && separated ? 1 : 0);
    }
    if (!good || values[1] > 65535 || values[2] > 65535) {
      throw InputError(
          fmt::format("{}:{}: expected frame,instance,label in whole numbers, found '{}'",
                      path.string(), number, line));
    }
    if (values[0] >= static_cast<std::int64_t>(num_frames)) {
      throw InputError(fmt::format("{}:{}: frame {}, but there are {} poses", path.string(), number,
                                   values[0], num_frames));
    }
    labels[static_cast<std::size_t>(values[0])][static_cast<InstanceId>(values[1])] =
        static_cast<Label>(values[2]);
  }
  return labels;
}

}  // namespace

FolderDataset::FolderDataset(Config config)
    : config_(std::move(config)),
      camera_(config_.camera.value_or(Camera{})),
      poses_(readFolderPoses(config_.folder, config_.camera.has_value(), config_.lidar.has_value(),
                             config_.extrinsics)) {
  instance_labels_.resize(numFrames());
  if (config_.camera && has(layout::kInstances)) {
    instance_labels_ = readInstanceLabels(config_.folder / layout::kInstanceLabels, numFrames());
  }
  if (has(layout::kGroundTruth)) {
    ground_truth_ = readGroundTruth(config_.folder / layout::kGroundTruth);
  }
}

Frame FolderDataset::frame(std::size_t index) const {
  Frame frame;
  frame.stamp_ns = poses_.frames.at(index).stamp_ns;
  frame.T_world_camera = poses_.frames[index].T_world_camera;
  frame.camera = camera_;
  if (config_.camera) readImages(index, frame);
  for (std::size_t i = poses_.first_scan[index]; i < poses_.first_scan[index + 1]; ++i) {
    frame.scans.push_back(scan(poses_.scans[i]));
  }
  return frame;
}

void FolderDataset::readImages(std::size_t index, Frame& frame) const {
  if (has(layout::kColor)) {
    const fs::path jpeg = config_.folder / layout::image(layout::kColor, index, ".jpg");
    const fs::path png = config_.folder / layout::image(layout::kColor, index, ".png");
    frame.color = readCameraColor(fs::exists(jpeg) ? jpeg : png, camera_);
  }
  if (has(layout::kDepth)) readDepth(index, frame);
  if (has(layout::kLabels)) {
    const fs::path path = config_.folder / layout::image(layout::kLabels, index, ".png");
    frame.labels = widened(readCameraGray(path, camera_));
  }
  if (has(layout::kInstances)) readInstances(index, frame);
}

LidarScan FolderDataset::scan(const FolderScan& folder_scan) const {
  LidarScan scan = readScan(config_.folder / layout::scan(folder_scan.file), *config_.lidar);
  scan.start_ns = folder_scan.pose.start_ns;
  scan.stamp_ns = folder_scan.pose.stamp_ns;
  scan.T_world_lidar_start = folder_scan.pose.T_world_lidar_start;
  scan.T_world_lidar = folder_scan.pose.T_world_lidar;
  return scan;
}

void FolderDataset::readDepth(std::size_t index, Frame& frame) const {
  fs::path path = config_.folder / layout::image(layout::kDepth, index, ".pfm");
  if (fs::exists(path)) {
    frame.depth = readDepthPfm(path);
    requireSize(frame.depth, camera_, path);
  } else {
    path.replace_extension(".png");
    frame.depth = depthFromQuanta(readCameraGray(path, camera_), config_.depth_quantum_m);
  }
  if (config_.require_depth && !hasDepth(frame.depth)) {
    throw InputError(
        fmt::format("{}: depth is 0 (not measured) in every pixel; set require_depth: false to "
                    "accept such frames",
                    path.string()));
  }
}

void FolderDataset::readInstances(std::size_t index, Frame& frame) const {
  const fs::path path = config_.folder / layout::image(layout::kInstances, index, ".png");
  frame.instances = widened(readCameraGray(path, camera_));
  frame.instance_labels = instance_labels_[index];
  requireLabels(frame, path, layout::kInstanceLabels);
}

DatasetConfig readFolder(ConfigReader& reader, const fs::path& config_path) {
  FolderDataset::Config config;
  if (!config_path.empty()) {
    config.folder = config_path.parent_path();
    config.name = fs::absolute(config_path).parent_path().filename().string();
  }
  reader.field("name", config.name);
  reader.field("seed", config.seed);
  reader.path("folder", config.folder);
  if (reader.has("lidar")) {
    config.lidar = readLidarDescription(reader);
  } else if (fs::is_directory(config.folder / layout::kLidar)) {
    reader.fault("lidar", fmt::format("missing, expected rows, columns, top_deg and bottom_deg of "
                                      "the sensor: there is a folder {}",
                                      (config.folder / layout::kLidar).string()));
  }
  config.extrinsics = readExtrinsics(reader);
  // Without a camera, sweeps are frames; with neither, the camera is what is missing.
  if (reader.has("camera") || !config.lidar) readCamera(reader, config.camera.emplace());
  reader.field("depth_quantum_m", config.depth_quantum_m, {1e-9, 1});
  reader.field("require_depth", config.require_depth);
  readLabelSpace(reader, config.label_space);
  if (config.folder.empty() && config_path.empty()) {
    reader.fault("folder", "missing, expected where its files are: there is no config beside them");
  }
  reader.finish();
  return {.name = config.name, .seed = config.seed, .files = {config.folder}, .open = [config] {
            return std::make_unique<FolderDataset>(config);
          }};
}

}  // namespace hydrabench
