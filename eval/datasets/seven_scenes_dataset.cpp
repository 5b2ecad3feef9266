// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/seven_scenes_dataset.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/io/json_field.h"
#include "eval/datasets/dataset_config.h"
#include "eval/datasets/depth_image.h"
#include "eval/datasets/frame_images.h"
#include "eval/datasets/json_pose.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

constexpr double kDepthQuantum_m = 0.001;
constexpr std::uint16_t kInvalidDepth = 65535;  // 0 as well

/// Numbers of the files "frame-000123.depth.png".
std::vector<int> frameNumbers(const fs::path& folder) {
  constexpr std::string_view kPrefix = "frame-";
  constexpr std::string_view kSuffix = ".depth.png";
  std::vector<int> numbers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) continue;
    int number = 0;
    const char* end = name.data() + name.size() - kSuffix.size();
    const auto parsed = std::from_chars(name.data() + kPrefix.size(), end, number);
    if (parsed.ec == std::errc() && parsed.ptr == end) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

fs::path frameFile(const fs::path& folder, int number, const char* suffix) {
  return folder / fmt::format("frame-{:06d}{}", number, suffix);
}

Camera readIntrinsics(const fs::path& path) {
  std::istringstream stream(readFile(path));
  double k[9] = {};
  for (double& value : k) stream >> value;
  if (!stream || !(k[0] > 0) || !(k[4] > 0)) {
    throw InputError(fmt::format("{}: expected a 3 x 3 camera matrix", path.string()));
  }
  return {.fx = k[0], .fy = k[4], .cx = k[2], .cy = k[5]};
}

}  // namespace

SevenScenesDataset::SevenScenesDataset(Config config) : config_(std::move(config)) {
  numbers_ = frameNumbers(config_.frames);
  if (numbers_.empty()) {
    throw InputError(
        fmt::format("{}: no files frame-NNNNNN.depth.png in this folder", config_.frames.string()));
  }
  camera_ = readIntrinsics(config_.frames / "camera-intrinsics.txt");
  const auto first = readGrayImage(frameFile(config_.frames, numbers_.front(), ".depth.png"));
  camera_.width = first.width();
  camera_.height = first.height();
  if (!config_.instances.empty()) readInfo();
  for (const int number : numbers_) {
    ground_truth_.trajectory.push_back(
        {static_cast<std::int64_t>(std::llround(number * 1e9 / config_.rate_hz)),
         T_aligned_world_ * readPoseMatrix(frameFile(config_.frames, number, ".pose.txt"))});
  }
}

void SevenScenesDataset::readInfo() {
  const fs::path path = config_.instances / "info.json";
  const nlohmann::json json = parseJsonFile(path);
  const JsonField info(json, path.string() + ": ");
  const JsonField ids = info.at("ids");
  for (const auto& [id, name] : ids.json().items()) {
    const JsonField field = ids.at(id.c_str());
    const LabelSpace::Entry* entry = config_.label_space.find(std::string_view(field.text()));
    if (!entry) field.fail("a class of the label_space of the config");
    int number = 0;
    const auto parsed = std::from_chars(id.data(), id.data() + id.size(), number);
    if (parsed.ptr != id.data() + id.size()) field.complain("the key is no instance id");
    instance_labels_[number] = entry->label;
  }
  if (config_.align_to_floor) T_aligned_world_ = readPose(info.at("T_aligned_world"));
}

Frame SevenScenesDataset::frame(std::size_t index) const {
  const int number = numbers_.at(index);
  Frame frame;
  frame.stamp_ns = ground_truth_.trajectory[index].stamp_ns;
  frame.T_world_camera = ground_truth_.trajectory[index].T_world_camera;
  frame.camera = camera_;
  const fs::path jpeg = frameFile(config_.frames, number, ".color.jpg");
  frame.color = readCameraColor(
      fs::exists(jpeg) ? jpeg : frameFile(config_.frames, number, ".color.png"), camera_);
  const fs::path depth = frameFile(config_.frames, number, ".depth.png");
  Image<std::uint16_t> quanta = readCameraGray(depth, camera_);
  std::replace(quanta.begin(), quanta.end(), kInvalidDepth, std::uint16_t{0});
  frame.depth = depthFromQuanta(quanta, kDepthQuantum_m);
  if (!hasDepth(frame.depth)) {
    throw InputError(
        fmt::format("{}: depth is invalid (0 or 65535) in every pixel", depth.string()));
  }
  if (config_.instances.empty()) return frame;

  const fs::path instances = frameFile(config_.instances, number, ".instance.png");
  frame.instances = widened(readCameraGray(instances, camera_));
  frame.instance_labels = instance_labels_;
  requireLabels(frame, instances, "info.json");
  frame.instance_labels = occurring(frame.instances, instance_labels_);
  frame.labels = Image<Label>(camera_.width, camera_.height, kUnknownLabel);
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const InstanceId id = frame.instances.data()[i];
    if (id != kNoInstance) frame.labels.data()[i] = instance_labels_.at(id);
  }
  return frame;
}

DatasetConfig readSevenScenes(ConfigReader& reader, const fs::path&) {
  SevenScenesDataset::Config config;
  const fs::path root = readDataRoot(reader);
  std::string frames = "rgbd/7scenes";
  std::string instances;
  reader.field("name", config.name);
  reader.field("frames", frames);
  reader.field("instances", instances);
  reader.field("align_to_floor", config.align_to_floor);
  reader.field("rate_hz", config.rate_hz, {0.001, 10000});
  readLabelSpace(reader, config.label_space);
  config.frames = root / frames;
  if (!instances.empty()) config.instances = root / instances;
  requireFolder(reader, "frames", root, config.frames);
  if (!instances.empty()) requireFolder(reader, "instances", root, config.instances);
  reader.finish();
  DatasetConfig dataset;
  dataset.name = config.name;
  dataset.files.push_back(config.frames);
  if (!instances.empty()) dataset.files.push_back(config.instances);
  dataset.open = [config] { return std::make_unique<SevenScenesDataset>(config); };
  return dataset;
}

}  // namespace hydrabench
