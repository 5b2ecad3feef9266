// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace hydrabench {

/// What the process tells its caller (docs/reproduce.md).
enum ExitCode : int {
  kDone = 0,
  kGateFailed = 1,    ///< a claim, gate or self-test failed
  kBadInput = 2,      ///< bad input or usage
  kInconclusive = 3,  ///< too little data to decide
  kPartlyFailed = 4,  ///< a run failed while others finished
};

/// A subcommand: adds its options to `app` and returns what to do once they are parsed.
using Command = std::function<int()>;
Command addExport(CLI::App& app);
Command addView(CLI::App& app);
Command addMap(CLI::App& app);
Command addRun(CLI::App& app);
Command addEvaluate(CLI::App& app);
Command addEstimate(CLI::App& app);
Command addReport(CLI::App& app);
Command addSweep(CLI::App& app);
Command addStatus(CLI::App& app);
Command addWork(CLI::App& app);
Command addAudit(CLI::App& app);
Command addClaims(CLI::App& app);
Command addCompare(CLI::App& app);
Command addSelftest(CLI::App& app);
Command addTemplates(CLI::App& app);
Command addStream(CLI::App& app);
Command addTrain(CLI::App& app);
Command addDefaults(CLI::App& app);
Command addDoctor(CLI::App& app);
Command addVersion(CLI::App& app);

/// --set key=value, repeatable.
void addOverrides(CLI::App& app, std::vector<std::string>& overrides, const std::string& example);

/// The command line as typed, for provenance.
const std::string& commandLine();

/// Runs the hydrabench command; what main() does.
int runApp(int argc, const char* const* argv);

}  // namespace hydrabench
