// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/tour.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr double kCandidateSpacing_m = 0.45;
constexpr double kMargin_m = 0.03;        // stops and smoothing keep this much more than the radius
constexpr double kSecondViewWorth = 0.1;  // of a target seen from another stop already
constexpr double kDetour_m = 0.5;         // every stop costs this much, however near
constexpr double kSpacing_m = 0.03;
constexpr int kSmoothingRounds = 400;

struct Candidate {
  std::size_t cell = 0;
  std::size_t room = 0;
  std::vector<std::uint32_t> visible;
};

std::vector<Candidate> findCandidates(const Scene& scene, const ClearanceMap& map,
                                      const SightModel& sight, const RouteMap& reachable,
                                      double robot_radius_m) {
  std::vector<Candidate> candidates;
  for (std::size_t room = 0; room < scene.rooms.size(); ++room) {
    const Eigen::Vector2d low = scene.rooms[room].box.min().head<2>();
    const Eigen::Vector2d size = scene.rooms[room].box.sizes().head<2>();
    const int nx = std::max(1, static_cast<int>(size.x() / kCandidateSpacing_m));
    const int ny = std::max(1, static_cast<int>(size.y() / kCandidateSpacing_m));
    for (int i = 0; i < nx; ++i) {
      for (int j = 0; j < ny; ++j) {
        const Eigen::Vector2d place =
            low + size.cwiseProduct(Eigen::Vector2d((i + 0.5) / nx, (j + 0.5) / ny));
        const std::size_t cell = map.cellAt(place);
        if (map.atCell(cell) < robot_radius_m + kMargin_m || !reachable.reaches(cell)) continue;
        candidates.push_back({cell, room, {}});
      }
    }
  }
  parallelFor(candidates.size(), [&](std::size_t i) {
    candidates[i].visible = sight.visibleFrom(map.center(candidates[i].cell));
  });
  return candidates;
}

/// An open tour over stops; every stop knows the ways from itself to everywhere.
class StopList {
 public:
  StopList(const ClearanceMap& map, double robot_radius_m) : map_(map), radius_(robot_radius_m) {}

  /// Added length of visiting `cell`, and where in the order that is cheapest.
  std::pair<double, std::size_t> insertion(std::size_t cell) const {
    if (cells_.empty()) return {0, 0};
    std::pair<double, std::size_t> best = {routes_.front().cost(cell), 0};
    best = std::min(best, {routes_.back().cost(cell), cells_.size()});
    for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
      const double added =
          routes_[i].cost(cell) + routes_[i + 1].cost(cell) - routes_[i].cost(cells_[i + 1]);
      best = std::min(best, {added, i + 1});
    }
    return best;
  }
  void insert(std::size_t cell, std::size_t position) {
    cells_.insert(cells_.begin() + static_cast<std::ptrdiff_t>(position), cell);
    routes_.insert(routes_.begin() + static_cast<std::ptrdiff_t>(position),
                   RouteMap(map_, cell, radius_));
  }
  /// Reverses stretches as long as that makes the tour shorter (2-opt).
  void shorten() {
    for (bool improved = true; improved;) {
      improved = false;
      for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
        for (std::size_t j = i + 1; j < cells_.size(); ++j) {
          const double before = leg(i, i + 1) + (j + 1 < cells_.size() ? leg(j, j + 1) : 0);
          const double after = leg(i, j) + (j + 1 < cells_.size() ? leg(i + 1, j + 1) : 0);
          if (after > before - 1e-6) continue;
          std::reverse(cells_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       cells_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          std::reverse(routes_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       routes_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          improved = true;
        }
      }
    }
  }
  std::vector<Eigen::Vector2d> path() const {
    std::vector<Eigen::Vector2d> points = {map_.center(cells_.front())};
    for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
      const std::vector<std::size_t> route = routes_[i].route(cells_[i + 1]);
      for (std::size_t k = 1; k < route.size(); ++k) points.push_back(map_.center(route[k]));
    }
    return points;
  }

 private:
  double leg(std::size_t i, std::size_t j) const { return routes_[i].cost(cells_[j]); }

  const ClearanceMap& map_;
  double radius_;
  std::vector<std::size_t> cells_;
  std::vector<RouteMap> routes_;
};

double lengthOf(const std::vector<Eigen::Vector2d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

std::vector<Eigen::Vector2d> resampled(const std::vector<Eigen::Vector2d>& points, double spacing) {
  std::vector<Eigen::Vector2d> result = {points.front()};
  double left = spacing;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Eigen::Vector2d from = points[i - 1];
    double length = (points[i] - from).norm();
    while (length >= left) {
      from += (points[i] - from) * (left / length);
      result.push_back(from);
      length -= left;
      left = spacing;
    }
    left -= length;
  }
  if (result.size() < 2) result.push_back(points.back());
  return result;
}

/// Pulls every point towards the middle of its neighbours unless that brings it too close to an
/// obstacle: the grid's corners vanish and detours to a stop become rounded bends.
void smooth(const ClearanceMap& map, double clearance_m, std::vector<Eigen::Vector2d>& points) {
  for (int round = 0; round < kSmoothingRounds; ++round) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Eigen::Vector2d target = 0.25 * points[i - 1] + 0.5 * points[i] + 0.25 * points[i + 1];
      const double now = map.at(points[i]);
      if (map.at(target) >= std::min(clearance_m, now)) points[i] = target;
    }
  }
}

