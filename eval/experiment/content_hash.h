// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace hydrabench {

/// SHA-256 over a list of fields. Each field enters with its length, so that "ab", "c" and "a",
/// "bc" differ.
class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  ContentHash& add(std::string_view field);
  /// Name and content of a file, or of every file below a folder. Throws InputError where nothing
  /// is there.
  ContentHash& addContent(const std::filesystem::path& path);
  /// Name, size and time of the last change of the same files: for recordings of many gigabytes.
  ContentHash& addStamp(const std::filesystem::path& path);
  std::string hex();  ///< 64 digits; once

 private:
  struct Digest;
  std::unique_ptr<Digest> digest_;
};

/// Of the program that runs: any change to the code changes it.
const std::string& programHash();

}  // namespace hydrabench
