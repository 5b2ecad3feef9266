// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_input.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/lidar/deskew.h"
#include "core/lidar/image_transfer.h"
#include "core/lidar/lidar_view.h"
#include "core/lidar/scan_check.h"
#include "core/mapping/ground/ground_scan.h"
#include "core/types/error.h"

namespace hydrabench {
LidarInput::Config::Config() {
  ground.patchwork = Patchwork::Config::forSensor("vlp16");
  integrator.max_range_difference_m = 0.75;
  integrator.constant_weight = true;
  integrator.ground_band.extra_m = 3;
}

LidarInput::LidarInput(const Config& config, const LabelSpace& label_space,
                       std::vector<Label> moving)
    : config_(config),
      moving_(std::move(moving)),
      ground_(config.enabled ? makeGroundSegmenter(config.ground, label_space) : nullptr),
      integrator_(config.integrator),
      depth_(config.depth) {}

void LidarInput::integrate(const Frame& frame, ActiveWindow& window, StageTimes& times) {
  if (!config_.enabled) return;
  for (const LidarScan& scan : frame.scans) {
    requireUsable(scan);
    num_points_ += scan.points.size();
    const auto without_return =
        std::count_if(scan.points.begin(), scan.points.end(),
                      [](const Eigen::Vector3f& p) { return !isMeasured(p); });
    num_without_return_ += static_cast<std::size_t>(without_return);
    if (static_cast<std::size_t>(without_return) == scan.points.size()) {
      ++num_empty_;
      continue;
    }
    std::vector<Eigen::Vector3f> points;
    PointLooks looks;
    {
      const StageTimes::Scope stage(times, "image_transfer");
      points = config_.deskew ? deskewed(scan) : scan.points;
      looks = looksFromImage(frame, points, scan.T_world_lidar, config_.image_transfer);
      if (!scan.labels.empty()) looks.labels = scan.labels;
    }
    GroundMask ground;
    {
      const StageTimes::Scope stage(times, "ground");
      const std::vector<Eigen::Vector3f> level = levelled(points, scan.T_world_lidar);
      ground = ground_->segment({.stamp_ns = scan.stamp_ns,
                                 .points = level,
                                 .intensity = scan.intensity,
                                 .lines = scan.rings,
                                 .labels = looks.labels,
                                 .sensor_height_m = config_.sensor_height_m});
    }
    {
      const StageTimes::Scope stage(times, "lidar_integrate");
      std::vector<std::uint8_t> moving(looks.labels.size());
      std::transform(looks.labels.begin(), looks.labels.end(), moving.begin(), [&](Label label) {
        return std::find(moving_.begin(), moving_.end(), label) != moving_.end();
      });
      const LidarView view(scan,
                           {.points = points,
                            .labels = looks.labels,
                            .colors = looks.colors,
                            .uncolored = looks.uncolored,
                            .ground = ground.classes,
                            .moving = moving},
                           config_.min_range_m, config_.max_range_m);
      window.integrate(view.view(), integrator_);
    }
    if (replacesDepth()) depth_.add(std::move(points), scan.T_world_lidar);
    ++num_scans_;
  }
}

std::vector<std::string> LidarInput::notes() const {
  std::vector<std::string> notes;
  if (num_without_return_ > 0) {
    notes.push_back(
        fmt::format("lidar: {} of {} points are not finite or at the sensor, and passed over",
                    num_without_return_, num_points_));
  }
  if (num_empty_ > 0) {
    notes.push_back(fmt::format("lidar: {} sweeps without any return, passed over", num_empty_));
  }
  return notes;
}

Frame LidarInput::withLidarDepth(const Frame& frame, StageTimes& times) const {
  const StageTimes::Scope stage(times, "lidar_depth");
  Frame with = frame;
  with.scans.clear();
  with.depth = depth_.depth(frame);
  if (config_.object_depth == "filled" && !frame.depth.empty()) {
    std::transform(frame.depth.begin(), frame.depth.end(), with.depth.begin(), with.depth.begin(),
                   [](float camera, float lidar) { return camera > 0.0f ? camera : lidar; });
  }
  return with;
}

void LidarInput::requireScans() const {
  if (!config_.enabled || num_scans_ > 0) return;
  if (num_empty_ > 0) {
    throw InputError(
        fmt::format("none of the {} lidar sweeps has a return: all points are not finite or at the "
                    "sensor; expected points in metres around it",
                    num_empty_));
  }
  throw InputError(
      "lidar.enabled is true, but no frame came with a lidar scan; expected a dataset with a lidar "
      "whose stamps overlap those of the camera, or lidar.enabled: false");
}

void read(ConfigReader& reader, LidarInput::Config& config) {
  reader.field("enabled", config.enabled);
  reader.field("min_range_m", config.min_range_m, Bounds{0, 1000});
  reader.field("max_range_m", config.max_range_m, Bounds{0.01, 1000});
  if (!(config.min_range_m < config.max_range_m)) {
    reader.fault("max_range_m", "is not above min_range_m; expected a range of distances");
  }
  reader.field("sensor_height_m", config.sensor_height_m, Bounds{0.01, 100});
  reader.field("deskew", config.deskew);
  reader.field("camera_in_map", config.camera_in_map);
  reader.choice("object_depth", config.object_depth, {"camera", "lidar", "filled"});
  auto ground = reader.section("ground");
  read(ground, config.ground);
  auto image_transfer = reader.section("image_transfer");
  read(image_transfer, config.image_transfer);
  auto depth = reader.section("depth");
  read(depth, config.depth);
  auto integrator = reader.section("integrator");
  read(integrator, config.integrator);
}

void requireBandInMesh(ConfigReader& window_reader, const ActiveWindow::Config& window,
                       const LidarInput::Config& lidar) {
  const TsdfIntegrator::GroundBand& band = lidar.integrator.ground_band;
  if (!lidar.enabled || band.extra_m == 0 || window.mesh_min_weight <= band.weight) return;
  window_reader.fault(
      "mesh_min_weight",
      fmt::format("{} is above lidar.integrator.ground_band.weight, {}; expected at most that, or "
                  "extra_m: 0: the mesh would have nothing of the band",
                  window.mesh_min_weight, band.weight));
}

}  // namespace hydrabench
