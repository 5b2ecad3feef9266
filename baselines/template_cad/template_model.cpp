// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/template_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMinExtent = 0.01;         // [m] below it a stretch would flatten the template
constexpr std::size_t kSearchPoints = 500;  // enough to tell yaws apart

Transform standing(const Vector3d& position, double yaw) {
  Transform T = Transform::Identity();
  T.translation() = position;
  T.linear() = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

double meanHeight(std::span<const Vector3d> points) {
  double sum = 0;
  for (const Vector3d& point : points) sum += point.z();
  return sum / static_cast<double>(points.size());
}

/// Of the points, but for a few that leaked from elsewhere.
double lowestHeight(std::span<const Vector3d> points) {
  std::vector<double> heights;
  for (const Vector3d& point : points) heights.push_back(point.z());
  const auto fifth_percentile = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
  std::nth_element(heights.begin(), fifth_percentile, heights.end());
  return *fifth_percentile;
}

}  // namespace

TemplateModel::TemplateModel(Mesh mesh) : mesh_(std::move(mesh)) {
  assert(!mesh_.empty());
  const Aabb box = bounds(mesh_);
  const Vector3d origin(box.center().x(), box.center().y(), box.min().z());
  for (Vector3d& vertex : mesh_.vertices) vertex -= origin;
  height_ = box.sizes().z();
  if (const auto footprint = footprintOf(mesh_.vertices)) major_yaw_ = footprint->yaw;
  surface_.add(mesh_);
  surface_.commit();
}

double TemplateModel::yawByChamfer(const Vector3d& position, double step_deg,
                                   std::span<const Vector3d> points) const {
  const std::size_t stride = 1 + (points.size() - 1) / kSearchPoints;
  const auto steps = static_cast<std::size_t>(std::ceil(360 / step_deg - 1e-9));
  std::vector<double> distances(steps, 0.0);
  parallelFor(steps, [&](std::size_t k) {
    const Transform T_object_world =
        standing(position, static_cast<double>(k) * step_deg * kRadiansPerDegree).inverse();
    for (std::size_t i = 0; i < points.size(); i += stride) {
      distances[k] += surface_.nearest(T_object_world * points[i]).distance;
    }
  });
  std::size_t best = 0;
  for (std::size_t k = 1; k < steps; ++k) {
    if (distances[k] < distances[best]) best = k;
  }
  return static_cast<double>(best) * step_deg * kRadiansPerDegree;
}

TemplateModel::Placed TemplateModel::place(const PlacementConfig& config,
                                           const Eigen::Vector2d& center,
                                           const Footprint& footprint,
                                           std::span<const Vector3d> points) const {
  const Eigen::Vector2d on_floor = config.position == "centroid" ? center : footprint.center;
  const double z = config.z == "ground"   ? config.ground_z_m
                   : config.z == "lowest" ? lowestHeight(points)
                                          : meanHeight(points) - 0.5 * height_;
  const Vector3d position(on_floor.x(), on_floor.y(), z);
  double yaw = 0;
  if (config.yaw == "hull_pca") yaw = footprint.yaw - major_yaw_;
  if (config.yaw == "chamfer_search") yaw = yawByChamfer(position, config.yaw_step_deg, points);

  Placed placed{standing(position, yaw), {}};
  Mesh mesh = mesh_;
  if (config.scale == "fitted_to_extents") {
    const Transform T_object_world = placed.T_world_object.inverse();
    Aabb extents;
    for (const Vector3d& point : points) extents.extend(T_object_world * point);
    if (config.z != "centroid")
      extents.extend(Vector3d(extents.center().x(), extents.center().y(), 0));
    const Vector3d factor = extents.sizes()
                                .cwiseMax(kMinExtent)
                                .cwiseQuotient(bounds(mesh_).sizes().cwiseMax(kMinExtent));
    for (Vector3d& vertex : mesh.vertices) vertex = vertex.cwiseProduct(factor);
    if (config.z == "centroid") {
      placed.T_world_object.translation().z() += 0.5 * height_ * (1 - factor.z());
    }
  }
  placed.mesh = transformed(placed.T_world_object, mesh);
  return placed;
}

void read(ConfigReader& reader, PlacementConfig& config) {
  reader.choice("position", config.position, {"centroid", "mid_extent"});
  reader.choice("yaw", config.yaw, {"fixed", "hull_pca", "chamfer_search"});
  reader.field("yaw_step_deg", config.yaw_step_deg, Bounds{0.5, 180});
  reader.choice("scale", config.scale, {"fixed", "fitted_to_extents"});
  reader.choice("z", config.z, {"ground", "lowest", "centroid"});
  reader.field("ground_z_m", config.ground_z_m, Bounds{-1e4, 1e4});
}

}  // namespace hydrabench
