// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/provenance.h"

#include <chrono>
#include <fstream>
#include <sys/utsname.h>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "build_info.h"

namespace hydrabench {
namespace {

std::string cpuModel() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string systemName() {
  utsname names{};
  if (uname(&names) != 0) return "unknown";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

}  // namespace

Provenance currentProvenance(const std::string& command) {
  Provenance provenance;
  provenance.version = kBuildVersion;
  provenance.commit = kBuildCommit;
  provenance.dirty = kBuildDirty;
  provenance.compiler = kBuildCompiler;
  provenance.flags = kBuildFlags;
  provenance.cpu = cpuModel();
  provenance.cores = static_cast<int>(std::thread::hardware_concurrency());
  provenance.system = systemName();
  provenance.command = command;
  provenance.started_utc = fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
  return provenance;
}

std::string provenanceJson(const Provenance& provenance) {
  const nlohmann::ordered_json json = {
      {"version", provenance.version}, {"commit", provenance.commit},
      {"dirty", provenance.dirty},     {"compiler", provenance.compiler},
      {"flags", provenance.flags},     {"cpu", provenance.cpu},
      {"cores", provenance.cores},     {"system", provenance.system},
      {"command", provenance.command}, {"started_utc", provenance.started_utc},
  };
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string versionLine(const Provenance& provenance) {
  return fmt::format("{} ({}{}), {}, {}", provenance.version, provenance.commit.substr(0, 10),
                     provenance.dirty ? ", dirty" : "", provenance.compiler, provenance.flags);
}

}  // namespace hydrabench
