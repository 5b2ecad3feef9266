// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/odometry_drift.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/types/random.h"

namespace hydrabench {
namespace {

// Turning on the spot slips as well: a radian counts like this much distance.
constexpr double kDistancePerRadian_m = 0.2;
// Height is constrained by the floor.
constexpr double kVerticalShare = 0.2;

}  // namespace

void read(ConfigReader& reader, OdometryDriftConfig& config) {
  reader.field("translation_m_per_sqrt_m", config.translation_m_per_sqrt_m, {0, 1});
  reader.field("yaw_deg_per_sqrt_m", config.yaw_deg_per_sqrt_m, {0, 45});
  reader.field("smoothness_m", config.smoothness_m, {0.01, 1000});
}

std::vector<Transform> driftedPoses(const std::vector<StampedPose>& trajectory,
                                    const OdometryDriftConfig& config, std::uint64_t seed) {
  std::vector<Transform> poses;
  poses.reserve(trajectory.size());
  // The rate of each error is an Ornstein-Uhlenbeck process over distance s with length l; its
  // integral has variance 2 rate^2 l s for s >> l, which fixes the deviation of the rate.
  const double to_rate = 1 / std::sqrt(2 * config.smoothness_m);
  const double translation_rate = config.translation_m_per_sqrt_m * to_rate;
  const double yaw_rate = config.yaw_deg_per_sqrt_m * std::numbers::pi / 180 * to_rate;
  Random random(seed);
  std::array<double, 4> rates{};  // x, y, z, yaw in units of their deviation
  for (double& rate : rates) rate = random.normal();
  Transform T_odometry_world = Transform::Identity();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Transform& pose = trajectory[i].T_world_camera;
    if (i > 0) {
      const Transform step = trajectory[i - 1].T_world_camera.inverse() * pose;
      const double distance =
          step.translation().norm() +
          kDistancePerRadian_m * rotationAngle(step.linear(), Eigen::Matrix3d::Identity());
      const double keep = std::exp(-distance / config.smoothness_m);
      for (double& rate : rates) rate = keep * rate + std::sqrt(1 - keep * keep) * random.normal();
      const Eigen::Vector3d slip = translation_rate * distance *
                                   Eigen::Vector3d(rates[0], rates[1], kVerticalShare * rates[2]);
      Transform turn = Transform::Identity();  // around the sensor, not around the origin
      turn.translate(pose.translation());
      turn.rotate(Eigen::AngleAxisd(yaw_rate * distance * rates[3], Eigen::Vector3d::UnitZ()));
      turn.translate(-pose.translation());
      turn.pretranslate(slip);
      T_odometry_world = T_odometry_world * turn;
    }
    poses.push_back(T_odometry_world * pose);
  }
  return poses;
}

}  // namespace hydrabench
