// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hydrabench {

/// What made a result, for provenance.json: without it a number cannot be traced.
struct Provenance {
  std::string version;   ///< "0.1.0"
  std::string commit;    ///< full hash, or "unknown" outside a git checkout
  bool dirty = false;    ///< the checkout had uncommitted changes when it was built
  std::string compiler;  ///< "GNU 12.2.0"
  std::string flags;     ///< build type and flags of our own targets
  std::string cpu;       ///< model name
  int cores = 0;
  std::string system;       ///< "Linux 6.1.0 x86_64"
  std::string command;      ///< command line, where there is one
  std::string started_utc;  ///< ISO 8601
};

/// Of this build on this machine, now.
Provenance currentProvenance(const std::string& command);
std::string provenanceJson(const Provenance& provenance);
/// "0.1.0 (3f2c1ab, dirty), GNU 12.2.0, Release"
std::string versionLine(const Provenance& provenance);

}  // namespace hydrabench
