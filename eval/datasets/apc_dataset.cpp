// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/apc_dataset.h"

#include <charconv>

#include "core/io/json_field.h"
#include "eval/datasets/dataset_config.h"
#include "eval/datasets/depth_image.h"
#include "eval/datasets/frame_images.h"
#include "eval/datasets/json_pose.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

constexpr double kDepthQuantum_m = 0.0001;
constexpr std::int64_t kFrameInterval_ns = 1'000'000'000;  // views have no times: one a second

constexpr Rgb kPalette[] = {{230, 80, 60},  {70, 150, 230}, {90, 200, 90},
                            {240, 190, 50}, {160, 90, 200}, {60, 200, 190}};

/// The thresholds stand in a sentence of info.json: {'name': 0.31, ...}.
double thresholdIn(const JsonField& sentence, const std::string& name) {
  const std::string text = sentence.text();
  const std::string key = "'" + name + "': ";
  const std::size_t at = text.find(key);
  double threshold = 0;
  if (at == std::string::npos ||
      std::from_chars(text.data() + at + key.size(), text.data() + text.size(), threshold).ec !=
          std::errc()) {
    sentence.complain("no threshold for " + name);
  }
  return threshold;
}

}  // namespace

ApcDataset::ApcDataset(Config config) : config_(std::move(config)) {
  readInfo();
  while (true) {
    const auto index = trajectory().size();
    const fs::path pose = config_.folder / fmt::format("pose/{:06d}.txt", index);
    if (!fs::exists(pose)) break;
    ground_truth_.trajectory.push_back(
        {static_cast<std::int64_t>(index) * kFrameInterval_ns, readPoseMatrix(pose)});
  }
  if (trajectory().empty()) {
    throw InputError(fmt::format("{}: no files pose/NNNNNN.txt", config_.folder.string()));
  }
}

void ApcDataset::readInfo() {
  const fs::path path = config_.folder / "info.json";
  const nlohmann::json json = parseJsonFile(path);
  const JsonField info(json, path.string() + ": ");
  const JsonField k = info.at("K_color");
  const auto element = [&](std::size_t row, std::size_t column) {
    if (k.size() != 3 || k.item(row).size() != 3) k.fail("a 3 x 3 camera matrix");
    return k.item(row).item(column).number();
  };
  camera_.width = static_cast<int>(info.at("width").unsignedInteger());
  camera_.height = static_cast<int>(info.at("height").unsignedInteger());
  camera_.fx = element(0, 0);
  camera_.fy = element(1, 1);
  camera_.cx = element(0, 2);
  camera_.cy = element(1, 2);

  const JsonField ids = info.at("ids");
  label_space_.entries.push_back({kUnknownLabel, "unknown", {32, 32, 32}, false, false});
  for (const auto& [id, name] : ids.json().items()) {
    const JsonField field = ids.at(id.c_str());
    Item item{.name = field.text()};
    const auto parsed = std::from_chars(id.data(), id.data() + id.size(), item.id);
    if (parsed.ptr != id.data() + id.size() || item.id <= 0 || item.id > 255) {
      field.complain("the key is no instance id");
    }
    if (config_.masks == Masks::kPredicted) {
      item.threshold = thresholdIn(info.at("fcn_prob"), item.name);
    }
    label_space_.entries.push_back(
        {item.id, item.name, kPalette[items_.size() % std::size(kPalette)], true, false});
    items_.push_back(std::move(item));
  }
}

Image<InstanceId> ApcDataset::predictedMasks(std::size_t index) const {
  Image<InstanceId> instances(camera_.width, camera_.height, kNoInstance);
  Image<std::uint16_t> best(camera_.width, camera_.height, 0);
  for (const Item& item : items_) {
    const fs::path path = config_.folder / fmt::format("fcn_prob/{:06d}.{}.png", index, item.name);
    const Image<std::uint16_t> probability = readCameraGray(path, camera_);
    for (std::size_t i = 0; i < probability.size(); ++i) {
      const std::uint16_t p = probability.data()[i];
      if (p > item.threshold * 255 && p > best.data()[i]) {
        best.data()[i] = p;
        instances.data()[i] = item.id;
      }
    }
  }
  return instances;
}

Frame ApcDataset::frame(std::size_t index) const {
  Frame frame;
  frame.stamp_ns = trajectory().at(index).stamp_ns;
  frame.T_world_camera = trajectory()[index].T_world_camera;
  frame.camera = camera_;
  const std::string file = fmt::format("{:06d}.png", index);
  frame.color = readCameraColor(config_.folder / "color" / file, camera_);
  const fs::path depth = config_.folder / "depth" / file;
  frame.depth = depthFromQuanta(readCameraGray(depth, camera_), kDepthQuantum_m);
  if (!hasDepth(frame.depth)) {
    throw InputError(fmt::format("{}: depth is 0 (not measured) in every pixel", depth.string()));
  }
  const fs::path instances = config_.folder / "instance" / file;
  frame.instances = config_.masks == Masks::kPredicted
                        ? predictedMasks(index)
                        : widened(readCameraGray(instances, camera_));
  for (const Item& item : items_) frame.instance_labels[item.id] = item.id;
  requireLabels(frame, instances, "info.json");
  frame.instance_labels = occurring(frame.instances, frame.instance_labels);
  frame.labels = frame.instances;  // one item of each kind: its id is its label
  return frame;
}

DatasetConfig readApc(ConfigReader& reader, const fs::path&) {
  ApcDataset::Config config;
  std::string folder = "instances/apc2016_shelf_scene0000";
  std::string masks = "ground_truth";
  const fs::path root = readDataRoot(reader);
  reader.field("name", config.name);
  reader.field("folder", folder);
  reader.choice("masks", masks, {"ground_truth", "predicted"});
  config.folder = root / folder;
  config.masks =
      masks == "predicted" ? ApcDataset::Masks::kPredicted : ApcDataset::Masks::kGroundTruth;
  requireFolder(reader, "folder", root, config.folder);
  reader.finish();
  return {.name = config.name, .files = {config.folder}, .open = [config] {
            return std::make_unique<ApcDataset>(config);
          }};
}

}  // namespace hydrabench
