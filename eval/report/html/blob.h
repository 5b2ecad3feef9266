// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace hydrabench {

/// Gzip at the highest level; the bytes depend on the content alone (and on the version of zlib).
std::string gzipped(std::string_view bytes);
/// The way back. Throws InputError for what is no complete gzip stream.
std::string gunzipped(std::string_view bytes);
std::string base64(std::string_view bytes);

/// Pieces of data one after another, each kept once however often it is added: rows of a table that
/// differ in one decision share most of their shapes.
class BlobPool {
 public:
  struct Piece {
    std::size_t offset = 0;  ///< [bytes]
    std::size_t size = 0;
  };
  Piece add(const std::string& bytes);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::unordered_map<std::string, Piece> pieces_;
};

}  // namespace hydrabench
