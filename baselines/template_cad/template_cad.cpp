// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/template_cad.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/geometry/mesh_io.h"
#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

std::optional<ObjectNode> objectOf(const Landmark& landmark, const TemplateCad::ClassRules& rules,
                                   const TemplateModel& model, const PlacementConfig& placement) {
  const std::optional<Footprint> footprint = footprintOf(landmark.points);
  if (!footprint) return std::nullopt;
  Aabb box;
  for (const Eigen::Vector3d& point : landmark.points) box.extend(point);
  const double height = box.sizes().z();
  if (!rules.admits(*footprint, height)) return std::nullopt;
  TemplateModel::Placed placed =
      model.place(placement, landmark.center, *footprint, landmark.points);
  ObjectNode object;
  object.label = landmark.label;
  object.name = rules.class_name;
  object.T_world_object = placed.T_world_object;
  object.mesh = std::move(placed.mesh);
  object.box = bounds(object.mesh);
  object.first_observed_ns = landmark.stamps_ns.front();
  object.last_observed_ns = landmark.stamps_ns.back();
  return object;
}

}  // namespace

bool TemplateCad::ClassRules::admits(const Footprint& footprint, double height_m) const {
  return footprint.length >= min_length_m && footprint.length <= max_length_m &&
         height_m >= min_height_m && height_m <= max_height_m;
}

TemplateCad::ClassRules TemplateCad::publishedRules(const std::string& class_name) {
  if (class_name == "chair") return {class_name, {}, 0.75, 0.2, 1.5, 0.2, 1.5};
  if (class_name == "bin") return {class_name, {}, 1.0, 0.2, 1.5, 0.1, 1.5};
  if (class_name == "plant") return {class_name, {}, 1.0, 0.1, 2.0, 0.1, 2.0};
  if (class_name == "couch") return {class_name, {}, 1.5, 0.5, 3.0, 0.2, 1.5};
  ClassRules rules;
  rules.class_name = class_name;
  return rules;
}

CandidateExtractor::Config TemplateCad::instancesAsGiven() {
  CandidateExtractor::Config config;
  config.source = "instances";
  return config;
}

std::map<Label, double> TemplateCad::gates(const Config& config, const LabelSpace& label_space) {
  std::map<Label, double> gates;
  for (const ClassRules& rules : config.templates) {
    const LabelSpace::Entry* entry = label_space.find(rules.class_name);
    if (entry && entry->is_object) gates[entry->label] = rules.gate_m;
  }
  return gates;
}

TemplateCad::TemplateCad(const Config& config, const LabelSpace& label_space)
    : config_(config),
      label_space_(label_space),
      extractor_(config.candidates, label_space),
      tracker_(config.tracking, gates(config, label_space)),
      landmarks_(config.landmarks) {
  for (const ClassRules& rules : config.templates) {
    const LabelSpace::Entry* entry = label_space.find(rules.class_name);
    if (!entry || !entry->is_object) continue;
    templates_.try_emplace(entry->label, Template{rules, TemplateModel(readMesh(rules.mesh))});
  }
}

void TemplateCad::process(const Frame& frame) {
  std::vector<InstanceMeasurement> measurements;
  {
    const StageTimes::Scope stage(times_, "measure");
    const SensorView view = sensorView(frame, config_.min_range_m, config_.candidates.max_range_m);
    measurements = measureInstances(frame, extractor_.extract(frame, view), config_.measurement);
  }
  const StageTimes::Scope stage(times_, "associate");
  for (InstanceTrack& track : tracker_.update(frame.stamp_ns, measurements)) {
    landmarks_.add(std::move(track));
  }
}

SceneGraph TemplateCad::finish() {
  for (InstanceTrack& track : tracker_.takeAll()) landmarks_.add(std::move(track));
  SceneGraph graph;
  graph.label_space = label_space_;
  for (const Landmark& landmark : landmarks_.landmarks()) {
    const Template& entry = templates_.at(landmark.label);
    std::optional<ObjectNode> object =
        objectOf(landmark, entry.rules, entry.model, config_.placement);
    if (!object) continue;
    object->id = objectNodeId(graph.objects.size());
    graph.objects.push_back(*std::move(object));
  }
  return graph;
}

