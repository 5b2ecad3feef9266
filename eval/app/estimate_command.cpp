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
#include "eval/experiment/latency_table.h"
#include "eval/experiment/provenance.h"
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
  const std::vector<LatencyRow> latencies = latencyRows(rows);
  writeFileAtomic(folder.temporary() / "latency.csv", latencyCsv(latencies));
  writeFileAtomic(folder.temporary() / "latency.md", latencyMarkdown(latencies));
  const std::string remark = drawPlot(latencyPlot(rows), folder.temporary() / "plots", "latency");
  writeFileAtomic(folder.temporary() / "config.yaml", study.resolved_config);
  writeFileAtomic(folder.temporary() / "provenance.json",
                  provenanceJson(currentProvenance(commandLine())));
  folder.commit();
  fmt::print("{}medians with 95 % intervals\n\n{}\nwrote {}\n", summaryTable(summaries),
             latencyMarkdown(latencies), options.out.string());
  if (!remark.empty()) fmt::print(stderr, "plots/{}\n", remark);
  return kDone;
}

}  // namespace

Command addEstimate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("study", options->study,
                 "what to estimate from which views (configs/studies/held_out_views.yaml)")
      ->required()
      ->type_name("STUDY");
  app.add_option("--out", options->out, "folder for views.csv, summary.csv, latency.*")
      ->required()
      ->type_name("DIR");
  app.add_flag("--replace", options->replace, "replace an earlier result of this command");
  addOverrides(app, options->overrides, "views.masks=given");
  app.footer(
      "views.csv: a line per object and estimator; summary.csv: medians per dataset, estimator "
      "and\n"
      "class, in and out of its training classes where the study tells them; latency.csv,\n"
      "latency.md, plots/latency.png: time per object by stage. An estimator that cannot be "
      "started\n"
      "says why in its row.");
  return [options] { return runEstimate(*options); };
}

}  // namespace hydrabench
