// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/patchwork.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr std::size_t kPointsAtATime = 4096;

/// In place of a bin's number.
constexpr int kInvalid = -2;
constexpr int kReflection = -3;

bool isReflection(const Eigen::Vector3f& point, float intensity, double sensor_height_m,
                  const Patchwork::ReflectionConfig& config) {
  const double z = double{point.z()};
  if (z >= -sensor_height_m - config.below_ground_m) return false;
  if (double{intensity} >= config.max_intensity) return false;
  const double angle = std::atan2(z, std::hypot(double{point.x()}, double{point.y()}));
  return angle < config.max_angle_deg * std::numbers::pi / 180;
}

}  // namespace

Patchwork::Patchwork(const Config& config)
    : config_(config), zones_(config.zones), thresholds_(config.adaptive) {}

GroundMask Patchwork::segment(const GroundScan& scan) {
  requireUsable(scan);
  const double sensor_height_m = thresholds_.sensorHeight().value_or(scan.sensor_height_m);
  GroundMask mask;
  const Bins bins = sortIntoBins(scan, sensor_height_m, mask);

  std::vector<std::optional<Patch>> patches(bins.begins.size() - 1);
  std::vector<std::uint8_t> judged(patches.size());
  const std::size_t first_zone_end = static_cast<std::size_t>(zones_.binsOfFirstZone());
  parallelFor(patches.size(), [&](std::size_t bin) {
    const std::span<const BinPoint> points(bins.points.data() + bins.begins[bin],
                                           bins.begins[bin + 1] - bins.begins[bin]);
    if (!hasEnough(points, scan)) return;
    judged[bin] = 1;
    const bool first_zone = bin < first_zone_end;
    patches[bin] =
        fitPatch({points.begin(), points.end()}, first_zone, sensor_height_m, config_.fit);
  });

  for (std::size_t bin = 0; bin < patches.size(); ++bin) {
    if (!judged[bin]) continue;
    for (std::size_t i = bins.begins[bin]; i < bins.begins[bin + 1]; ++i) {
      mask.classes[bins.points[i].index] = GroundClass::kNonGround;
    }
  }
  for (std::size_t ring = 0; ring < zones_.rings().size(); ++ring) judgeRing(ring, patches, mask);
  thresholds_.adapt();
  return mask;
}

Patchwork::Bins Patchwork::sortIntoBins(const GroundScan& scan, double sensor_height_m,
                                        GroundMask& mask) const {
  const std::size_t count = scan.points.size();
  const bool find_reflections = config_.reflection.enabled && !scan.intensity.empty();
  std::vector<int> bin_of(count);
  parallelForRanges(count, kPointsAtATime, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& point = scan.points[i];
      if (!isMeasured(point)) {
        bin_of[i] = kInvalid;
      } else if (find_reflections &&
                 isReflection(point, scan.intensity[i], sensor_height_m, config_.reflection)) {
        bin_of[i] = kReflection;
      } else {
        bin_of[i] = zones_.binOf(double{point.x()}, double{point.y()});
      }
    }
  });

  Bins bins;
  bins.begins.assign(static_cast<std::size_t>(zones_.numBins()) + 1, 0);
  mask.classes.assign(count, GroundClass::kNotJudged);
  for (std::size_t i = 0; i < count; ++i) {
    if (bin_of[i] >= 0) ++bins.begins[static_cast<std::size_t>(bin_of[i]) + 1];
    if (bin_of[i] == kInvalid) ++mask.num_invalid;
    if (bin_of[i] == kReflection) mask.classes[i] = GroundClass::kNonGround;
  }
  for (std::size_t bin = 1; bin < bins.begins.size(); ++bin) {
    bins.begins[bin] += bins.begins[bin - 1];
  }
  bins.points.resize(bins.begins.back());
  std::vector<std::size_t> next = bins.begins;
  for (std::size_t i = 0; i < count; ++i) {
    if (bin_of[i] < 0) continue;
    bins.points[next[static_cast<std::size_t>(bin_of[i])]++] = {scan.points[i],
                                                                static_cast<std::uint32_t>(i)};
  }
  return bins;
}

bool Patchwork::hasEnough(std::span<const BinPoint> bin, const GroundScan& scan) const {
  if (bin.size() < static_cast<std::size_t>(config_.min_points)) return false;
  if (config_.min_lines == 1 || scan.lines.empty()) return true;
  std::vector<std::uint16_t> lines;
  for (const BinPoint& point : bin) lines.push_back(scan.lines[point.index]);
  std::sort(lines.begin(), lines.end());
  const auto end = std::unique(lines.begin(), lines.end());
  return end - lines.begin() >= config_.min_lines;
}

/// A-GLE, and TGR for what it leaves open. Thresholds are those of the scan before; what is kept
/// here counts from the next scan on.
void Patchwork::judgeRing(std::size_t ring, std::span<const std::optional<Patch>> patches,
                          GroundMask& mask) {
  const auto accept = [&](const Patch& patch) {
    for (const BinPoint& point : patch.points) mask.classes[point.index] = GroundClass::kGround;
  };
  const ConcentricZones::Ring& place = zones_.rings()[ring];
  const auto of_ring = patches.subspan(static_cast<std::size_t>(place.first_bin),
                                       static_cast<std::size_t>(place.sectors));
  std::vector<double> flatnesses;
  std::vector<const Patch*> refused;
  for (const std::optional<Patch>& patch : of_ring) {
    if (!patch || patch->plane.normal.z() <= config_.fit.min_uprightness) continue;
    if (!thresholds_.covers(ring)) {
      accept(*patch);
      continue;
    }
    const Plane& plane = patch->plane;
    const bool low = plane.mean.z() < thresholds_.elevation(ring);
    if (low) {
      thresholds_.store(ring, plane.mean.z(), plane.flatness());
      flatnesses.push_back(plane.flatness());
    }
    if (plane.mean.dot(plane.normal) >= 0) continue;  // the sensor is on the plane or below it
    if (low || plane.flatness() < thresholds_.flatness(ring)) {
      accept(*patch);
    } else {
      refused.push_back(&*patch);
    }
  }
  if (!config_.revert.enabled) return;
  const auto ring_flatness = meanDeviation(flatnesses);
  for (const Patch* patch : refused) {
    const double probability =
        revertProbability(*patch, ring_flatness, config_.fit.thickness_m, config_.revert);
    if (probability > config_.revert.min_probability) accept(*patch);
  }
}

}  // namespace hydrabench
