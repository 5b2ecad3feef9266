// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "eval/simulation/clearance_map.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kAttempts = 40;

double radians(double degrees) { return degrees * kPi / 180; }

Camera makeCamera(int width, int height, double focal) {
  return {width, height, focal, focal, 0.5 * width, 0.5 * height};
}

/// The errors of a depth camera at half the resolution they are stated for.
DepthNoiseConfig drawNoise(Random& random) {
  DepthNoiseConfig noise;
  noise.lateral_px *= 0.5;
  noise.correlation_px *= 0.5;
  noise.disparity_step_px *= 0.5;
  noise.axial_quadratic *= random.uniform(0.4, 2.5);
  noise.edge_dropout = random.uniform(0, 0.8);
  noise.grazing_start_deg = random.uniform(68, 86);
  return noise;
}

class OfficeViews : public TrainingViews {
 public:
  OfficeViews(const Scene& scene, TrainingViewsConfig config)
      : config_(std::move(config)), clearance_(scene, 0.05, 1.2) {}

  std::optional<DrawnView> draw(Random& random) const override {
    const int width = config_.image_width;
    DrawnView view;
    view.camera = makeCamera(width, width * 2 / 3, width * random.uniform(0.5, 0.9));
    const std::optional<Transform> pose = drawPose(random);
    if (!pose) return std::nullopt;
    view.T_world_camera = *pose;
    view.noise = drawNoise(random);
    view.max_depth_m = config_.max_depth_m;
    return view;
  }

 private:
  std::optional<Transform> drawPose(Random& random) const {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const auto count = static_cast<std::uint32_t>(config_.targets.size());
      const Eigen::Vector3d& target = config_.targets[random.index(count)];
      const double distance = random.uniform(0.7, 4.2);
      const double angle = random.uniform(-kPi, kPi);
      const Eigen::Vector2d place =
          target.head<2>() + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      if (clearance_.at(place) < 0.2) continue;
      const double height =
          random.chance(0.7) ? random.uniform(0.65, 0.95) : random.uniform(0.35, 1.6);
      const double yaw = angle + kPi + radians(14) * random.normal();
      const double to_target = std::atan2(height - target.z(), distance);
      const double pitch = random.chance(0.6) ? radians(8 + 3 * random.normal())
                                              : to_target + radians(6) * random.normal();
      return cameraPose(place, height, yaw, std::clamp(pitch, radians(-15), radians(50)));
    }
    return std::nullopt;
  }

  TrainingViewsConfig config_;
  ClearanceMap clearance_;
};

class StreetViews : public TrainingViews {
 public:
  StreetViews(const StreetBlock& block, TrainingViewsConfig config)
      : config_(std::move(config)), block_(block) {}

  std::optional<DrawnView> draw(Random& random) const override {
    const int width = config_.image_width;
    DrawnView view;
    view.camera = makeCamera(width, width * 3 / 4, width * random.uniform(0.5, 0.75));
    const std::optional<Transform> pose = drawPose(random);
    if (!pose) return std::nullopt;
    view.T_world_camera = *pose;
    view.noise = drawNoise(random);
    view.max_depth_m = random.uniform(5, 7);
    if (random.chance(0.5)) {  // a laser
      view.noise.axial_quadratic = 0;
      view.noise.axial_constant_m = random.uniform(0.005, 0.03);
      view.noise.disparity_step_px = 0;
      view.max_depth_m = config_.max_depth_m;
    }
    view.max_depth_m = std::min(view.max_depth_m, config_.max_depth_m);
    return view;
  }

 private:
  std::optional<Transform> drawPose(Random& random) const {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const auto count = static_cast<std::uint32_t>(config_.targets.size());
      const Eigen::Vector3d& target = config_.targets[random.index(count)];
      // As many from near as from far.
      const double distance = std::exp(random.uniform(std::log(1.2), std::log(10.0)));
      const double angle = random.uniform(-kPi, kPi);
      const Eigen::Vector2d place =
          target.head<2>() + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const double height =
          random.chance(0.7) ? random.uniform(0.45, 0.75) : random.uniform(0.3, 1.7);
      const double z = block_.heightAt(place) + height;
      const double yaw = angle + kPi + radians(16) * random.normal();
      const double to_target = std::atan2(z - target.z(), distance);
      const double pitch = random.chance(0.6) ? radians(4 + 4 * random.normal())
                                              : to_target + radians(6) * random.normal();
      if (!isFree({place.x(), place.y(), z})) continue;
      return cameraPose(place, z, yaw, std::clamp(pitch, radians(-20), radians(45)));
    }
    return std::nullopt;
  }

  bool isFree(const Eigen::Vector3d& eye) const {
    constexpr double kClear_m = 0.25;
    if (std::abs(eye.x()) > kBlockHalfLength_m || std::abs(eye.y()) > kBlockHalfWidth_m) {
      return false;
    }
    const auto blocks = [&](const SceneObject& object) {
      return object.shape->sdf->value(object.T_world_object.inverse() * eye) < kClear_m;
    };
    const std::vector<SceneObject>& objects = block_.scene.objects;
    return std::none_of(objects.begin(), objects.end(), blocks);
  }

  TrainingViewsConfig config_;
  const StreetBlock& block_;
};

}  // namespace

std::unique_ptr<TrainingViews> officeViews(const Scene& scene, const TrainingViewsConfig& config) {
  return std::make_unique<OfficeViews>(scene, config);
}

std::unique_ptr<TrainingViews> streetViews(const StreetBlock& block,
                                           const TrainingViewsConfig& config) {
  return std::make_unique<StreetViews>(block, config);
}

}  // namespace hydrabench
