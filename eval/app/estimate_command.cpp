// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/experiment/single_view_study.h"

namespace hydrabench {
namespace {

constexpr const char* kMarker = "views.csv";

struct Options {
  std::filesystem::path study;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  bool replace = false;
};

int runEstimate(const Options& options) {
  const SingleViewStudy study = readSingleViewStudy(options.study, options.overrides);
  AtomicFolder folder(options.out, options.replace ? kMarker : "");
  const std::vector<SingleViewRow> rows =
      runSingleViewStudy(study, [](const std::string& dataset, const std::string& seed) {
        fmt::print(stderr, "{}, seed {}\n", dataset, seed);
      });
  if (rows.empty()) {
    throw InputError(
        fmt::format("{}: no scored object has a view of {} pixels; nothing to estimate",
                    options.study.string(), study.views.min_pixels));
  }
  const auto summaries = summarize(rows, study.evaluation.bootstrapConfig());
  writeFileAtomic(folder.temporary() / kMarker, viewsCsv(rows));
  writeFileAtomic(folder.temporary() / "summary.csv", summaryCsv(summaries));
  writeFileAtomic(folder.temporary() / "config.yaml", study.resolved_config);
  folder.commit();
  fmt::print("{}medians with 95 % intervals; wrote {}\n", summaryTable(summaries),
             options.out.string());
  return kDone;
}

}  // namespace

Command addEstimate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("study", options->study,
                 "what to estimate from which views (configs/studies/held_out_views.yaml)")
      ->required()
      ->type_name("STUDY");
  app.add_option("--out", options->out, "folder for views.csv and summary.csv")
      ->required()
      ->type_name("DIR");
  app.add_flag("--replace", options->replace, "replace an earlier result of this command");
  addOverrides(app, options->overrides, "views.masks=given");
  return [options] { return runEstimate(*options); };
}

}  // namespace hydrabench
