// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/rmcc.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/depth_raster.h"
#include "core/geometry/median.h"
#include "core/geometry/surface_sampling.h"

namespace hydrabench {
namespace {

constexpr std::uint64_t kSeed = 0x526d6363;  ///< of the points

Image<std::uint8_t> maskOf(const Image<float>& depth) {
  Image<std::uint8_t> mask(depth.width(), depth.height());
  std::transform(depth.begin(), depth.end(), mask.begin(),
                 [](float z) { return static_cast<std::uint8_t>(z > 0); });
  return mask;
}

Image<std::uint8_t> maskOfPoints(const Mesh& mesh_camera, const Camera& camera, int count) {
  Image<std::uint8_t> mask(camera.width, camera.height);
  const SurfaceSamples samples = sampleSurface(mesh_camera, static_cast<std::size_t>(count), kSeed);
  for (const Eigen::Vector3d& point : samples.points) {
    const auto pixel = camera.project(point);
    if (!pixel || !camera.sees(*pixel)) continue;
    mask(static_cast<int>(std::floor(pixel->x() + 0.5)),
         static_cast<int>(std::floor(pixel->y() + 0.5))) = 1;
  }
  return mask;
}

/// |a and b| / |of|; 0 where `of` is empty.
double share(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b,
             const Image<std::uint8_t>& of) {
  std::size_t both = 0, all = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    both += static_cast<std::size_t>(a.data()[i] != 0 && b.data()[i] != 0);
    all += static_cast<std::size_t>(of.data()[i] != 0);
  }
  return all == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(all);
}

std::optional<double> medianResidual(const Image<float>& rendered, const ShapeObservation& view) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < rendered.size(); ++i) {
    const float measured = view.depth.data()[i];
    if (view.mask.data()[i] == 0 || !(rendered.data()[i] > 0)) continue;
    if (!(measured > 0) || !std::isfinite(measured)) continue;
    residuals.push_back(std::abs(double{rendered.data()[i]} - double{measured}));
  }
  if (residuals.empty()) return std::nullopt;
  return median(std::move(residuals));
}

}  // namespace

Image<std::uint8_t> projectedMask(const Mesh& mesh_camera, const Camera& camera,
                                  const RmccConfig& config) {
  return config.mask == "raster" ? maskOf(rasterizeDepth(mesh_camera, camera))
                                 : maskOfPoints(mesh_camera, camera, config.points);
}

RmccScores rmccScores(const Mesh& mesh_camera, const ShapeObservation& view,
                      const RmccConfig& config) {
  assert(view.mask.width() == view.camera.width && view.mask.height() == view.camera.height);
  assert(view.depth.size() == view.mask.size());
  const Image<float> rendered = rasterizeDepth(mesh_camera, view.camera);
  const Image<std::uint8_t> covered = maskOf(rendered);
  RmccScores scores;
  scores.coverage = share(covered, view.mask, view.mask);
  scores.depth_residual_m = medianResidual(rendered, view);
  const Image<std::uint8_t> projected =
      config.mask == "raster" ? covered : maskOfPoints(mesh_camera, view.camera, config.points);
  scores.overlap = share(projected, view.mask, projected);
  return scores;
}

const char* rmccRejection(const RmccScores& scores, double diagonal_m, const RmccConfig& config) {
  if (config.check == "none") return nullptr;
  if (!(scores.overlap > config.min_overlap)) return "overlap";
  if (config.check == "published") return nullptr;
  if (!(scores.coverage > config.min_coverage)) return "coverage";
  const double max_residual_m =
      std::max(config.max_depth_residual_m, config.max_depth_residual_share * diagonal_m);
  if (!scores.depth_residual_m || !(*scores.depth_residual_m < max_residual_m)) {
    return "depth_residual";
  }
  return nullptr;
}

void read(ConfigReader& reader, RmccConfig& config) {
  reader.choice("check", config.check, {"none", "published", "extended"});
  reader.field("min_overlap", config.min_overlap, Bounds{0, 1});
  reader.choice("mask", config.mask, {"points", "raster"});
  reader.field("points", config.points, Bounds{1, 1e7});
  reader.field("min_coverage", config.min_coverage, Bounds{0, 1});
  reader.field("max_depth_residual_m", config.max_depth_residual_m, Bounds{0, 1000});
  reader.field("max_depth_residual_share", config.max_depth_residual_share, Bounds{0, 1000});
}

}  // namespace hydrabench
