// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/tour_timing.h"

#include <algorithm>
#include <cmath>

namespace hydrabench {
namespace {

constexpr double kYawSmoothing_s = 0.45;

}  // namespace

std::vector<double> arrivalTimes(const Tour& tour, const TrajectoryConfig& config,
                                 double top_speed) {
  const std::vector<Eigen::Vector2d>& p = tour.points;
  const std::size_t n = p.size();
  std::vector<double> speed(n, top_speed);
  constexpr std::size_t kReach = 6;  // points; the bend is measured over this distance
  for (std::size_t i = kReach; i + kReach < n; ++i) {
    const Eigen::Vector2d before = p[i] - p[i - kReach];
    const Eigen::Vector2d after = p[i + kReach] - p[i];
    const double turn =
        std::abs(std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after)));
    const double curvature = turn / (0.5 * (before.norm() + after.norm()) + 1e-6);
    const double limit = std::sqrt(config.max_acceleration_m_s2 / std::max(curvature, 1e-6));
    speed[i] = std::clamp(limit, 0.1 * top_speed, top_speed);
  }
  speed.front() = speed.back() = 0.05 * top_speed;
  const auto propagate = [&](std::size_t from, std::size_t to) {
    const double step = (p[to] - p[from]).norm();
    speed[to] = std::min(
        speed[to], std::sqrt(speed[from] * speed[from] + 2 * config.max_acceleration_m_s2 * step));
  };
  for (std::size_t i = 1; i < n; ++i) propagate(i - 1, i);
  for (std::size_t i = n - 1; i > 0; --i) propagate(i, i - 1);
  std::vector<double> times(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    times[i] = times[i - 1] + (p[i] - p[i - 1]).norm() / (0.5 * (speed[i] + speed[i - 1]));
  }
  return times;
}

std::vector<double> timesFor(const Tour& tour, const TrajectoryConfig& config, double duration) {
  double low = 0.01;
  double high = config.max_speed_m_s;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (arrivalTimes(tour, config, middle).back() > duration ? low : high) = middle;
  }
  return arrivalTimes(tour, config, high);
}

std::vector<Eigen::Vector2d> placesAt(const Tour& tour, const std::vector<double>& times,
                                      double spacing_s, std::size_t count) {
  std::vector<Eigen::Vector2d> places;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = std::min(static_cast<double>(k) * spacing_s, times.back());
    while (i + 2 < times.size() && times[i + 1] < t) ++i;
    const double share = std::clamp((t - times[i]) / (times[i + 1] - times[i]), 0.0, 1.0);
    places.push_back(tour.points[i] + share * (tour.points[i + 1] - tour.points[i]));
  }
  return places;
}

std::vector<double> smoothed(const std::vector<double>& values, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  const int n = static_cast<int>(values.size());
  std::vector<double> result;
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    double weights = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double weight = std::exp(-0.5 * k * k / (sigma * sigma));
      sum += weight * values[static_cast<std::size_t>(std::clamp(i + k, 0, n - 1))];
      weights += weight;
    }
    result.push_back(sum / weights);
  }
  return result;
}

std::vector<double> yawAtFrames(const std::vector<double>& yaw, const TrajectoryConfig& config) {
  std::vector<double> at_frames;
  for (std::size_t k = 0; k < config.numFrames(); ++k) {
    const double moment = static_cast<double>(k) / config.rate_hz / kMomentSpacing_s;
    const auto i = std::min(static_cast<std::size_t>(moment), yaw.size() - 1);
    const std::size_t next = std::min(i + 1, yaw.size() - 1);
    at_frames.push_back(yaw[i] + (moment - static_cast<double>(i)) * (yaw[next] - yaw[i]));
  }
  return smoothed(at_frames, kYawSmoothing_s * config.rate_hz);
}

}  // namespace hydrabench
