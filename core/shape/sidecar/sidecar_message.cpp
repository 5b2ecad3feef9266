// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sidecar/sidecar_message.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr std::string_view kMagic = "S3D1";
constexpr std::size_t kPrefix = 8;  // magic and length
constexpr std::size_t kMaxHeader = std::size_t{1} << 20;
constexpr std::size_t kMaxBlobs = std::size_t{1} << 30;

std::size_t sizeOf(const std::string& dtype) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 3> kTypes = {
      {{"u1", 1}, {"u4", 4}, {"f4", 4}}};
  for (const auto& [name, size] : kTypes) {
    if (dtype == name) return size;
  }
  throw InputError(fmt::format("a blob has the dtype '{}', expected u1, u4 or f4", dtype));
}

/// Conversions would take -1 and 1e300 for some number, too.
std::size_t countOf(const nlohmann::json& value) {
  if (!value.is_number_unsigned()) {
    throw InputError(fmt::format("a header has {} for a length, expected a whole number from 0 on",
                                 value.dump()));
  }
  return value.get<std::size_t>();
}

/// Shape and size of a blob as its entry in the header states them.
SidecarMessage::Blob described(const nlohmann::json& entry, std::size_t& bytes) {
  SidecarMessage::Blob blob;
  blob.name = entry.at("name").get<std::string>();
  blob.dtype = entry.at("dtype").get<std::string>();
  std::size_t count = sizeOf(blob.dtype);
  for (const nlohmann::json& length : entry.at("shape")) {
    blob.shape.push_back(countOf(length));
    if (blob.shape.back() > 0 && count > kMaxBlobs / blob.shape.back()) {
      throw InputError(fmt::format("blob '{}' is larger than {} bytes", blob.name, kMaxBlobs));
    }
    count *= blob.shape.back();
  }
  bytes = countOf(entry.at("bytes"));
  if (bytes != count) {
    throw InputError(fmt::format("blob '{}' states {} bytes, expected {}, from dtype and shape",
                                 blob.name, bytes, count));
  }
  return blob;
}

}  // namespace

const SidecarMessage::Blob* SidecarMessage::find(std::string_view name) const {
  const auto found =
      std::find_if(blobs.begin(), blobs.end(), [&](const Blob& blob) { return blob.name == name; });
  return found == blobs.end() ? nullptr : &*found;
}

std::string encode(const SidecarMessage& message) {
  nlohmann::json header = message.header;
  header["blobs"] = nlohmann::json::array();
  for (const SidecarMessage::Blob& blob : message.blobs) {
    header["blobs"].push_back({{"name", blob.name},
                               {"dtype", blob.dtype},
                               {"shape", blob.shape},
                               {"bytes", blob.bytes.size()}});
  }
  const std::string text = header.dump();
  std::string bytes(kMagic);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(static_cast<std::uint32_t>(text.size()) >> shift & 0xff);
  }
  bytes += text;
  for (const SidecarMessage::Blob& blob : message.blobs) bytes += blob.bytes;
  return bytes;
}

std::optional<SidecarMessage> SidecarReader::next() {
  const std::string_view given(bytes_);
  const std::string_view magic = given.substr(0, kMagic.size());
  if (magic != kMagic.substr(0, magic.size())) {
    throw InputError("a message does not begin with 'S3D1'");
  }
  if (given.size() < kPrefix) return std::nullopt;
  std::size_t header_size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    header_size |= static_cast<std::size_t>(static_cast<unsigned char>(given[4 + i])) << (8 * i);
  }
  if (header_size > kMaxHeader) {
    throw InputError(
        fmt::format("a header of {} bytes, expected at most {}", header_size, kMaxHeader));
  }
  if (given.size() < kPrefix + header_size) return std::nullopt;
  SidecarMessage message;
  std::vector<std::size_t> sizes;
  std::size_t total = kPrefix + header_size;
  try {
    message.header = nlohmann::json::parse(given.substr(kPrefix, header_size));
    for (const nlohmann::json& entry : message.header.at("blobs")) {
      std::size_t size = 0;
      message.blobs.push_back(described(entry, size));
      sizes.push_back(size);
      total += size;
      if (total > kMaxBlobs) {
        throw InputError(fmt::format("a message is larger than {} bytes", kMaxBlobs));
      }
    }
    message.header.erase("blobs");
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("a header is not as expected: {}", error.what()));
  }
  if (given.size() < total) return std::nullopt;
  std::size_t at = kPrefix + header_size;
  for (std::size_t i = 0; i < sizes.size(); at += sizes[i++]) {
    message.blobs[i].bytes = given.substr(at, sizes[i]);
  }
  bytes_.erase(0, total);
  return message;
}

}  // namespace hydrabench
