// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "baselines/template_cad/instance_measurement.h"
#include "core/config/config_reader.h"
#include "core/types/ids.h"

namespace hydrabench {

/// A stream of points of which at most `capacity` are kept: every one, then every second, every
/// fourth and so on, always from the whole stream.
class ThinnedPoints {
 public:
  explicit ThinnedPoints(std::size_t capacity) : capacity_(capacity) {}
  void add(std::span<const Eigen::Vector3d> points);
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  std::size_t capacity_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
  std::vector<Eigen::Vector3d> points_;
};

/// An object followed on the floor plan.
struct InstanceTrack {
  Label label = kUnknownLabel;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< moving average, world [m]
  ThinnedPoints points{0};
  std::vector<std::int64_t> stamps_ns;  ///< of its measurements, ascending

  std::int64_t firstSeenNs() const { return stamps_ns.front(); }
  std::int64_t lastSeenNs() const { return stamps_ns.back(); }
};

/// SlideSLAM's object tracking: assignment per class on the distance of centres on the floor.
class InstanceTracker {
 public:
  struct Config {
    double centroid_update = 0.1;  ///< weight of a measurement in the moving average
    int max_points = 10000;        ///< kept of each track
    double lost_after_s = 30;      ///< a track ends when it was not seen for this long
  };
  /// @param gates_m  per class: a measurement farther from a track is never joined to it, and to
  ///                 leave both alone costs as much as this distance. Other classes are passed over
  InstanceTracker(const Config& config, const std::map<Label, double>& gates_m)
      : config_(config), gates_m_(gates_m) {}

  /// Frames in order of their stamps.
  /// @return  tracks that ended before this frame, in the order in which they began
  std::vector<InstanceTrack> update(std::int64_t stamp_ns,
                                    const std::vector<InstanceMeasurement>& measurements);
  /// All that are left, in the order in which they began: the end of a run.
  std::vector<InstanceTrack> takeAll();

 private:
  void updateClass(std::int64_t stamp_ns, Label label, double gate_m,
                   const std::vector<InstanceMeasurement>& measurements);

  Config config_;
  std::map<Label, double> gates_m_;
  std::vector<InstanceTrack> tracks_;
};

void read(ConfigReader& reader, InstanceTracker::Config& config);

}  // namespace hydrabench
