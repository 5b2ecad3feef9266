// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/io/image_io.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/datasets/open_dataset.h"
#include "eval/experiment/result_worlds.h"
#include "eval/report/comparison_table.h"
#include "eval/simulation/contact_sheet.h"
#include "eval/simulation/simulated_dataset.h"
#include "eval/view/error_picture.h"
#include "eval/view/frame_picture.h"
#include "eval/view/rejection_picture.h"
#include "eval/view/scan_picture.h"
#include "eval/view/world_picture.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path source;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  int frames = 3;
  bool families = false;
  int instances = 5;
  std::uint64_t seed = 1;
  bool heatmaps = false;
  bool rejections = false;
  std::size_t objects = 12;
};

void save(const std::filesystem::path& path, const Image<Rgb>& picture) {
  writeColorPng(path, picture);
  fmt::print("wrote {} ({} x {})\n", path.string(), picture.width(), picture.height());
}

/// True instances above what the method is given; empty where the dataset knows no difference.
Image<Rgb> maskPicture(const SimulatedDataset& dataset, std::size_t index, const Frame& given) {
  const RenderedView view =
      dataset.renderer().render(dataset.camera(), dataset.trajectory()[index].T_world_camera);
  Image<InstanceId> true_instances(view.objects.width(), view.objects.height());
  std::transform(view.objects.begin(), view.objects.end(), true_instances.begin(),
                 [](std::int32_t object) { return object + 1; });
  return sideBySide(
      {given.color, instancePicture(true_instances), instancePicture(given.instances)});
}

void viewDataset(const Options& options) {
  const OpenedDataset opened = openDataset(options.source, options.overrides);
  const Dataset& dataset = *opened.dataset;
  if (dataset.hasGroundTruth()) {
    save(options.out / "overview.png", worldPicture(dataset));
    save(options.out / "objects.png", objectSheet(dataset));
  }
  const auto* simulated = dynamic_cast<const SimulatedDataset*>(&dataset);
  const auto count =
      std::min<std::size_t>(static_cast<std::size_t>(options.frames), dataset.numFrames());
  for (std::size_t i = 0; i < count; ++i) {
    // Evenly spread, away from both ends of the drive.
    const std::size_t index = (2 * i + 1) * dataset.numFrames() / (2 * count);
    const Frame frame = dataset.frame(index);
    const Image<Rgb> images = framePicture(frame);
    if (!images.empty()) save(options.out / fmt::format("frame_{:06}.png", index), images);
    if (!frame.scans.empty()) {
      save(options.out / fmt::format("scan_{:06}.png", index), scanPicture(frame.scans.back()));
    }
    if (simulated) {
      save(options.out / fmt::format("masks_{:06}.png", index),
           maskPicture(*simulated, index, frame));
    }
  }
}

void viewPrediction(const Options& options) {
  const SceneGraph graph = readPrediction(options.source).graph;
  save(options.out / "prediction.png", predictionPicture(graph));
  if (!graph.scene_mesh.colors.empty()) {
    save(options.out / "scene_mesh.png", sceneMeshPicture(graph));
  }
  const bool has_meshes = std::any_of(graph.objects.begin(), graph.objects.end(),
                                      [](const ObjectNode& node) { return !node.mesh.empty(); });
  if (has_meshes) save(options.out / "objects.png", objectSheet(graph));
}

/// What every method made of the objects of a world, and what each turned down.
void viewWorld(const Options& options, const ResultWorld& world) {
  const OpenedDataset opened = world.open();
  const Dataset& dataset = *opened.dataset;
  std::vector<Prediction> predictions;
  std::vector<std::string> labels;
  for (const std::filesystem::path& path : world.predictions) {
    predictions.push_back(readPrediction(path));
    labels.push_back(methodLabel(predictions.back().method));
  }
  if (options.heatmaps) {
    save(options.out / fmt::format("errors_{}.png", world.label()),
         errorPicture(compareObjects(dataset.groundTruth(), predictions, options.objects), labels));
  }
  for (std::size_t m = 0; options.rejections && m < predictions.size(); ++m) {
    if (predictions[m].candidates.empty()) continue;
    const Image<Rgb> picture =
        rejectionPicture(predictions[m].candidates, dataset.labelSpace(), colorAt(dataset),
                         readDecisionOf(world.predictions[m]).rmcc);
    if (picture.empty()) {
      fmt::print("{}, {}: nothing was rejected\n", world.label(), predictions[m].method);
      continue;
    }
    save(options.out / fmt::format("rejections_{}_{}.png", world.label(), predictions[m].method),
         picture);
  }
}

void viewResult(const Options& options) {
  for (const ResultWorld& world : resultWorlds(options.source)) viewWorld(options, world);
}

int view(const Options& options) {
  if (options.families) {
    save(options.out / "families.png",
         renderContactSheet(indoorFamilies(), options.seed, options.instances));
    save(options.out / "families_outdoor.png",
         renderContactSheet(outdoorFamilies(), options.seed, options.instances));
    return kDone;
  }
  if (options.source.empty()) {
    throw InputError("view: nothing to show, expected a dataset, a prediction or --families");
  }
  const std::string extension = options.source.extension().string();
  const bool is_dataset = extension == ".yaml" || extension == ".yml" ||
                          std::filesystem::exists(options.source / "dataset.yaml");
  if (options.heatmaps || options.rejections) {
    viewResult(options);
    return kDone;
  }
  if (std::filesystem::exists(options.source / "predictions")) {
    throw InputError(fmt::format(
        "{}: a result folder, expected --heatmaps, --rejections or one of "
        "its predictions: {}",
        options.source.string(), (options.source / "predictions/DATASET/SEED/METHOD").string()));
  }
  if (is_dataset) {
    viewDataset(options);
  } else {
    viewPrediction(options);
  }
  return kDone;
}

}  // namespace

Command addView(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option(
         "source", options->source,
         "dataset (.yaml or exported folder), prediction folder or scene_graph.json; result "
         "folder")
      ->type_name("SOURCE");
  app.add_option("--out", options->out, "folder for the PNG files")->required()->type_name("DIR");
  app.add_option("--frames", options->frames, "frames to show, spread over the sequence")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_flag("--families", options->families,
               "show every family of shapes instead, several instances each, indoor and outdoor");
  app.add_option("--instances", options->instances, "with --families: instances of each")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  app.add_option("--seed", options->seed, "with --families: seed of the instances")
      ->capture_default_str();
  app.add_flag("--heatmaps", options->heatmaps,
               "of a result of 'run': objects and errors of all methods, side by side");
  app.add_flag("--rejections", options->rejections,
               "of a result of 'run': the estimates that the consistency check turned down");
  app.add_option("--objects", options->objects, "with --heatmaps: objects of each world")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  addOverrides(app, options->overrides, "seed=7");
  app.footer(
      "Of a dataset: overview.png, objects.png, frame_*.png (colour, depth, instances) and, for "
      "generated worlds, masks_*.png (colour,\n"
      "true instances, instances as a method sees them). Of a prediction: prediction.png (objects "
      "in the colours of their\n"
      "classes), scene_mesh.png, objects.png. Of a result: errors_*.png, rejections_*.png.");
  return [options] { return view(*options); };
}

}  // namespace hydrabench
