// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "eval/app/app.h"
#include "eval/report/result_comparison.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path before;
  std::filesystem::path after;
  bool gate = false;
  bool no_times = false;
  std::filesystem::path markdown;
  std::filesystem::path junit;
  NoiseFloor floor;
};

int compare(const Options& options) {
  NoiseFloor floor = options.floor;
  floor.compare_times = !options.no_times;
  const ResultComparison comparison = compareResults(options.before, options.after, floor);
  const std::string text = comparisonMarkdown(comparison);
  fmt::print("{}", text);
  if (!options.markdown.empty()) writeFileAtomic(options.markdown, text);
  if (!options.junit.empty()) writeFileAtomic(options.junit, comparisonJUnit(comparison));
  if (!options.gate) return kDone;
  switch (comparison.verdict()) {
    case ResultComparison::Verdict::kWorse:
      return kGateFailed;
    case ResultComparison::Verdict::kInconclusive:
      return kInconclusive;
    case ResultComparison::Verdict::kSame:
    case ResultComparison::Verdict::kBetter:
      break;
  }
  return kDone;
}

}  // namespace

Command addCompare(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("before", options->before, "result folder of run or evaluate")
      ->required()
      ->type_name("BEFORE");
  app.add_option("after", options->after, "the one to judge")->required()->type_name("AFTER");
  app.add_flag("--gate", options->gate,
               "exit code: 0 the same or better, 1 worse, 2 not comparable, 3 inconclusive");
  app.add_flag("--no-times", options->no_times, "leave the times out");
  app.add_option("--floor", options->floor.score, "of F1 and IoU: what is no difference")
      ->capture_default_str();
  app.add_option("--floor-distance", options->floor.distance_m, "the same of distances [m]")
      ->capture_default_str();
  app.add_option("--floor-time", options->floor.time_share, "the same of times, as a share")
      ->capture_default_str();
  app.add_option("--md", options->markdown, "file for the table as well")->type_name("FILE");
  app.add_option("--junit", options->junit, "file for JUnit XML, for CI")->type_name("FILE");
  app.footer(
      "Methods and worlds that both results have, matched one_to_one; quality by paired bootstrap\n"
      "over objects, time per frame by paired bootstrap over frames, on the same machine only.");
  return [options] { return compare(*options); };
}

}  // namespace hydrabench
