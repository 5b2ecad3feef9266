// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace hydrabench {

/// Progress on standard error: a bar with the time left on a terminal, a line at every tenth
/// otherwise. Thread-safe.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();  ///< ends the line
  void advance(std::size_t steps = 1);

 private:
  void draw(bool last);

  std::mutex mutex_;
  std::string label_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t printed_tenths_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_draw_;
};

/// "1:05", "2:03:04"; rounded up to seconds.
std::string durationText(double seconds);

}  // namespace hydrabench
