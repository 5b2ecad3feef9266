// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/experiment/provenance.h"
#include "eval/experiment/stream_inputs.h"
#include "eval/experiment/stream_report.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

constexpr const char* kMeasured = "measured";

struct Options {
  StreamSources sources;
  std::vector<std::string> latencies;
  StreamConfig config;
  std::string deadline_from = "request";
  std::filesystem::path out;
  bool replace = false;
};

/// Methods in the order in which they occur, each with the latencies that were asked for: its own
/// (METHOD:LATENCY), or else those of all, or else what was measured.
std::vector<StreamMethod> methodsOf(const std::vector<StreamWorld>& worlds,
                                    const std::vector<std::string>& latencies) {
  std::vector<StreamMethod> methods;
  const auto methodNamed = [&](const std::string& name) {
    return std::find_if(methods.begin(), methods.end(),
                        [&](const StreamMethod& method) { return method.name == name; });
  };
  for (const StreamWorld& world : worlds) {
    if (methodNamed(world.method) == methods.end()) methods.push_back({world.method, {}});
  }
  std::vector<std::optional<LatencyModel>> for_all;
  for (const std::string& text : latencies) {
    const auto method = methodNamed(text.substr(0, text.find(':')));
    const std::string model = method == methods.end() ? text : text.substr(text.find(':') + 1);
    auto& list = method == methods.end() ? for_all : method->latencies;
    list.push_back(model == kMeasured ? std::nullopt : std::optional(readLatency(model)));
  }
  if (for_all.empty()) for_all.push_back(std::nullopt);
  for (StreamMethod& method : methods) {
    if (method.latencies.empty()) method.latencies = for_all;
  }
  return methods;
}

void requireMeasured(const std::vector<StreamWorld>& worlds,
                     const std::vector<StreamMethod>& methods) {
  for (const StreamWorld& world : worlds) {
    for (const StreamMethod& method : methods) {
      if (method.name != world.method || world.measured) continue;
      if (std::all_of(method.latencies.begin(), method.latencies.end(),
                      [](const auto& latency) { return latency.has_value(); })) {
        continue;
      }
      throw InputError(
          fmt::format("{}, seed {}, method '{}': its timing.csv has no stage "
                      "'estimate', expected one, or --latency",
                      world.dataset, world.seed, world.method));
    }
  }
}

int stream(const Options& options) {
  AtomicFolder folder(options.out, options.replace ? kResultMarker : "");
  StreamConfig config = options.config;
  config.deadline_from_last_seen = options.deadline_from == "last_seen";
  const StreamInputs inputs = readStreamInputs(
      options.sources, [](const std::string& world) { fmt::print(stderr, "{}\n", world); });
  const std::vector<StreamMethod> methods = methodsOf(inputs.worlds, options.latencies);
  requireMeasured(inputs.worlds, methods);
  const StreamReport report = replayStreams(inputs.worlds, methods, config, inputs.evaluation);

  const std::filesystem::path& out = folder.temporary();
  const std::string tables = streamMarkdown(report);
  writeFileAtomic(out / "stream.csv", streamCsv(report));
  writeFileAtomic(out / "stream.md", tables);
  writeFileAtomic(out / "f1_over_time.csv", f1OverTimeCsv(report));
  writeFileAtomic(out / "queue.csv", queueCsv(report));
  writeFileAtomic(out / "requests.csv", requestsCsv(report));
  writeFileAtomic(out / "break_even.csv", breakEvenCsv(report));
  for (const std::string& dataset : streamDatasets(report)) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      const std::string remark = drawPlot(streamPlot(report, dataset, matching), out / "plots",
                                          fmt::format("stream_{}_{}", dataset, name(matching)));
      if (!remark.empty()) fmt::print(stderr, "plots/{}\n", remark);
    }
  }
  writeFileAtomic(out / "config.yaml", inputs.resolved_config);
  writeFileAtomic(out / kResultMarker, provenanceJson(currentProvenance(commandLine())));
  folder.commit();
  fmt::print("{}wrote {}\n", tables, options.out.string());
  return kDone;
}

}  // namespace

Command addStream(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("sources", options->sources.paths,
                 "result folders of run, or prediction folders of methods that estimate shapes")
      ->required()
      ->type_name("RESULT...");
  app.add_option("--dataset", options->sources.dataset,
                 "of prediction folders: dataset with the ground truth")
      ->type_name("DATASET.yaml");
  app.add_option("--out", options->out, "folder to write: tables and plots")
      ->required()
      ->type_name("DIR");
  app.add_flag("--replace", options->replace, "replace the folder if it exists");
  app.add_option("--method", options->sources.methods,
                 "methods to replay; repeatable. Without it all that estimate shapes")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--latency", options->latencies,
                 "how long a shape takes, see below; repeatable. Without it as measured")
      ->type_name("[METHOD:]LATENCY")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--servers", options->config.servers, "estimators that work side by side")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--deadline", options->config.deadline_s,
                 "a shape that is ready later than this is late [s]")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  app.add_option("--deadline-from", options->deadline_from,
                 "what the deadline runs from: request or last_seen")
      ->check(CLI::IsMember({"request", "last_seen"}))
      ->capture_default_str();
  app.add_option("--request-after", options->sources.request_after_s,
                 "time from an object's last observation to its request [s]; without it that of "
                 "the run, tracker.temporal_window_s")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("FLOAT");
  app.add_option("--after", options->config.after_s,
                 "time after the last frame that counts as well [s]")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  app.add_option("--seed", options->config.seed, "of latencies that are drawn")
      ->capture_default_str();
  addOverrides(app, options->sources.overrides, "evaluation.thresholds_m=[0.5]");
  app.footer(
      "LATENCY: measured (timing.csv of the run), seconds (0.43), mean=1.2,p50=1,p90=2,p99=3\n"
      "(seconds, any of them), FILE.csv:ESTIMATOR (views.csv of 'hydrabench estimate'), or\n"
      "published:NAME, NAME one of sam3d_indoor, sam3d_outdoor, crisp_indoor, crisp_outdoor.\n"
      "Nothing is mapped or estimated again: requests are replayed, first come, first served, and\n"
      "shapes count from the moment they are ready. Of two methods the better one is slowed down\n"
      "until it no longer pays. docs/metrics.md defines every number. Example:\n"
      "  hydrabench stream results/table1 --latency measured --latency published:sam3d_indoor "
      "--out results/stream");
  return [options] { return stream(*options); };
}

}  // namespace hydrabench
