// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/simulated_lidar.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "core/types/random.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {

SimulatedLidar::SimulatedLidar(const LidarSensorConfig& config,
                               const std::vector<StampedPose>& trajectory,
                               const std::vector<Transform>& reported_poses,
                               const Transform& T_body_camera, std::uint64_t seed)
    : config_(config), seed_(seed) {
  assert(trajectory.size() == reported_poses.size());
  const Transform T_camera_body = T_body_camera.inverse();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::int64_t stamp_ns = trajectory[i].stamp_ns;
    true_poses_.push_back({stamp_ns, trajectory[i].T_world_camera * T_camera_body});
    reported_poses_.push_back({stamp_ns, reported_poses[i] * T_camera_body});
  }
}

std::int64_t SimulatedLidar::endOf(std::int64_t turn) const {
  const double after_s = config_.offset_s + static_cast<double>(turn) / config_.rate_hz;
  return true_poses_.front().stamp_ns + std::llround(1e9 * after_s);
}

std::vector<LidarScan> SimulatedLidar::scansOf(const RgbdRenderer& renderer,
                                               std::size_t index) const {
  const std::int64_t first_ns = true_poses_.front().stamp_ns;
  const std::int64_t last_ns = true_poses_.at(index).stamp_ns;
  const std::int64_t after_ns = index == 0 ? first_ns - 1 : true_poses_[index - 1].stamp_ns;
  // One turn too early, then forward: the rounding of endOf() decides.
  const double turns =
      (1e-9 * static_cast<double>(after_ns - first_ns) - config_.offset_s) * config_.rate_hz;
  auto turn = static_cast<std::int64_t>(std::floor(turns)) - 1;
  while (endOf(turn) <= after_ns) ++turn;

  const Transform T_body_lidar = config_.T_body_lidar();
  std::vector<LidarScan> scans;
  for (; endOf(turn) <= last_ns; ++turn) {
    const std::int64_t stamp_ns = endOf(turn);
    const std::int64_t start_ns = config_.ego_motion ? endOf(turn - 1) : stamp_ns;
    if (start_ns < first_ns) continue;
    LidarScan scan = sweep(renderer, true_poses_, start_ns, stamp_ns, config_,
                           hashSeed(seed_, static_cast<std::uint64_t>(turn)));
    scan.T_world_lidar_start = *poseAt(reported_poses_, start_ns) * T_body_lidar;
    scan.T_world_lidar = *poseAt(reported_poses_, stamp_ns) * T_body_lidar;
    scans.push_back(std::move(scan));
  }
  return scans;
}

Transform cameraOnBody(double height_m, double pitch_down_deg) {
  return cameraPose({0, 0}, height_m, 0, pitch_down_deg * std::numbers::pi / 180);
}

}  // namespace hydrabench
