// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string>
#include <sys/mount.h>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A file system of 64 KiB. Only the superuser may mount one.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& path) : path_(path) {
    fs::create_directories(path_);
    mounted_ = ::mount("tmpfs", path_.c_str(), "tmpfs", 0, "size=64k") == 0;
    if (!mounted_) reason_ = std::strerror(errno);
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool mounted() const { return mounted_; }
  const std::string& reason() const { return reason_; }

 private:
  fs::path path_;
  bool mounted_ = false;
  std::string reason_;
};

/// Files of this process may not grow beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

Image<Rgb> noise(int width, int height) {
  Image<Rgb> image(width, height);
  Random random(1);
  for (Rgb& pixel : image) {
    const std::uint64_t bits = random.bits();
    pixel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
             static_cast<std::uint8_t>(bits >> 16)};
  }
  return image;
}

TEST(DiskFull, FileIsRefusedAndNothingIsLeft) {
  TemporaryFolder folder;
  SmallDisk disk(folder / "disk");
  if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small file system: " << disk.reason();
  writeFileAtomic(folder / "disk/kept.txt", "kept");
  EXPECT_EQ(messageOf<OutputError>(
                [&] { writeFileAtomic(folder / "disk/large.bin", std::string(1 << 20, 'x')); }),
            (folder / "disk/large.bin").string() + ": cannot write: No space left on device");
  EXPECT_THAT(
      messageOf<OutputError>([&] { writeColorPng(folder / "disk/kept.txt", noise(300, 300)); }),
      HasSubstr("kept.txt: cannot write: No space left on device"));
  EXPECT_EQ(readFile(folder / "disk/kept.txt"), "kept");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "disk"), fs::directory_iterator()), 1);
}

TEST(DiskFull, FolderDoesNotAppearHalfWritten) {
  TemporaryFolder folder;
  SmallDisk disk(folder / "disk");
  if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small file system: " << disk.reason();
  const auto write = [&] {
    AtomicFolder result(folder / "disk/out");
    for (int i = 0; i < 100; ++i) {
      writeFileAtomic(result.temporary() / std::to_string(i), std::string(4096, 'x'));
    }
    result.commit();
  };
  EXPECT_THAT(messageOf<OutputError>(write), HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_empty(folder / "disk"));
}

TEST(DiskFull, FileSizeLimitLeavesTheOldFileAndNoTemporaryOne) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "file.bin", "old");
  const FileSizeLimit limit(10'000);
  EXPECT_THAT(messageOf<OutputError>(
                  [&] { writeFileAtomic(folder / "file.bin", std::string(20'000, 'x')); }),
              HasSubstr("file.bin: cannot write: File too large"));
  EXPECT_EQ(readFile(folder / "file.bin"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace hydrabench
