// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/hydra.h"

#include <cstddef>

#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/mapping/class_mask.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

std::vector<Label> objectLabels(const LabelSpace& label_space) {
  std::vector<Label> labels;
  for (const LabelSpace::Entry& entry : label_space.entries) {
    if (entry.is_object) labels.push_back(entry.label);
  }
  return labels;
}

}  // namespace

Hydra::Hydra(const Config& config, const LabelSpace& label_space)
    : config_(config),
      label_space_(label_space),
      dynamic_labels_(labelsNamed(config.dynamic_classes, label_space)),
      window_(config.window),
      lidar_(config.lidar, label_space, dynamic_labels_),
      objects_(config.objects, objectLabels(label_space)) {}

void Hydra::process(const Frame& frame) {
  if (frame.labels.empty() && !config_.lidar.enabled) {
    throw InputError(
        fmt::format("hydra: the frame at {} ns has no label image; expected one", frame.stamp_ns));
  }
  last_stamp_ns_ = frame.stamp_ns;
  last_position_ = frame.T_world_camera.translation();
  lidar_.integrate(frame, window_, times_);
  const bool lidar_alone = lidar_.enabled() && frame.depth.empty();
  if (lidar_.cameraInMap() && !lidar_alone) {
    const StageTimes::Scope stage(times_, "integrate");
    SensorView view = sensorView(frame, config_.min_range_m, config_.max_range_m);
    Image<std::uint8_t> mask(view.range.width(), view.range.height());
    if (!frame.labels.empty()) maskClasses(frame.labels, dynamic_labels_, mask);
    if (!dynamic_labels_.empty()) view.mask = &mask;
    window_.integrate(view);
  }
  if (window_.updateDue(frame.stamp_ns)) update();
}

void Hydra::update() {
  {
    const StageTimes::Scope stage(times_, "mesh");
    window_.update(last_stamp_ns_, last_position_);
  }
  const StageTimes::Scope stage(times_, "objects");
  objects_.update(window_.mesh(), last_stamp_ns_);
}

SceneGraph Hydra::finish() {
  lidar_.requireScans();
  update();
  window_.finish();
  objects_.refresh(window_.mesh());

  SceneGraph graph;
  graph.label_space = label_space_;
  graph.objects.resize(objects_.nodes().size());
  parallelFor(graph.objects.size(),
              [&](std::size_t i) { graph.objects[i] = objectNode(objects_.nodes()[i]); });
  graph.scene_mesh = window_.mesh().mesh(&graph.scene_labels);
  graph.occupied = window_.takeOccupied();
  graph.occupied_voxel_m = config_.window.tsdf.voxel_size_m;
  return graph;
}

ObjectNode Hydra::objectNode(const MeshObjects::Node& node) const {
  ObjectNode object;
  object.id = objectNodeId(node.number);
  object.label = node.label;
  object.name = label_space_.nameOf(node.label) + "_" + std::to_string(node.number);
  object.mesh = window_.mesh().submesh(node.vertices);
  object.box = object.mesh.empty() ? node.box : bounds(object.mesh);
  object.T_world_object.translation() = node.position;
  object.first_observed_ns = node.first_observed_ns;
  object.last_observed_ns = node.last_observed_ns;
  return object;
}

void read(ConfigReader& reader, Hydra::Config& config) {
  reader.field("min_range_m", config.min_range_m, Bounds{0.0, 1e3});
  reader.field("max_range_m", config.max_range_m, Bounds{0.0, 1e3});
  if (config.max_range_m <= config.min_range_m) {
    reader.fault("max_range_m", "is not above min_range_m");
  }
  reader.field("dynamic_classes", config.dynamic_classes);
  auto lidar = reader.section("lidar");
  read(lidar, config.lidar);
  auto window = reader.section("window");
  read(window, config.window);
  requireBandInMesh(window, config.window, config.lidar);
  auto objects = reader.section("objects");
  read(objects, config.objects);
}

}  // namespace hydrabench
