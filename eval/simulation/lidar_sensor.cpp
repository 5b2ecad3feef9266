// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/lidar_sensor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/simulation/lidar_pattern.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

constexpr double kDegree = std::numbers::pi / 180;
/// Neighbours in a row lie closest together: one packet of rays each.
constexpr int kBlockColumns = 16;
/// Even black paint returns something.
constexpr float kLeastReflectance = 0.05f;

/// What a block of columns returned, column by column.
struct Returns {
  std::vector<Vector3f> points;
  std::vector<float> intensity;
  std::vector<std::uint16_t> rings;
  std::vector<float> times;
  std::vector<Label> labels;
};

class Sweep {
 public:
  Sweep(const RgbdRenderer& renderer, std::span<const TimedPose> body_poses, std::int64_t start_ns,
        std::int64_t stamp_ns, const LidarSensorConfig& config, std::uint64_t seed)
      : renderer_(renderer),
        body_poses_(body_poses),
        start_ns_(start_ns),
        duration_ns_(static_cast<double>(stamp_ns - start_ns)),
        config_(config),
        T_body_lidar_(config.T_body_lidar()),
        seed_(seed),
        pattern_(lidarPattern(config.pattern)),
        model_(pattern_.model()) {}

  const LidarModel& model() const { return model_; }
  std::size_t numBlocks() const {
    return static_cast<std::size_t>((pattern_.columns + kBlockColumns - 1) / kBlockColumns);
  }
  Returns cast(std::size_t block) const;

 private:
  float timeOf(int column) const {
    return static_cast<float>(column) / static_cast<float>(pattern_.columns);
  }
  std::int64_t stampOf(int column) const {
    return start_ns_ + std::llround(double{timeOf(column)} * duration_ns_);
  }
  Transform poseOf(int column) const {
    const std::optional<Transform> T_world_body = poseAt(body_poses_, stampOf(column));
    assert(T_world_body);
    return *T_world_body * T_body_lidar_;
  }
  /// Of a beam in the sensor's frame.
  Eigen::Vector3d direction(int column, std::size_t ring) const {
    return model_.direction(
        column, (model_.top_rad - pattern_.elevations_rad[ring]) * model_.rowsPerRadian());
  }
  /// Each column of a block meets the movers where they are at its time.
  void meetMovers(int begin, int count, const std::vector<Raycaster::Ray>& rays,
                  std::vector<Raycaster::Hit>& hits) const;
  void judge(int column, std::size_t ring, const Raycaster::Ray& ray, const Raycaster::Hit& hit,
             Returns& returns) const;

  const RgbdRenderer& renderer_;
  std::span<const TimedPose> body_poses_;
  std::int64_t start_ns_;
  double duration_ns_;
  const LidarSensorConfig& config_;
  Transform T_body_lidar_;
  std::uint64_t seed_;
  LidarPattern pattern_;
  LidarModel model_;
};

Returns Sweep::cast(std::size_t block) const {
  const int begin = static_cast<int>(block) * kBlockColumns;
  const int count = std::min(kBlockColumns, pattern_.columns - begin);
  const std::size_t num_rings = pattern_.elevations_rad.size();
  std::vector<Raycaster::Ray> rays(num_rings * static_cast<std::size_t>(count));
  std::vector<Raycaster::Hit> hits(rays.size());
  for (int i = 0; i < count; ++i) {
    const Transform T_world_lidar = poseOf(begin + i);
    for (std::size_t ring = 0; ring < num_rings; ++ring) {
      Raycaster::Ray& ray =
          rays[ring * static_cast<std::size_t>(count) + static_cast<std::size_t>(i)];
      ray.origin = T_world_lidar.translation().cast<float>();
      ray.direction = (T_world_lidar.linear() * direction(begin + i, ring)).cast<float>();
      ray.max_distance = static_cast<float>(config_.max_range_m);
    }
  }
  renderer_.raycaster().intersect(rays, hits);
  if (renderer_.hasMovers()) meetMovers(begin, count, rays, hits);
  Returns returns;
  for (int i = 0; i < count; ++i) {
    for (std::size_t ring = 0; ring < num_rings; ++ring) {
      const std::size_t at = ring * static_cast<std::size_t>(count) + static_cast<std::size_t>(i);
      if (hits[at]) judge(begin + i, ring, rays[at], hits[at], returns);
    }
  }
  return returns;
}

void Sweep::meetMovers(int begin, int count, const std::vector<Raycaster::Ray>& rays,
                       std::vector<Raycaster::Hit>& hits) const {
  const std::size_t num_rings = pattern_.elevations_rad.size();
  std::vector<Raycaster::Ray> column_rays(num_rings);
  std::vector<Raycaster::Hit> column_hits(num_rings);
  for (int i = 0; i < count; ++i) {
    const auto at = [&](std::size_t ring) {
      return ring * static_cast<std::size_t>(count) + static_cast<std::size_t>(i);
    };
    for (std::size_t ring = 0; ring < num_rings; ++ring) {
      column_rays[ring] = rays[at(ring)];
      column_hits[ring] = hits[at(ring)];
    }
    renderer_.intersectMovers(stampOf(begin + i), column_rays, column_hits);
    for (std::size_t ring = 0; ring < num_rings; ++ring) hits[at(ring)] = column_hits[ring];
  }
}

