// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/instruction_counter.h"

#include <cassert>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <valgrind/callgrind.h>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/process/find_program.h"
#include "core/shape/crisp/blas_kernel.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;

/// Where the tool leaves its dumps, up to the number of the dump.
constexpr const char* kDumpVariable = "HYDRABENCH_INSTRUCTION_DUMP";

/// Of a dump, its line "totals: N" (its "summary: N" is of the time since counting was stopped).
std::uint64_t totalOf(const fs::path& dump) {
  constexpr std::string_view kKey = "\ntotals: ";
  const std::string text = readFile(dump);
  const std::size_t at = text.rfind(kKey);
  if (at != std::string::npos) {
    std::uint64_t total = 0;
    const char* begin = text.data() + at + kKey.size();
    if (std::from_chars(begin, text.data() + text.size(), total).ec == std::errc()) return total;
  }
  throw InputError(
      fmt::format("{}: no total in there, expected a dump of callgrind", dump.string()));
}

}  // namespace

std::vector<std::string> InstructionCounter::launcher(const fs::path& scratch) {
  const std::string valgrind = findProgram("valgrind");
  if (valgrind.empty()) {
    throw InputError(
        "valgrind: not found in PATH, expected it to count instructions with (Debian package "
        "valgrind)");
  }
  const std::string dump = (fs::absolute(scratch) / "callgrind").string();
  std::vector<std::string> command = {"env", fmt::format("{}={}", kDumpVariable, dump)};
  // Valgrind knows no AVX-512; and the same kernel wherever it is counted.
  if (cpuFeatures().avx2) command.push_back("OPENBLAS_CORETYPE=Haswell");
  for (const std::string& argument :
       {valgrind, std::string("--quiet"), std::string("--tool=callgrind"),
        std::string("--instr-atstart=no"), fmt::format("--callgrind-out-file={}.%p", dump)}) {
    command.push_back(argument);
  }
  return command;
}

bool InstructionCounter::isAvailable() {
  return RUNNING_ON_VALGRIND != 0 && std::getenv(kDumpVariable) != nullptr;
}

void InstructionCounter::start() {
  assert(isAvailable());
  CALLGRIND_ZERO_STATS;
  CALLGRIND_START_INSTRUMENTATION;
}

std::uint64_t InstructionCounter::stop() {
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS;
  // Dumps are numbered; there is but the one.
  const fs::path stem = fmt::format("{}.{}", std::getenv(kDumpVariable), ::getpid());
  std::uint64_t total = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(stem.parent_path())) {
    if (!entry.path().filename().string().starts_with(stem.filename().string() + ".")) continue;
    total += totalOf(entry.path());
    fs::remove(entry.path());
  }
  return total;
}

}  // namespace hydrabench
