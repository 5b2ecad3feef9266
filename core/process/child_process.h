// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace hydrabench {

/// Another program, with its standard input and output in our hands. It does not outlive us, nor
/// this object.
class ChildProcess {
 public:
  struct Config {
    std::vector<std::string> command;       ///< program, looked up in PATH, and its arguments
    std::uint64_t memory_limit_mib = 0;     ///< of its data; 0: none
    std::filesystem::path error_file = {};  ///< gets its standard error, appended; empty: ours
  };
  /// Throws OutputError where it cannot be started.
  explicit ChildProcess(const Config& config);
  ~ChildProcess();  ///< kills it if it still runs
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// False where it no longer reads.
  bool send(std::string_view bytes);

  using Deadline = std::chrono::steady_clock::time_point;
  enum class Io { kDone, kClosed, kLate };  ///< kClosed: it closed its end, or is gone
  /// The same as send() and receive(), but not longer than until the deadline: for programs that
  /// may hang. After kLate some of the bytes may have been sent.
  Io send(std::string_view bytes, Deadline deadline);
  /// Appends at least one byte to `received`, or none and says why.
  Io receive(std::string& received, Deadline deadline);

  void closeInput();
  /// To poll for output. -1 after its end.
  int outputHandle() const { return output_; }
  /// What it has said, waiting until there is something; nullopt: it has closed its output.
  std::optional<std::string> receive();
  void kill();

  struct Exit {
    int code = 0;
    int signal = 0;  ///< that ended it; 0: none
    bool ok() const { return code == 0 && signal == 0; }
    std::string text() const;  ///< "exit code 3", "killed by signal 9 (Killed)"
  };
  Exit wait();
  /// Not longer than until the deadline: then it is killed.
  Exit wait(Deadline deadline);

 private:
  pid_t pid_ = -1;
  int input_ = -1;
  int output_ = -1;
};

}  // namespace hydrabench
