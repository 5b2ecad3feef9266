// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/ground/ground_scan.h"
#include "core/types/random.h"

namespace hydrabench {

inline constexpr double kFar = 1000;

/// From `low` to `high` along every axis [m].
struct Limits {
  Eigen::Vector3d low{-kFar, -kFar, -kFar};
  Eigen::Vector3d high{kFar, kFar, kFar};
  bool contain(const Eigen::Vector3d& point) const {
    constexpr double kRounding = 1e-9;
    return ((point - low).array() >= -kRounding).all() &&
           ((high - point).array() >= -kRounding).all();
  }
};

/// A piece of a plane {p : normal . p = offset} within a box, in the frame of the sensor [m].
struct Sheet {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  Limits limits;
  bool ground = false;
};

/// Level ground below a sensor at some height; a part of it where x lies between two values.
inline Sheet level(double z, double x_begin = -kFar, double x_end = kFar) {
  return {Eigen::Vector3d::UnitZ(), z, {{x_begin, -kFar, -kFar}, {x_end, kFar, kFar}}, true};
}
/// A wall across x, up from z_low.
inline Sheet wall(double x, double z_low, double z_high) {
  return {Eigen::Vector3d::UnitX(), x, {{-kFar, -kFar, z_low}, {kFar, kFar, z_high}}, false};
}
/// The five visible faces of a box that stands on the ground.
inline std::vector<Sheet> standing(const Limits& box) {
  std::vector<Sheet> sheets;
  const auto face = [&](int axis, double at) {
    sheets.push_back({Eigen::Vector3d::Unit(axis), at, box, false});
    sheets.back().limits.low[axis] = -kFar;
    sheets.back().limits.high[axis] = kFar;
  };
  for (const int axis : {0, 1}) {
    face(axis, box.low[axis]);
    face(axis, box.high[axis]);
  }
  face(2, box.high.z());
  return sheets;
}

struct BeamPattern {
  std::vector<double> angles_deg;  ///< of the lines above the horizontal
  int columns = 0;                 ///< per turn
};
inline BeamPattern evenBeams(int lines, double lowest_deg, double highest_deg, int columns) {
  BeamPattern pattern{{}, columns};
  for (int i = 0; i < lines; ++i) {
    pattern.angles_deg.push_back(lowest_deg + (highest_deg - lowest_deg) * i / (lines - 1));
  }
  return pattern;
}
inline BeamPattern hdl64() { return evenBeams(64, -24.8, 2, 1800); }
inline BeamPattern vlp16() { return evenBeams(16, -15, 15, 1800); }

/// What a sensor at the origin sees of sheets, with the truth about every point.
struct AnalyticScan {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint16_t> lines;
  std::vector<float> intensity;
  std::vector<std::uint8_t> on_ground;
  double sensor_height_m = 0;

  void add(const Eigen::Vector3d& point, bool ground, float strength = 0.5f,
           std::uint16_t line = 0) {
    points.push_back(point.cast<float>());
    lines.push_back(line);
    intensity.push_back(strength);
    on_ground.push_back(ground);
  }
  GroundScan view() const { return {7, points, intensity, lines, {}, sensor_height_m}; }
};

/// @param noise_m  deviation of the range
inline AnalyticScan lookAt(const std::vector<Sheet>& sheets, const BeamPattern& beams,
                           double sensor_height_m, double noise_m = 0, std::uint64_t seed = 1) {
  constexpr double kReach = 100;
  AnalyticScan scan;
  scan.sensor_height_m = sensor_height_m;
  Random random(seed);
  for (int column = 0; column < beams.columns; ++column) {
    const double azimuth = 2 * std::numbers::pi * (column + 0.37) / beams.columns;
    for (std::size_t line = 0; line < beams.angles_deg.size(); ++line) {
      const double angle = beams.angles_deg[line] * std::numbers::pi / 180;
      const Eigen::Vector3d ray(std::cos(angle) * std::cos(azimuth),
                                std::cos(angle) * std::sin(azimuth), std::sin(angle));
      double range = kReach;
      const Sheet* hit = nullptr;
      for (const Sheet& sheet : sheets) {
        const double distance = sheet.offset / sheet.normal.dot(ray);
        if (!(distance > 0) || distance >= range) continue;
        if (!sheet.limits.contain(distance * ray)) continue;
        range = distance;
        hit = &sheet;
      }
      const double measured = range + noise_m * random.normal();
      if (hit) scan.add(measured * ray, hit->ground, 0.5f, static_cast<std::uint16_t>(line));
    }
  }
  return scan;
}

/// Shares of points that are rightly told.
struct GroundScore {
  double hits = 0, false_alarms = 0, misses = 0;
  double precision() const { return hits / (hits + false_alarms); }
  double recall() const { return hits / (hits + misses); }
  double f1() const { return 2 * hits / (2 * hits + false_alarms + misses); }
  GroundScore& operator+=(const GroundScore& other) {
    hits += other.hits;
    false_alarms += other.false_alarms;
    misses += other.misses;
    return *this;
  }
};

/// Of the points at horizontal ranges within the limits; ground that is not judged is missed.
inline GroundScore scoreOf(const AnalyticScan& scan, const GroundMask& mask, double min_range_m = 0,
                           double max_range_m = kFar) {
  GroundScore score;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const double range = static_cast<double>(scan.points[i].head<2>().norm());
    if (range < min_range_m || range > max_range_m) continue;
    const bool said = mask.classes[i] == GroundClass::kGround;
    score.hits += scan.on_ground[i] && said;
    score.false_alarms += !scan.on_ground[i] && said;
    score.misses += scan.on_ground[i] && !said;
  }
  return score;
}

}  // namespace hydrabench
