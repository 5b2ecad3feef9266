// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/image_io.h"

#include <cassert>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/io/jpeg_codec.h"
#include "core/io/png_codec.h"
#include "core/types/error.h"

namespace hydrabench {

Image<Rgb> readColorImage(const std::filesystem::path& path) {
  const std::string bytes = readFile(path);
  if (isPng(bytes)) return decodeColorPng(bytes, path.string());
  if (isJpeg(bytes)) return decodeJpeg(bytes, path.string());
  throw InputError(fmt::format("{}: neither a PNG nor a JPEG", path.string()));
}

Image<std::uint16_t> readGrayImage(const std::filesystem::path& path) {
  const std::string bytes = readFile(path);
  if (isPng(bytes)) return decodeGrayPng(bytes, path.string());
  if (isJpeg(bytes)) {
    throw InputError(
        fmt::format("{}: is a JPEG, which alters values; expected a grey PNG", path.string()));
  }
  throw InputError(fmt::format("{}: not a PNG", path.string()));
}

void writeColorPng(const std::filesystem::path& path, const Image<Rgb>& image) {
  assert(!image.empty());
  writeFileAtomic(path, encodePng(image));
}
void writeGrayPng(const std::filesystem::path& path, const Image<std::uint16_t>& image) {
  assert(!image.empty());
  writeFileAtomic(path, encodePng(image));
}
void writeGrayPng(const std::filesystem::path& path, const Image<std::uint8_t>& image) {
  assert(!image.empty());
  writeFileAtomic(path, encodePng(image));
}

}  // namespace hydrabench
