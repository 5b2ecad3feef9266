// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "eval/app/app.h"
#include "eval/experiment/provenance.h"

namespace hydrabench {

Command addVersion(CLI::App&) {
  return [] {
    fmt::print("hydrabench {}\n", versionLine(currentProvenance(commandLine())));
    return kDone;
  };
}

}  // namespace hydrabench
