// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace hydrabench {

/// What the program and an estimator in another process say to each other (docs/sam3d.md): on a
/// stream of bytes the magic "S3D1", the length of the header as 32 bits, little-endian, the header
/// as JSON, then arrays in the order in which the header's "blobs" lists them by name, dtype ("u1",
/// "u4", "f4"), shape and number of bytes. Numbers are little-endian, rows first.
struct SidecarMessage {
  struct Blob {
    std::string name;
    std::string dtype;
    std::vector<std::size_t> shape;
    std::string bytes;
  };
  nlohmann::json header = nlohmann::json::object();  ///< without "blobs"
  std::vector<Blob> blobs;

  /// nullptr where there is none of that name.
  const Blob* find(std::string_view name) const;
};

std::string encode(const SidecarMessage& message);

/// Takes messages from a stream that comes in pieces.
class SidecarReader {
 public:
  void append(std::string_view bytes) { bytes_ += bytes; }
  /// nullopt until a whole message is there. Throws InputError where what came is none; nothing
  /// after that can be read.
  std::optional<SidecarMessage> next();
  bool empty() const { return bytes_.empty(); }

 private:
  std::string bytes_;
};

}  // namespace hydrabench
