// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/frame_images.h"

#include <algorithm>
#include <set>

#include "core/io/image_io.h"

namespace hydrabench {
namespace {

std::set<InstanceId> idsIn(const Image<InstanceId>& instances) {
  std::set<InstanceId> ids;
  InstanceId last = kNoInstance;
  for (const InstanceId id : instances) {
    if (id == last) continue;
    last = id;
    if (id != kNoInstance) ids.insert(id);
  }
  return ids;
}

}  // namespace

Image<Rgb> readCameraColor(const std::filesystem::path& path, const Camera& camera) {
  Image<Rgb> image = readColorImage(path);
  requireSize(image, camera, path);
  return image;
}

Image<std::uint16_t> readCameraGray(const std::filesystem::path& path, const Camera& camera) {
  Image<std::uint16_t> image = readGrayImage(path);
  requireSize(image, camera, path);
  return image;
}

Image<std::int32_t> widened(const Image<std::uint16_t>& image) {
  Image<std::int32_t> result(image.width(), image.height());
  std::copy(image.begin(), image.end(), result.begin());
  return result;
}

void requireLabels(const Frame& frame, const std::filesystem::path& instances,
                   const char* where_labels_stand) {
  for (const InstanceId id : idsIn(frame.instances)) {
    if (frame.instance_labels.contains(id)) continue;
    throw InputError(fmt::format("{}: instance {} has no label in {}", instances.string(), id,
                                 where_labels_stand));
  }
}

std::map<InstanceId, Label> occurring(const Image<InstanceId>& instances,
                                      const std::map<InstanceId, Label>& labels) {
  std::map<InstanceId, Label> result;
  for (const InstanceId id : idsIn(instances)) {
    const auto it = labels.find(id);
    if (it != labels.end()) result.insert(*it);
  }
  return result;
}

}  // namespace hydrabench
