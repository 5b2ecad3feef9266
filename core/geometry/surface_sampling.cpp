// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/surface_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/types/random.h"

namespace hydrabench {

SurfaceSamples sampleSurface(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
  // Running sum of areas: a face owns the interval of its area, one without area owns nothing.
  std::vector<double> area_until(mesh.faces.size());
  double total_area = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const Eigen::Vector3i& corners = mesh.faces[face];
    const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(corners[0])];
    const Eigen::Vector3d& b = mesh.vertices[static_cast<std::size_t>(corners[1])];
    const Eigen::Vector3d& c = mesh.vertices[static_cast<std::size_t>(corners[2])];
    total_area += 0.5 * (b - a).cross(c - a).norm();
    area_until[face] = total_area;
  }
  SurfaceSamples samples;
  if (!(total_area > 0)) return samples;

  samples.points.reserve(count);
  samples.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, i);
    // total_area itself is out of reach, so rounding can never select a face behind the last one
    // with area.
    const double area = std::min(random.uniform() * total_area, std::nextafter(total_area, 0.0));
    const auto owner = std::upper_bound(area_until.begin(), area_until.end(), area);
    const auto face = static_cast<std::size_t>(owner - area_until.begin());
    const Eigen::Vector3i& corners = mesh.faces[face];
    const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(corners[0])];
    const Eigen::Vector3d& b = mesh.vertices[static_cast<std::size_t>(corners[1])];
    const Eigen::Vector3d& c = mesh.vertices[static_cast<std::size_t>(corners[2])];
    // Uniform in the triangle (Osada et al., Shape Distributions, ACM TOG 2002, section 4.2).
    const double root = std::sqrt(random.uniform());
    const double along = random.uniform();
    samples.points.emplace_back(a + root * ((b - a) + along * (c - b)));
    samples.faces.push_back(static_cast<std::uint32_t>(face));
  }
  return samples;
}

}  // namespace hydrabench
