// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/claims/claim_report.h"

namespace hydrabench {
namespace {

struct Options {
  std::vector<std::filesystem::path> results;
  std::filesystem::path claims = kDefaultClaims;
  std::filesystem::path out;
  std::string format = "terminal";
};

int claims(const Options& options) {
  if (options.claims == kDefaultClaims && !std::filesystem::exists(options.claims)) {
    throw InputError(fmt::format(
        "{}: not in this folder, expected to stand in a clone of hydrabench, or --claims FILE",
        kDefaultClaims));
  }
  const std::vector<Claim> stated = readClaims(options.claims);
  const std::vector<JudgedClaim> judged = judge(stated, readEvidence(options.results));
  const std::string text = options.format == "md"     ? claimsMarkdown(judged)
                           : options.format == "json" ? claimsJson(judged)
                                                      : claimsText(judged);
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else {
    writeFileAtomic(options.out, text);
    fmt::print("wrote {}\n", options.out.string());
  }
  const auto any = [&](ClaimVerdict verdict) {
    return std::any_of(judged.begin(), judged.end(),
                       [&](const JudgedClaim& claim) { return claim.verdict == verdict; });
  };
  if (any(ClaimVerdict::kFails)) return kGateFailed;
  return any(ClaimVerdict::kUndecided) || any(ClaimVerdict::kNotRun) ? kInconclusive : kDone;
}

}  // namespace

Command addClaims(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("results", options->results, "result folders of run or evaluate")
      ->required()
      ->type_name("RESULT...");
  app.add_option("--claims", options->claims, "what is claimed; configs/claims.yaml shows how")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--format", options->format, "terminal, md or json")
      ->check(CLI::IsMember({"terminal", "md", "json"}))
      ->capture_default_str();
  app.add_option("--out", options->out, "file to write instead of printing")->type_name("FILE");
  app.footer(
      "Judges each claim by the results: holds, fails, undecided at this sample size, or not run,\n"
      "with the numbers behind it. Exit code 0: all hold, 1: one fails, 3: none fails, but one is\n"
      "undecided or was not run.");
  return [options] { return claims(*options); };
}

}  // namespace hydrabench