/// What the stops so far show of every object.
class Coverage {
 public:
  Coverage(const SurfaceTargets& targets, std::size_t num_objects)
      : targets_(targets),
        views_(targets.points.size(), 0),
        seen_(num_objects, 0),
        total_(num_objects, 0) {
    for (const std::size_t object : targets.object) ++total_[object];
  }
  void add(const Candidate& candidate) {
    for (const std::uint32_t target : candidate.visible) {
      if (views_[target] == 0) ++seen_[targets_.object[target]];
      ++views_[target];
    }
  }
  /// In targets; those of an object of which little was seen so far count more than the last ones
  /// of another.
  double worth(const Candidate& candidate) const {
    double sum = 0;
    for (std::size_t i = 0; i < candidate.visible.size();) {
      const std::size_t object = targets_.object[candidate.visible[i]];
      int fresh = 0;
      int again = 0;
      for (; i < candidate.visible.size() && targets_.object[candidate.visible[i]] == object; ++i) {
        const int views = views_[candidate.visible[i]];
        fresh += views == 0 ? 1 : 0;
        again += views == 1 ? 1 : 0;
      }
      const double total = total_[object];
      sum += std::sqrt(total * (seen_[object] + fresh)) - std::sqrt(total * seen_[object]);
      sum += kSecondViewWorth * again;
    }
    return sum;
  }

 private:
  const SurfaceTargets& targets_;
  std::vector<int> views_;
  std::vector<int> seen_;   ///< targets per object
  std::vector<int> total_;  ///< targets per object
};

}  // namespace

std::vector<std::uint32_t> SightModel::visibleFrom(const Eigen::Vector2d& place) const {
  const Eigen::Vector3d eye(place.x(), place.y(), height_m);
  std::vector<std::uint32_t> near;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < targets.points.size(); ++i) {
    const Eigen::Vector3d to_target = targets.points[i] - eye;
    const double level = to_target.head<2>().norm();
    if (level < min_range_m || to_target.squaredNorm() > max_range_m * max_range_m) continue;
    if (std::abs(std::atan2(to_target.z(), level) + pitch_rad) > half_vertical_rad) continue;
    near.push_back(static_cast<std::uint32_t>(i));
    points.push_back(targets.points[i]);
  }
  const std::vector<std::uint8_t> seen = lineOfSight(world, eye, points);
  std::vector<std::uint32_t> visible;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (seen[i]) visible.push_back(near[i]);
  }
  return visible;
}

Tour planTour(const Scene& scene, const ClearanceMap& map, const SightModel& sight,
              double robot_radius_m, double length_budget_m) {
  // Where the robot can be at all: whatever connects to the roomiest place of the first room (the
  // corridor of an office).
  const Aabb& first = scene.rooms.front().box;
  std::size_t start = map.cellAt(first.center().head<2>());
  for (std::size_t cell = 0;
       cell < static_cast<std::size_t>(map.columns()) * static_cast<std::size_t>(map.rows());
       ++cell) {
    const Eigen::Vector2d p = map.center(cell);
    if (first.contains(Eigen::Vector3d(p.x(), p.y(), first.center().z())) &&
        map.atCell(cell) > map.atCell(start)) {
      start = cell;
    }
  }
  const RouteMap reachable(map, start, robot_radius_m);
  const std::vector<Candidate> candidates =
      findCandidates(scene, map, sight, reachable, robot_radius_m);

  StopList stops(map, robot_radius_m);
  Coverage coverage(sight.targets, scene.objects.size());
  const auto take = [&](const Candidate& candidate) {
    stops.insert(candidate.cell, stops.insertion(candidate.cell).second);
    coverage.add(candidate);
  };
  for (std::size_t room = 0; room < scene.rooms.size(); ++room) {
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates) {
      if (candidate.room == room && (!best || coverage.worth(candidate) > coverage.worth(*best)))
        best = &candidate;
    }
    if (!best) {
      throw InputError(
          fmt::format("trajectory.robot_radius_m: a robot of {:.2f} m does not get into room {}",
                      robot_radius_m, scene.rooms[room].name));
    }
    take(*best);
  }
  stops.shorten();
  while (lengthOf(stops.path()) < length_budget_m) {
    const Candidate* best = nullptr;
    double best_rate = 1;  // targets per metre; less is not worth the way
    for (const Candidate& candidate : candidates) {
      const double rate =
          coverage.worth(candidate) / (stops.insertion(candidate.cell).first + kDetour_m);
      if (rate > best_rate) {
        best = &candidate;
        best_rate = rate;
      }
    }
    if (!best) break;
    take(*best);
    stops.shorten();
  }

  Tour tour;
  tour.points = resampled(stops.path(), kSpacing_m);
  smooth(map, robot_radius_m + kMargin_m, tour.points);
  tour.points = resampled(tour.points, kSpacing_m);
  tour.length_m = lengthOf(tour.points);
  if (tour.length_m < kSpacing_m) {
    throw InputError(fmt::format(
        "trajectory.robot_radius_m: a robot of {:.2f} m has nowhere to go in this scene (no rooms "
        "given, or every way out is too narrow)",
        robot_radius_m));
  }
  return tour;
}

}  // namespace hydrabench
