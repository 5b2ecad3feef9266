// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/objects/object_candidate.h"
#include "core/types/frame.h"

namespace hydrabench {

/// One instance of one frame as SlideSLAM measures it.
struct InstanceMeasurement {
  Label label = kUnknownLabel;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< median x and median y, world [m]
  std::vector<Eigen::Vector3d> points;               ///< world [m]
};

/// Which points of an instance count: those of middling depth, so that neither what the mask leaks
/// in front of the object nor what it leaks behind takes part (SlideSLAM's RGB-D front-end).
struct InstanceMeasurementConfig {
  double low_depth_percentile = 35;   ///< of the depths of an instance, inclusive
  double high_depth_percentile = 45;  ///< inclusive
  /// An instance needs more than this between the points that count, along world x or y.
  double min_extent_m = 0.2;
};

/// In the order of the candidates' first pixels, whatever their ids are. In parallel over
/// candidates; results do not depend on the number of threads.
/// @param candidates  of the same frame; their pixels have a depth
std::vector<InstanceMeasurement> measureInstances(const Frame& frame,
                                                  const FrameCandidates& candidates,
                                                  const InstanceMeasurementConfig& config);

void read(ConfigReader& reader, InstanceMeasurementConfig& config);

}  // namespace hydrabench
