// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "baselines/template_cad/instance_tracker.h"
#include "core/config/config_reader.h"
#include "core/types/ids.h"

namespace hydrabench {

/// An object of the map: one track, or several of the same object seen at different times.
struct Landmark {
  Label label = kUnknownLabel;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< world [m]
  std::vector<Eigen::Vector3d> points;               ///< world [m]
  std::vector<std::int64_t> stamps_ns;               ///< of its measurements, ascending
};

/// SlideSLAM's back-end as far as it matters with given poses: landmarks of a class that lie near
/// each other are one.
class LandmarkMap {
 public:
  struct Config {
    int min_observations = 2;  ///< of a track
    double min_age_s = 0.75;   ///< from its first to its last observation
    double gate_m = 0.75;      ///< a track joins the nearest landmark of its class within this
    /// A track and a landmark that were measured in the same frames are two things: in more than
    /// this share of the frames of the one seen less often they are not joined.
    double max_common_share = 0.5;
  };
  explicit LandmarkMap(const Config& config) : config_(config) {}

  /// Joins the track to a landmark or makes it one; nothing for a track too short.
  void add(InstanceTrack track);
  /// In the order in which they began.
  const std::vector<Landmark>& landmarks() const { return landmarks_; }

 private:
  std::optional<std::size_t> landmarkOf(const InstanceTrack& track) const;

  Config config_;
  std::vector<Landmark> landmarks_;
};

void read(ConfigReader& reader, LandmarkMap::Config& config);

}  // namespace hydrabench