void Sweep::judge(int column, std::size_t ring, const Raycaster::Ray& ray,
                  const Raycaster::Hit& hit, Returns& returns) const {
  const DrawnMesh::SurfaceSample surface = renderer_.sample(stampOf(column), ray, hit);
  // Seen with an interpolated normal, the rim of a round thing may face away a little.
  const float cosine = std::max(0.0f, -surface.normal.dot(ray.direction));
  const float returned = std::max(kLeastReflectance, surface.reflectance.mean()) * cosine;

  // The numbers are drawn in this order whatever is switched on: a return that one config loses is
  // the same in another that keeps it.
  Random random(seed_, static_cast<std::uint64_t>(column) * pattern_.elevations_rad.size() + ring);
  const double noise = random.normal();
  const double fluctuation = std::exp(config_.signal_fluctuation * random.normal());
  const bool dropped = random.chance(config_.random_dropout);
  const double closeness = config_.white_range_m / double{hit.distance};
  const bool too_dark =
      config_.white_range_m > 0 && returned * closeness * closeness * fluctuation < 1;
  if (dropped || too_dark) return;

  double range = double{hit.distance} + config_.range_noise_m * noise;
  if (config_.range_quantum_m > 0) {
    range = std::round(range / config_.range_quantum_m) * config_.range_quantum_m;
  }
  if (range < config_.min_range_m || range > config_.max_range_m) return;
  returns.points.push_back((range * direction(column, ring)).cast<float>());
  returns.intensity.push_back(std::min(returned, 1.0f));
  returns.rings.push_back(static_cast<std::uint16_t>(ring));
  if (duration_ns_ > 0) returns.times.push_back(timeOf(column));
  if (config_.labels) returns.labels.push_back(renderer_.labelOf(hit));
}

template <typename Value>
void append(const std::vector<Value>& more, std::vector<Value>& values) {
  values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

LidarSensorConfig LidarSensorConfig::forPattern(const std::string& pattern,
                                                const std::string& preset) {
  LidarSensorConfig config;
  config.pattern = pattern;
  if (pattern == "hdl64") {
    config.max_range_m = 120;
    config.range_noise_m = 0.02;
    config.white_range_m = 500;
  }
  if (preset == "clean") {
    config.range_noise_m = 0;
    config.range_quantum_m = 0;
    config.white_range_m = 0;
    config.random_dropout = 0;
  } else if (preset == "hard") {
    config.range_noise_m *= 1.5;
    config.white_range_m *= 0.6;
    config.random_dropout = 0.03;
  }
  return config;
}

Transform LidarSensorConfig::T_body_lidar() const {
  Transform pose = Transform::Identity();
  pose.translation() = translation_m;
  pose.linear() = (Eigen::AngleAxisd(yaw_deg * kDegree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch_deg * kDegree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll_deg * kDegree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

void read(ConfigReader& reader, const std::string& preset, LidarSensorConfig& config) {
  bool enabled = config.enabled;
  std::string pattern = config.pattern;
  reader.field("enabled", enabled);
  reader.choice("pattern", pattern, lidarPatternNames());
  config = LidarSensorConfig::forPattern(pattern, preset);
  config.enabled = enabled;
  reader.field("rate_hz", config.rate_hz, {0.1, 100});
  reader.field("offset_s", config.offset_s, {-10, 10});
  reader.field("ego_motion", config.ego_motion);
  std::string labels = config.labels ? "true" : "none";
  reader.choice("labels", labels, {"none", "true"});
  config.labels = labels == "true";
  const Eigen::Vector3d& t = config.translation_m;
  std::vector<double> translation = {t.x(), t.y(), t.z()};
  ConfigReader mount = reader.section("mount");
  mount.field("translation_m", translation, {-100, 100});
  if (translation.size() == 3) {
    config.translation_m = {translation[0], translation[1], translation[2]};
  } else {
    mount.fault("translation_m", "expected three numbers: forward, left, up from the ground");
  }
  mount.field("roll_deg", config.roll_deg, {-180, 180});
  mount.field("pitch_deg", config.pitch_deg, {-180, 180});
  mount.field("yaw_deg", config.yaw_deg, {-180, 180});
  reader.field("min_range_m", config.min_range_m, {0, 1000});
  reader.field("max_range_m", config.max_range_m, {0.1, 10000});
  if (config.min_range_m >= config.max_range_m) {
    reader.fault("max_range_m", "must be larger than min_range_m");
  }
  reader.field("range_noise_m", config.range_noise_m, {0, 10});
  reader.field("range_quantum_m", config.range_quantum_m, {0, 1});
  reader.field("white_range_m", config.white_range_m, {0, 1e6});
  reader.field("signal_fluctuation", config.signal_fluctuation, {0, 10});
  reader.field("random_dropout", config.random_dropout, {0, 1});
}

LidarScan sweep(const RgbdRenderer& renderer, std::span<const TimedPose> body_poses,
                std::int64_t start_ns, std::int64_t stamp_ns, const LidarSensorConfig& config,
                std::uint64_t seed) {
  const Sweep sweep(renderer, body_poses, start_ns, stamp_ns, config, seed);
  std::vector<Returns> blocks(sweep.numBlocks());
  parallelFor(
      blocks.size(), [&](std::size_t block) { blocks[block] = sweep.cast(block); }, 4);
  LidarScan scan;
  scan.start_ns = start_ns;
  scan.stamp_ns = stamp_ns;
  scan.lidar = sweep.model();
  for (const Returns& block : blocks) {
    append(block.points, scan.points);
    append(block.intensity, scan.intensity);
    append(block.rings, scan.rings);
    append(block.times, scan.times);
    append(block.labels, scan.labels);
  }
  return scan;
}

}  // namespace hydrabench
