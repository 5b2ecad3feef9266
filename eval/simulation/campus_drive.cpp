// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/gaze.h"
#include "eval/simulation/ground_pose.h"
#include "eval/simulation/tour_timing.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSpacing_m = 0.03;  // of the points of the way
constexpr double kWheelbase_m = 0.5;
constexpr double kTrack_m = 0.4;
constexpr double kLeanSmoothing_s = 0.15;  // springs and tyres
constexpr double kMaxPan_rad = 100 * kDegree;
constexpr double kGazeRange_m = 6.0;
constexpr std::size_t kTargetsPerObject = 48;

Tour tourAlong(const CampusTerrain& terrain, const CampusWay& way) {
  Tour tour;
  tour.length_m = way.to_m - way.from_m;
  const int count = static_cast<int>(std::ceil(tour.length_m / kSpacing_m));
  for (int i = 0; i <= count; ++i) {
    const double distance = way.from_m + tour.length_m * i / count;
    tour.points.push_back(terrain.loop().along(distance, CampusWay::kOffset_m).point);
  }
  return tour;
}

/// Rise per metre along world x and y of the plane through the ground below the wheels.
Vector2d slopeBelow(const CampusTerrain& terrain, const Vector2d& place, double yaw) {
  const Vector2d ahead(std::cos(yaw), std::sin(yaw));
  const Vector2d left(-ahead.y(), ahead.x());
  const auto rise = [&](const Vector2d& direction, double distance) {
    const Vector2d half = 0.5 * distance * direction;
    return (terrain.heightAt(place + half) - terrain.heightAt(place - half)) / distance;
  };
  return rise(ahead, kWheelbase_m) * ahead + rise(left, kTrack_m) * left;
}

std::vector<double> unwrapped(std::vector<double> angles) {
  for (std::size_t i = 1; i < angles.size(); ++i) {
    angles[i] = angles[i - 1] + std::remainder(angles[i] - angles[i - 1], 2 * std::numbers::pi);
  }
  return angles;
}

/// Direction of travel at every place. Where the robot stands, that of the nearest move.
std::vector<double> headings(const std::vector<Vector2d>& places) {
  std::vector<double> yaw(places.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::size_t from = i;
    std::size_t to = i;
    while ((places[to] - places[from]).norm() < 0.05 && (from > 0 || to + 1 < places.size())) {
      if (from > 0) --from;
      if (to + 1 < places.size()) ++to;
    }
    const Vector2d travel = places[to] - places[from];
    yaw[i] = std::atan2(travel.y(), travel.x());
  }
  return unwrapped(std::move(yaw));
}

/// Where to look at every moment of the drive, relative to the direction of travel.
std::vector<double> planPan(const Scene& scene, const CampusTerrain& terrain,
                            const std::vector<Vector2d>& stations, const Raycaster& world,
                            const Camera& camera, const TrajectoryConfig& config) {
  std::vector<std::size_t> of_interest;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const LabelSpace::Entry* entry = scene.label_space.find(scene.objects[i].label);
    if (entry && entry->is_object) of_interest.push_back(i);
  }
  const SurfaceTargets targets = surfaceTargets(scene, of_interest, kTargetsPerObject);
  const std::vector<double> yaw = headings(stations);
  std::vector<GazeMoment> moments(stations.size());
  parallelFor(stations.size(), [&](std::size_t i) {
    SightModel sight{world, targets};
    sight.height_m = terrain.heightAt(stations[i]) + config.camera_height_m;
    sight.pitch_rad = config.camera_pitch_deg * kDegree;
    sight.half_vertical_rad = 0.9 * std::atan(0.5 * camera.height / camera.fy);
    sight.max_range_m = kGazeRange_m;
    for (const std::uint32_t target : sight.visibleFrom(stations[i])) {
      const Vector2d to_target = targets.points[target].head<2>() - stations[i];
      const double bearing =
          std::remainder(std::atan2(to_target.y(), to_target.x()) - yaw[i], 2 * std::numbers::pi);
      if (std::abs(bearing) > kMaxPan_rad) continue;
      moments[i].targets.push_back(target);
      moments[i].bearings_rad.push_back(static_cast<float>(bearing));
    }
  });
  return planGaze(moments, targets.object,
                  {0.85 * std::atan(0.5 * camera.width / camera.fx),
                   config.max_yaw_rate_deg_s * kDegree * kMomentSpacing_s});
}

}  // namespace

Transform robotPose(const CampusTerrain& terrain, const Vector2d& place, double yaw_rad) {
  return leaningPose({place.x(), place.y(), terrain.heightAt(place)}, yaw_rad,
                     slopeBelow(terrain, place, yaw_rad));
}

std::vector<StampedPose> driveThroughCampus(const Scene& scene, const CampusTerrain& terrain,
                                            const CampusWay& way, const Raycaster& world,
                                            const Camera& camera, const TrajectoryConfig& config) {
  const Tour tour = tourAlong(terrain, way);
  const std::size_t count = config.numFrames();
  const double duration = static_cast<double>(count - 1) / config.rate_hz;
  const double fastest = arrivalTimes(tour, config, config.max_speed_m_s).back();
  if (fastest > duration) {
    throw InputError(
        fmt::format("trajectory.duration_s: {:.0f} s are too short, a way of {:.0f} m at up to "
                    "{:.2f} m/s takes {:.0f} s",
                    config.duration_s, tour.length_m, config.max_speed_m_s, fastest));
  }
  const std::vector<double> times = timesFor(tour, config, duration);
  const auto num_moments = static_cast<std::size_t>(duration / kMomentSpacing_s) + 2;
  const std::vector<double> pan =
      yawAtFrames(planPan(scene, terrain, placesAt(tour, times, kMomentSpacing_s, num_moments),
                          world, camera, config),
                  config);

  const std::vector<Vector2d> places = placesAt(tour, times, 1 / config.rate_hz, count);
  const std::vector<double> yaw = headings(places);
  std::vector<double> slope_x;
  std::vector<double> slope_y;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d slope = slopeBelow(terrain, places[i], yaw[i]);
    slope_x.push_back(slope.x());
    slope_y.push_back(slope.y());
  }
  slope_x = smoothed(slope_x, kLeanSmoothing_s * config.rate_hz);
  slope_y = smoothed(slope_y, kLeanSmoothing_s * config.rate_hz);

  // From the camera's axes to the body's, without pan.
  const Transform T_body_camera =
      cameraPose({0, 0}, config.camera_height_m, 0, config.camera_pitch_deg * kDegree);
  std::vector<StampedPose> trajectory;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d& p = places[i];
    const Transform T_world_body =
        leaningPose({p.x(), p.y(), terrain.heightAt(p)}, yaw[i], {slope_x[i], slope_y[i]});
    const auto stamp =
        static_cast<std::int64_t>(std::llround(1e9 * static_cast<double>(i) / config.rate_hz));
    trajectory.push_back(
        {stamp, T_world_body * Eigen::AngleAxisd(pan[i], Vector3d::UnitZ()) * T_body_camera});
  }
  return trajectory;
}

}  // namespace hydrabench
