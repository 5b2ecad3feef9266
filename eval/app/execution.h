// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "eval/experiment/assemble.h"
#include "eval/experiment/plan.h"

namespace hydrabench {

/// How and where units are done; options of every command that does some.
struct Execution {
  std::filesystem::path store_option;
  std::string executor = "local";
  std::size_t jobs = 1;
  std::uint64_t memory_limit_mib = 0;
  std::vector<std::string> sbatch;
  bool count_instructions = false;  ///< run only

  UnitStore store() const { return UnitStore(storeFolder(store_option)); }
};
void addStore(CLI::App& app, std::filesystem::path& store);
void addExecution(CLI::App& app, Execution& execution);

/// Does what the plan still lacks, with progress and failures on standard error.
void carryOut(const Plan& plan, const Execution& execution);

/// What failed, and the command that does it again, on standard error and in failures.txt of the
/// folder; nothing without failures.
void tellFailures(const std::vector<UnitFailure>& failures, const Execution& execution,
                  const std::filesystem::path& folder);

/// For AtomicFolder: whether a result that stands there may be replaced. It may if it was asked
/// for, and where its failures.txt says that it is not whole. Whose result it is is not looked at.
std::string replaceableMarker(const std::filesystem::path& folder, bool replace);

}  // namespace hydrabench
