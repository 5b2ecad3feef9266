// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void cannotWrite(const fs::path& path, const std::string& why) {
  throw OutputError(fmt::format("{}: cannot write: {}", path.string(), why));
}

/// A name in the same folder (rename works only within a file system) that no other thread or
/// process uses.
fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  fs::path temporary = path;
  temporary.replace_filename(
      fmt::format(".{}.{}-{}.partial", path.filename().string(), ::getpid(), counter++));
  return temporary;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) cannotWrite(folder, error.message());
}

/// Folders that are being filled: their files need not reach the disk before commit().
class OpenFolders {
 public:
  void add(const fs::path& folder) {
    const std::lock_guard lock(mutex_);
    folders_.push_back(folder.string() + "/");
  }
  void remove(const fs::path& folder) {
    const std::lock_guard lock(mutex_);
    std::erase(folders_, folder.string() + "/");
  }
  bool contain(const fs::path& file) {
    const std::string name = file.string();
    const std::lock_guard lock(mutex_);
    return std::any_of(folders_.begin(), folders_.end(),
                       [&](const std::string& folder) { return name.starts_with(folder); });
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> folders_;
};
OpenFolders& openFolders() {
  static OpenFolders folders;
  return folders;
}

/// Everything below `folder` (and whatever else its file system holds back) to the disk.
void flushFolder(const fs::path& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) cannotWrite(folder, reason(errno));
  const int error = ::syncfs(handle) == 0 ? 0 : errno;
  ::close(handle);
  if (error != 0 && error != EINVAL) cannotWrite(folder, reason(error));
}

/// A file being written; removed unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& final_path)
      : final_path_(final_path), path_(temporaryBeside(final_path)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0) cannotWrite(final_path_, reason(errno));
  }
  ~TemporaryFile() {
    if (file_ >= 0) ::close(file_);
    if (!renamed_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(file_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) cannotWrite(final_path_, reason(errno));
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Some file systems report a full disk only when the data is flushed or the file closed.
  void finish() {
    // EINVAL: a file system that cannot flush; there is nothing more to be done then.
    const bool flush = !openFolders().contain(final_path_);
    if (flush && ::fsync(file_) != 0 && errno != EINVAL) cannotWrite(final_path_, reason(errno));
    if (::close(std::exchange(file_, -1)) != 0) cannotWrite(final_path_, reason(errno));
    if (::rename(path_.c_str(), final_path_.c_str()) != 0) cannotWrite(final_path_, reason(errno));
    renamed_ = true;
  }

 private:
  const fs::path& final_path_;
  fs::path path_;
  int file_ = -1;
  bool renamed_ = false;
};

}  // namespace

std::string readFile(const fs::path& path) {
  const auto fail = [&](int error) {
    throw InputError(fmt::format("{}: cannot read: {}", path.string(), reason(error)));
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail(errno);
  std::string content;
  struct stat status {};
  if (::fstat(file, &status) == 0 && status.st_size > 0) {
    content.resize(static_cast<std::size_t>(status.st_size));
  }
  // The size is a hint only: pipes have none, and a file may grow.
  std::size_t used = 0;
  while (true) {
    if (used == content.size()) content.resize(used + 4096);
    const ssize_t got = ::read(file, content.data() + used, content.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      const int error = errno;
      ::close(file);
      fail(error);
    }
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  ::close(file);
  content.resize(used);
  return content;
}

void writeFileAtomic(const fs::path& path, std::string_view content) {
  if (path.has_parent_path()) makeFolder(path.parent_path());
  TemporaryFile file(path);
  file.write(content);
  file.finish();
}

AtomicFolder::AtomicFolder(fs::path path, std::string replaceable_marker)
    : path_(fs::absolute(path).lexically_normal()), replace_(!replaceable_marker.empty()) {
  if (!path_.has_filename()) path_ = path_.parent_path();  // "out/" is "out"
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw InputError(fmt::format("{}: is a file, expected a folder", path_.string()));
  }
  if (fs::is_directory(status) && !fs::is_empty(path_, error)) {
    if (!replace_) {
      throw InputError(fmt::format("{}: exists already and is not empty", path_.string()));
    }
    if (!fs::exists(path_ / replaceable_marker, error)) {
      throw InputError(
          fmt::format("{}: not replaced, for without a {} in it, it is nothing this command wrote",
                      path_.string(), replaceable_marker));
    }
  }
  temporary_ = temporaryBeside(path_);
  makeFolder(temporary_);
  openFolders().add(temporary_);
}

AtomicFolder::~AtomicFolder() {
  openFolders().remove(temporary_);
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
}

void AtomicFolder::commit() {
  std::error_code ignored;
  flushFolder(temporary_);
  // A plain rename replaces a missing or empty folder; a filled one changes places with ours, so
  // that at every moment one of the two stands complete under the final name.
  if (::rename(temporary_.c_str(), path_.c_str()) == 0) {
    committed_ = true;
    return;
  }
  const bool occupied = errno == ENOTEMPTY || errno == EEXIST;
  if (!occupied || !replace_) cannotWrite(path_, reason(errno));
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0) {
    committed_ = true;
    fs::remove_all(temporary_, ignored);
    return;
  }
  // File systems without exchange (some network ones): move the old folder aside, and back should
  // the second step fail.
  const fs::path old = temporaryBeside(path_);
  if (::rename(path_.c_str(), old.c_str()) != 0) cannotWrite(path_, reason(errno));
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    fs::rename(old, path_, ignored);
    cannotWrite(path_, reason(error));
  }
  committed_ = true;
  fs::remove_all(old, ignored);
}

}  // namespace hydrabench
