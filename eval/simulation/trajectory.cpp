// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/trajectory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/clearance_map.h"
#include "eval/simulation/gaze.h"
#include "eval/simulation/tour.h"
#include "eval/simulation/tour_timing.h"

namespace hydrabench {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kObstacleLow_m = 0.05;  // lower things are driven over: skirting, thresholds
constexpr double kAboveCamera_m = 0.2;  // what is higher than this above the camera is passed under
constexpr double kTourSpeedShare = 0.78;  // of the top speed, leaves time for bends
constexpr std::size_t kTargetsPerObject = 48;
constexpr double kStopRange_m = 3.2;  // stops are chosen for good views;
constexpr double kGazeRange_m = 4.5;  // on the way everything the sensor reaches is worth a look

/// The longest tour that can be driven in the time there is.
Tour planTourFor(const Scene& scene, const ClearanceMap& map, const SightModel& sight,
                 const TrajectoryConfig& config, double duration) {
  double previous = 0;
  for (double share = kTourSpeedShare;; share *= 0.9) {
    Tour tour =
        planTour(scene, map, sight, config.robot_radius_m, share * config.max_speed_m_s * duration);
    const double fastest = arrivalTimes(tour, config, config.max_speed_m_s).back();
    if (fastest <= duration) return tour;
    // Once only the one stop per room is left, a smaller budget changes nothing.
    if (tour.length_m == previous) {
      throw InputError(
          fmt::format("trajectory.duration_s: {:.0f} s are too short, a tour of {:.0f} m at up to "
                      "{:.2f} m/s takes {:.0f} s",
                      config.duration_s, tour.length_m, config.max_speed_m_s, fastest));
    }
    previous = tour.length_m;
  }
}

}  // namespace

std::size_t TrajectoryConfig::numFrames() const {
  return static_cast<std::size_t>(std::lround(duration_s * rate_hz));
}

void read(ConfigReader& reader, TrajectoryConfig& config) {
  reader.field("duration_s", config.duration_s, {1, 1e5});
  reader.field("rate_hz", config.rate_hz, {0.1, 1000});
  reader.field("camera_height_m", config.camera_height_m, {0.1, 2});
  reader.field("camera_pitch_deg", config.camera_pitch_deg, {-45, 60});
  reader.field("robot_radius_m", config.robot_radius_m, {0.05, 0.45});
  reader.field("max_speed_m_s", config.max_speed_m_s, {0.05, 10});
  reader.field("max_acceleration_m_s2", config.max_acceleration_m_s2, {0.05, 20});
  reader.field("max_yaw_rate_deg_s", config.max_yaw_rate_deg_s, {5, 720});
}

Transform cameraPose(const Eigen::Vector2d& place, double height_m, double yaw_rad,
                     double pitch_down_rad) {
  const Eigen::Vector3d eye(place.x(), place.y(), height_m);
  const Eigen::Vector3d ahead(std::cos(pitch_down_rad) * std::cos(yaw_rad),
                              std::cos(pitch_down_rad) * std::sin(yaw_rad),
                              -std::sin(pitch_down_rad));
  return lookAt(eye, eye + ahead);
}

std::vector<StampedPose> makeTrajectory(const Scene& scene, const Raycaster& world,
                                        const Camera& camera, const TrajectoryConfig& config) {
  std::vector<std::size_t> of_interest;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const LabelSpace::Entry* entry = scene.label_space.find(scene.objects[i].label);
    if (entry && entry->is_object) of_interest.push_back(i);
  }
  const SurfaceTargets targets = surfaceTargets(scene, of_interest, kTargetsPerObject);
  const ClearanceMap map(scene, kObstacleLow_m, config.camera_height_m + kAboveCamera_m);
  const SightModel sight{world,
                         targets,
                         config.camera_height_m,
                         config.camera_pitch_deg * kDegree,
                         0.9 * std::atan(0.5 * camera.height / camera.fy),
                         0.5,
                         kStopRange_m};
  const double duration = static_cast<double>(config.numFrames() - 1) / config.rate_hz;
  const Tour tour = planTourFor(scene, map, sight, config, duration);
  const std::vector<double> times = timesFor(tour, config, duration);

  const auto num_moments = static_cast<std::size_t>(duration / kMomentSpacing_s) + 2;
  const std::vector<Eigen::Vector2d> stations =
      placesAt(tour, times, kMomentSpacing_s, num_moments);
  SightModel gaze_sight = sight;
  gaze_sight.max_range_m = kGazeRange_m;
  std::vector<GazeMoment> moments(num_moments);
  parallelFor(num_moments, [&](std::size_t i) {
    const Eigen::Vector2d travel = stations[std::min(i + 2, num_moments - 1)] - stations[i];
    moments[i].heading_rad = std::atan2(travel.y(), travel.x());
    moments[i].targets = gaze_sight.visibleFrom(stations[i]);
    for (const std::uint32_t target : moments[i].targets) {
      const Eigen::Vector2d to_target = targets.points[target].head<2>() - stations[i];
      moments[i].bearings_rad.push_back(
          static_cast<float>(std::atan2(to_target.y(), to_target.x())));
    }
  });
  const std::vector<double> yaw =
      yawAtFrames(planGaze(moments, targets.object,
                           {0.85 * std::atan(0.5 * camera.width / camera.fx),
                            config.max_yaw_rate_deg_s * kDegree * kMomentSpacing_s}),
                  config);

  const std::vector<Eigen::Vector2d> places =
      placesAt(tour, times, 1 / config.rate_hz, config.numFrames());
  std::vector<StampedPose> trajectory;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto stamp =
        static_cast<std::int64_t>(std::llround(1e9 * static_cast<double>(k) / config.rate_hz));
    trajectory.push_back({stamp, cameraPose(places[k], config.camera_height_m, yaw[k],
                                            config.camera_pitch_deg * kDegree)});
  }
  return trajectory;
}

}  // namespace hydrabench
