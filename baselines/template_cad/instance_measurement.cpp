// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/instance_measurement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/geometry/box.h"
#include "core/geometry/median.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// The value at place `rank` (rounded down, from 0) of the sorted values: no interpolation.
float percentile(std::vector<float>& values, double rank) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

InstanceMeasurement measure(const Frame& frame, const ObjectCandidate& candidate,
                            const InstanceMeasurementConfig& config) {
  std::vector<float> depths;
  depths.reserve(candidate.pixels.size());
  for (const std::uint32_t pixel : candidate.pixels) depths.push_back(frame.depth.data()[pixel]);
  const auto last = static_cast<double>(depths.size() - 1);
  const float low = percentile(depths, std::floor(config.low_depth_percentile / 100 * last));
  const float high = percentile(depths, std::ceil(config.high_depth_percentile / 100 * last));

  InstanceMeasurement measurement;
  measurement.label = candidate.label;
  std::vector<double> xs;
  std::vector<double> ys;
  for (const std::uint32_t pixel : candidate.pixels) {
    const float depth = frame.depth.data()[pixel];
    if (depth < low || depth > high) continue;
    const int width = frame.depth.width();
    const Eigen::Vector3d point =
        frame.T_world_camera * frame.camera.backproject(static_cast<int>(pixel) % width,
                                                        static_cast<int>(pixel) / width,
                                                        static_cast<double>(depth));
    measurement.points.push_back(point);
    xs.push_back(point.x());
    ys.push_back(point.y());
  }
  measurement.center = {median(std::move(xs)), median(std::move(ys))};
  return measurement;
}

bool largeEnough(const InstanceMeasurement& measurement, double min_extent_m) {
  Aabb box;
  for (const Eigen::Vector3d& point : measurement.points) box.extend(point);
  return box.sizes().head<2>().maxCoeff() > min_extent_m;
}

}  // namespace

std::vector<InstanceMeasurement> measureInstances(const Frame& frame,
                                                  const FrameCandidates& candidates,
                                                  const InstanceMeasurementConfig& config) {
  std::vector<const ObjectCandidate*> ordered;
  for (const ObjectCandidate& candidate : candidates.candidates) {
    if (!candidate.pixels.empty()) ordered.push_back(&candidate);
  }
  std::sort(ordered.begin(), ordered.end(),
            [](const auto* a, const auto* b) { return a->pixels.front() < b->pixels.front(); });
  std::vector<InstanceMeasurement> measured(ordered.size());
  parallelFor(ordered.size(),
              [&](std::size_t i) { measured[i] = measure(frame, *ordered[i], config); });
  std::erase_if(measured, [&](const InstanceMeasurement& measurement) {
    return !largeEnough(measurement, config.min_extent_m);
  });
  return measured;
}

void read(ConfigReader& reader, InstanceMeasurementConfig& config) {
  reader.field("low_depth_percentile", config.low_depth_percentile, Bounds{0, 100});
  reader.field("high_depth_percentile", config.high_depth_percentile, Bounds{0, 100});
  reader.field("min_extent_m", config.min_extent_m, Bounds{0, 100});
  if (config.low_depth_percentile > config.high_depth_percentile) {
    reader.fault("low_depth_percentile", "is above high_depth_percentile; expected at most that");
  }
}

}  // namespace hydrabench
