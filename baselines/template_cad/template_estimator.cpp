// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/template_estimator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/mesh_io.h"

namespace hydrabench {
namespace {

/// What the mask shows, nearest first and the ends taken off; world [m].
std::vector<Eigen::Vector3d> pointsOf(const ShapeObservation& view, double trim) {
  struct Pixel {
    float depth;
    int u;
    int v;
  };
  std::vector<Pixel> pixels;
  for (int v = 0; v < view.mask.height(); ++v) {
    for (int u = 0; u < view.mask.width(); ++u) {
      const float depth = view.depth(u, v);
      if (view.mask(u, v) != 0 && depth > 0 && std::isfinite(depth))
        pixels.push_back({depth, u, v});
    }
  }
  std::stable_sort(pixels.begin(), pixels.end(),
                   [](const Pixel& a, const Pixel& b) { return a.depth < b.depth; });
  const auto cut = static_cast<std::size_t>(trim * static_cast<double>(pixels.size()));
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = cut; i + cut < pixels.size(); ++i) {
    const Pixel& p = pixels[i];
    points.push_back(view.T_world_camera *
                     view.camera.backproject(p.u, p.v, static_cast<double>(p.depth)));
  }
  return points;
}

}  // namespace

TemplateEstimator::TemplateEstimator(const Config& config, const LabelSpace& label_space)
    : config_(config) {
  for (const TemplateCad::ClassRules& rules : config.templates) {
    const LabelSpace::Entry* entry = label_space.find(rules.class_name);
    if (!entry) continue;
    templates_.try_emplace(entry->label, Template{rules, TemplateModel(readMesh(rules.mesh))});
  }
}

ShapeOutcome TemplateEstimator::estimate(const ShapeObservation& best,
                                         std::span<const ShapeObservation>, std::uint64_t) const {
  ShapeOutcome outcome;
  const auto entry = templates_.find(best.label);
  if (entry == templates_.end()) {
    outcome.failure = "no template of its class";
    return outcome;
  }
  std::vector<Eigen::Vector3d> points;
  std::optional<Footprint> footprint;
  {
    const StageTimes::Scope stage(outcome.times, "measure");
    points = pointsOf(best, config_.trim);
    if (!points.empty()) footprint = footprintOf(points);
  }
  if (!footprint) {
    outcome.failure = "its points span no area";
    return outcome;
  }
  Aabb box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  if (!entry->second.rules.admits(*footprint, box.sizes().z())) {
    outcome.failure = "its extents are not those of its class";
    return outcome;
  }
  const StageTimes::Scope stage(outcome.times, "place");
  TemplateModel::Placed placed =
      entry->second.model.place(config_.placement, footprint->center, *footprint, points);
  outcome.estimate = {.T_camera_object = best.T_world_camera.inverse() * placed.T_world_object,
                      .scale = 1,
                      .mesh = transformed(placed.T_world_object.inverse(), placed.mesh),
                      .inlier_ratio = 1};
  return outcome;
}

void read(ConfigReader& reader, TemplateEstimator::Config& config) {
  reader.field("trim", config.trim, Bounds{0, 0.49});
  auto placement = reader.section("placement");
  read(placement, config.placement);
  readTemplates(reader, config.templates);
}

}  // namespace hydrabench
