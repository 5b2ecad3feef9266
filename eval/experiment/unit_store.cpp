// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/unit_store.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;

fs::path UnitStore::runFolder(const std::string& hash) const {
  return root_ / "runs" / hash.substr(0, 2) / hash;
}
fs::path UnitStore::scoreFile(const std::string& hash) const {
  return root_ / "scores" / hash.substr(0, 2) / (hash + ".json");
}
fs::path UnitStore::failureFile(const std::string& hash) const {
  return root_ / "failures" / (hash + ".json");
}
fs::path UnitStore::lockFile(const std::string& hash) const { return root_ / "locks" / hash; }

bool UnitStore::isDone(const std::string& hash) const {
  return fs::exists(runFolder(hash)) || fs::exists(scoreFile(hash));
}

UnitStore::State UnitStore::state(const std::string& hash) const {
  if (isDone(hash)) return State::kDone;
  const int handle = ::open(lockFile(hash).c_str(), O_RDWR | O_CLOEXEC);
  if (handle >= 0) {
    const bool held = ::flock(handle, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(handle);
    if (held) return State::kRunning;
  }
  return fs::exists(failureFile(hash)) ? State::kFailed : State::kMissing;
}

UnitStore::Lock::Lock(const fs::path& file)
    : handle_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (handle_ < 0) {
    throw OutputError(fmt::format("{}: cannot lock: {}", file.string(), std::strerror(errno)));
  }
  // File systems without locks let everybody through: then work may be done twice, never wrongly.
  while (::flock(handle_, LOCK_EX) != 0 && errno == EINTR) continue;
}
UnitStore::Lock::~Lock() {
  if (handle_ >= 0) ::close(handle_);
}

UnitStore::Lock UnitStore::lock(const std::string& hash) const {
  std::error_code error;
  fs::create_directories(root_ / "locks", error);
  return Lock(lockFile(hash));
}

void UnitStore::requireWritable() const { writeFileAtomic(root_ / "locks/.writable", ""); }

void UnitStore::recordFailure(const std::string& hash, const std::string& message,
                              const Job& job) const {
  const nlohmann::ordered_json json = {{"message", message},
                                       {"job", nlohmann::ordered_json::parse(jobJson(job))}};
  writeFileAtomic(
      failureFile(hash),
      json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void UnitStore::clearFailure(const std::string& hash) const {
  std::error_code ignored;
  fs::remove(failureFile(hash), ignored);
}

std::optional<std::string> UnitStore::failure(const std::string& hash) const {
  const fs::path file = failureFile(hash);
  if (!fs::exists(file)) return std::nullopt;
  try {
    return nlohmann::json::parse(readFile(file)).at("message").get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a failure: {}", file.string(), error.what()));
  }
}

fs::path storeFolder(const fs::path& option) {
  if (!option.empty()) return option;
  const char* set = std::getenv("HYDRABENCH_STORE");
  return set && *set ? fs::path(set) : fs::path(".hydrabench") / "store";
}

}  // namespace hydrabench
