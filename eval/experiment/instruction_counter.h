// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hydrabench {

/// Counts the machine instructions that this process executes: a cost of a program that nothing
/// else on the machine disturbs, unlike its time. It needs a process that was started behind
/// launcher(): valgrind executes it (tool callgrind), one thread at a time and a few times slower,
/// many times slower while it counts.
class InstructionCounter {
 public:
  /// What goes before the command of a process that is to count.
  /// @param scratch  a folder that is there and that it may write to
  /// Throws InputError where valgrind is missing.
  static std::vector<std::string> launcher(const std::filesystem::path& scratch);
  /// Whether this process was started behind launcher().
  static bool isAvailable();

  void start();
  /// @return  executed since start(), by all threads
  std::uint64_t stop();
};

}  // namespace hydrabench