std::vector<std::string> TemplateCad::notes() const {
  const PlacementConfig& placement = config_.placement;
  std::vector<std::string> with;
  std::vector<std::string> without;
  for (const LabelSpace::Entry& entry : label_space_.entries) {
    if (!entry.is_object) continue;
    const auto found = templates_.find(entry.label);
    if (found == templates_.end()) {
      without.push_back(entry.name);
    } else {
      with.push_back(
          fmt::format("{} ({})", entry.name, found->second.rules.mesh.filename().string()));
    }
  }
  std::vector<std::string> unused;
  for (const ClassRules& rules : config_.templates) {
    const LabelSpace::Entry* entry = label_space_.find(rules.class_name);
    if (!entry || !entry->is_object) unused.push_back(rules.class_name);
  }
  std::string yaw = "the world's axes";
  if (placement.yaw == "hull_pca") yaw = "main axis of the footprint's hull, modulo pi";
  if (placement.yaw == "chamfer_search") {
    yaw = fmt::format("least distance from the points to the template, in steps of {} degrees",
                      placement.yaw_step_deg);
  }
  std::vector<std::string> notes = {
      with.empty() ? std::string("no class of this dataset has a template")
                   : fmt::format("one template per class: {}", fmt::join(with, ", ")),
      fmt::format(
          "yaw of the template: {}; scale: {}; position: {}; z: {}", yaw,
          placement.scale == "fixed" ? "fixed" : "fitted to the extents of the points",
          placement.position == "centroid" ? "moving average of the centroid"
                                           : "middle of the extents",
          placement.z == "ground"
              ? fmt::format("on the ground, whose height is given: {} m", placement.ground_z_m)
          : placement.z == "lowest" ? std::string("on the lowest of the points")
                                    : std::string("mean height of the points"))};
  if (!without.empty()) {
    notes.push_back(fmt::format("no template, no objects: {}", fmt::join(without, ", ")));
  }
  if (!unused.empty()) {
    notes.push_back(fmt::format("templates of classes that are no objects of this dataset: {}",
                                fmt::join(unused, ", ")));
  }
  return notes;
}

namespace {

/// A template that cannot be read is found before the first frame is.
void requireMesh(ConfigReader& item, const std::filesystem::path& path) {
  try {
    if (readMesh(path).empty()) {
      item.fault("mesh", fmt::format("{} has no faces, expected a mesh", path.string()));
    }
  } catch (const InputError& error) {
    item.fault("mesh", error.what());
  }
}

}  // namespace

void read(ConfigReader& reader, TemplateCad::Config& config) {
  reader.field("min_range_m", config.min_range_m, Bounds{0, 1000});
  auto candidates = reader.section("candidates");
  read(candidates, config.candidates);
  if (!(config.min_range_m < config.candidates.max_range_m)) {
    reader.fault("min_range_m",
                 "is not below candidates.max_range_m; expected a range of distances");
  }
  auto measurement = reader.section("measurement");
  read(measurement, config.measurement);
  auto tracking = reader.section("tracking");
  read(tracking, config.tracking);
  auto landmarks = reader.section("landmarks");
  read(landmarks, config.landmarks);
  auto placement = reader.section("placement");
  read(placement, config.placement);
  readTemplates(reader, config.templates);
}

void readTemplates(ConfigReader& reader, std::vector<TemplateCad::ClassRules>& templates) {
  if (reader.has("templates")) templates.clear();
  for (ConfigReader& item : reader.list("templates")) {
    std::string class_name;
    item.require("class");
    item.field("class", class_name);
    if (std::any_of(templates.begin(), templates.end(),
                    [&](const auto& other) { return other.class_name == class_name; })) {
      item.fault("class",
                 fmt::format("{} has a template already; expected one per class", class_name));
    }
    TemplateCad::ClassRules rules = TemplateCad::publishedRules(class_name);
    item.require("mesh");
    item.path("mesh", rules.mesh);
    if (!rules.mesh.empty()) requireMesh(item, rules.mesh);
    item.field("gate_m", rules.gate_m, Bounds{0.01, 100});
    item.field("min_length_m", rules.min_length_m, Bounds{0, 100});
    item.field("max_length_m", rules.max_length_m, Bounds{0, 100});
    item.field("min_height_m", rules.min_height_m, Bounds{0, 100});
    item.field("max_height_m", rules.max_height_m, Bounds{0, 100});
    templates.push_back(std::move(rules));
  }
}

}  // namespace hydrabench
