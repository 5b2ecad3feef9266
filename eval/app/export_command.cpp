// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "eval/app/app.h"
#include "eval/app/progress.h"
#include "eval/datasets/folder_export.h"
#include "eval/datasets/open_dataset.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path dataset;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  std::size_t frames = 0;
  bool replace = false;
};

int runExport(const Options& options) {
  const OpenedDataset opened = openDataset(options.dataset, options.overrides);
  const Dataset& dataset = *opened.dataset;
  const std::size_t count =
      options.frames == 0 ? dataset.numFrames() : std::min(options.frames, dataset.numFrames());
  Progress progress("export", count);
  exportDataset(dataset, options.out, {.num_frames = count, .replace = options.replace},
                [&] { progress.advance(); });
  fmt::print("wrote {} frames and {} ground-truth objects to {}\n", count,
             dataset.groundTruth().objects.size(), options.out.string());
  if (count < dataset.numFrames()) {
    fmt::print(stderr, "the visible fractions in ground_truth are those of all {} frames\n",
               dataset.numFrames());
  }
  return kDone;
}

}  // namespace

Command addExport(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("dataset", options->dataset, "dataset to export (configs/datasets/*.yaml)")
      ->required()
      ->type_name("DATASET.yaml");
  app.add_option("--out", options->out, "folder to write; appears complete or not at all")
      ->required()
      ->type_name("DIR");
  app.add_option("--frames", options->frames, "write the first N frames only; 0: all")
      ->check(CLI::Range(0, 1'000'000'000))
      ->type_name("N");
  app.add_flag("--replace", options->replace, "replace the folder if it exists");
  addOverrides(app, options->overrides, "seed=7");
  app.footer(
      "The layout is described in docs/datasets.md. The result is itself a dataset: "
      "DIR/dataset.yaml.");
  return [options] { return runExport(*options); };
}

}  // namespace hydrabench
