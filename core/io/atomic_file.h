// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hydrabench {

/// Whole file as bytes. Throws InputError naming the file.
std::string readFile(const std::filesystem::path& path);

/// Writes through a temporary file beside `path`, flushed to disk, then renamed: under the final
/// name stands the whole content or what was there before. Makes missing parent folders. Throws
/// OutputError naming the file and the system's reason.
void writeFileAtomic(const std::filesystem::path& path, std::string_view content);

/// A folder that appears under its final name complete or not at all: fill temporary(), then
/// commit(). Removed if not committed. Files that writeFileAtomic puts below temporary() are
/// flushed together by commit(), not one by one.
class AtomicFolder {
 public:
  /// A folder that is not empty is refused with InputError; or, given a `replaceable_marker`,
  /// swapped at commit if it holds a file of that name, the sign that the same command wrote it.
  explicit AtomicFolder(std::filesystem::path path, std::string replaceable_marker = "");
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool committed_ = false;
  bool replace_ = false;
};

}  // namespace hydrabench
