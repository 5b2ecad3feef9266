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
#include "eval/app/progress.h"
#include "eval/datasets/open_dataset.h"
#include "eval/experiment/map_dataset.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path dataset;
  std::filesystem::path method;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  std::size_t frames = 0;
  bool replace = false;
};

int map(const Options& options) {
  std::vector<std::string> dataset_overrides;
  std::vector<std::string> method_overrides;
  for (const std::string& assignment : options.overrides) {
    if (assignment.starts_with("dataset.")) {
      dataset_overrides.push_back(assignment.substr(8));
    } else if (assignment.starts_with("method.")) {
      method_overrides.push_back(assignment.substr(7));
    } else {
      throw InputError(fmt::format(
          "--set {}: expected a key that starts with 'dataset.' or 'method.'", assignment));
    }
  }
  // People write predictions by hand; only what this command timed may be replaced.
  AtomicFolder folder(options.out, options.replace ? kTimingFile : "");
  const MethodConfig method = readMethod(options.method, method_overrides);
  const OpenedDataset opened = openDataset(options.dataset, dataset_overrides);
  const Dataset& dataset = *opened.dataset;
  const std::size_t count =
      options.frames == 0 ? dataset.numFrames() : std::min(options.frames, dataset.numFrames());
  Progress progress("map", count);
  const DatasetRun run = mapDataset(dataset, {method}, count, [&] { progress.advance(); });
  const MethodRun& result = run.methods.front();
  if (!result.prediction) {
    throw InputError(fmt::format("{}: {}", result.method, result.failure));
  }
  fillRunFolder(folder.temporary(), result);
  folder.commit();
  const SceneGraph& graph = result.prediction->graph;
  fmt::print("{} objects, scene mesh of {} faces\n", graph.objects.size(),
             graph.scene_mesh.faces.size());
  fmt::print("{}", timingSummary(result.timing, {{dataset.name(), run.frame_period_s}}));
  fmt::print("wrote {}\n", options.out.string());
  return kDone;
}

}  // namespace

Command addMap(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("dataset", options->dataset, "dataset to map (configs/datasets/*.yaml)")
      ->required()
      ->type_name("DATASET.yaml");
  app.add_option("--method", options->method, "method to run (configs/methods/*.yaml)")
      ->required()
      ->type_name("METHOD.yaml");
  app.add_option("--out", options->out,
                 "prediction folder to write; appears complete or not at all")
      ->required()
      ->type_name("DIR");
  app.add_option("--frames", options->frames, "map the first N frames only; 0: all")
      ->check(CLI::Range(0, 1'000'000'000))
      ->type_name("N");
  app.add_flag("--replace", options->replace, "replace the prediction folder if it exists");
  addOverrides(app, options->overrides, "method.window.tsdf.voxel_size_m=0.05");
  app.footer(
      "Look at the result with 'hydrabench view DIR', score it with 'hydrabench evaluate DIR\n"
      "--dataset DATASET.yaml --out RESULT'. 'hydrabench run' does all of it for several methods.");
  return [options] { return map(*options); };
}

}  // namespace hydrabench
