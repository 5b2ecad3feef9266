// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "core/geometry/camera.h"
#include "core/types/error.h"
#include "core/types/frame.h"
#include "core/types/image.h"

namespace hydrabench {

/// Throws InputError unless an image has the size of the camera.
template <typename Pixel>
void requireSize(const Image<Pixel>& image, const Camera& camera,
                 const std::filesystem::path& path) {
  if (image.width() == camera.width && image.height() == camera.height) return;
  throw InputError(fmt::format("{}: image is {} x {}, the camera {} x {} pixels", path.string(),
                               image.width(), image.height(), camera.width, camera.height));
}

/// Reads a colour or integer image of the camera's size.
Image<Rgb> readCameraColor(const std::filesystem::path& path, const Camera& camera);
Image<std::uint16_t> readCameraGray(const std::filesystem::path& path, const Camera& camera);

/// The same numbers in another type.
Image<std::int32_t> widened(const Image<std::uint16_t>& image);

/// Throws InputError naming the file and the id for an instance without a label.
void requireLabels(const Frame& frame, const std::filesystem::path& instances,
                   const char* where_labels_stand);

/// Only those of `labels` whose instance occurs in the image.
std::map<InstanceId, Label> occurring(const Image<InstanceId>& instances,
                                      const std::map<InstanceId, Label>& labels);

}  // namespace hydrabench
