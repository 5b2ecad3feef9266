// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/kitti_raw_dataset.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/datasets/lidar_files.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// Numbers of the files "0000000042.bin".
std::vector<std::size_t> scanNumbers(const fs::path& folder) {
  std::vector<std::size_t> numbers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".bin") continue;
    const std::string stem = entry.path().stem().string();
    std::size_t number = 0;
    const auto parsed = std::from_chars(stem.data(), stem.data() + stem.size(), number);
    if (stem.size() == 10 && parsed.ptr == stem.data() + stem.size()) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

std::vector<std::uint16_t> ringsByOrder(const std::vector<Eigen::Vector3f>& points, int rows) {
  std::vector<std::uint16_t> rings;
  rings.reserve(points.size());
  int ring = 0;
  const Eigen::Vector3f* before = nullptr;
  for (const Eigen::Vector3f& point : points) {
    // From right of straight ahead to left of it; behind the car, the side changes the other way.
    if (before && before->y() < 0 && point.y() >= 0 && before->x() > 0 && point.x() > 0) ++ring;
    if (ring >= rows) return {};
    rings.push_back(static_cast<std::uint16_t>(ring));
    before = &point;
  }
  return rings;
}

KittiRawDataset::KittiRawDataset(Config config) : config_(std::move(config)) {
  numbers_ = scanNumbers(config_.scans);
  if (numbers_.empty()) {
    throw InputError(
        fmt::format("{}: no files NNNNNNNNNN.bin in this folder", config_.scans.string()));
  }
  const std::vector<Transform> poses = readKittiPoses(config_.poses);
  for (const std::size_t number : numbers_) {
    if (number >= poses.size()) {
      throw InputError(
          fmt::format("{}: {} poses, none for scan {}; expected one a line from scan 0 "
                      "on",
                      config_.poses.string(), poses.size(), number));
    }
    ground_truth_.trajectory.push_back({static_cast<std::int64_t>(std::llround(
                                            static_cast<double>(number) * 1e9 / config_.rate_hz)),
                                        poses[number]});
  }
}

Frame KittiRawDataset::frame(std::size_t index) const {
  const fs::path stem = config_.scans / fmt::format("{:010d}", numbers_.at(index));
  LidarScan scan = readScan(stem, {.model = config_.lidar});
  scan.rings = ringsByOrder(scan.points, config_.lidar.rows);
  Frame frame;
  frame.stamp_ns = ground_truth_.trajectory[index].stamp_ns;
  frame.T_world_camera = ground_truth_.trajectory[index].T_world_camera;
  scan.stamp_ns = scan.start_ns = frame.stamp_ns;
  scan.T_world_lidar = scan.T_world_lidar_start = frame.T_world_camera;
  frame.scans.push_back(std::move(scan));
  return frame;
}

DatasetConfig readKittiRaw(ConfigReader& reader, const fs::path&) {
  KittiRawDataset::Config config;
  std::string folder;
  std::string scans = "velodyne_points/data";
  std::string poses = "poses.txt";
  const fs::path root = readDataRoot(reader);
  reader.field("name", config.name);
  reader.require("folder");
  reader.field("folder", folder);
  reader.field("scans", scans);
  reader.field("poses", poses);
  reader.field("rate_hz", config.rate_hz, {0.001, 10000});
  ConfigReader lidar = reader.section("lidar");
  readLidarModel(lidar, config.lidar);
  readLabelSpace(reader, config.label_space);
  config.scans = root / folder / scans;
  config.poses = root / folder / poses;
  requireFolder(reader, "scans", root, config.scans);
  reader.finish();
  return {.name = config.name, .files = {config.scans, config.poses}, .open = [config] {
            return std::make_unique<KittiRawDataset>(config);
          }};
}

}  // namespace hydrabench
