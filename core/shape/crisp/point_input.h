// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/shape/crisp/object_points.h"

namespace hydrabench {

/// Frame in which the small network sees an object: upright, turned so that x points from the
/// camera to the object, origin at the median of its points, lengths in multiples of their extent.
struct LocalFrame {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< level frame [m]
  double bearing = 0;  ///< of the local x axis in the level frame [rad]
  double scale = 1;    ///< [m] per unit
  Eigen::Vector3d toLocal(const Eigen::Vector3d& p_level) const;
  Eigen::Vector3d toLevel(const Eigen::Vector3d& p_local) const;
};

/// One view made ready for PointNetwork: points, patches of neighbouring points (the tokens), and
/// which tokens lie near each point.
struct PointInput {
  static constexpr int kObjectPoints = 384;
  static constexpr int kContextPoints = 192;
  static constexpr int kPoints = kObjectPoints + kContextPoints;
  static constexpr int kObjectTokens = 64;
  static constexpr int kContextTokens = 32;
  static constexpr int kTokens = kObjectTokens + kContextTokens;
  static constexpr int kPatch = 16;    ///< points of a token
  static constexpr int kFeatures = 5;  ///< of a point: local x, y, z, height above the floor [m], 1
                                       ///< on the object
  static constexpr int kNear = 3;      ///< tokens a point takes its features from
  static constexpr int kGlobals = 10;

  LocalFrame frame;
  std::vector<float> points;  ///< kPoints x kFeatures, object points first
  std::vector<std::int64_t>
      patches;                      ///< kTokens x kPatch indices of points; the first is the centre
  std::vector<std::int64_t> near;   ///< kObjectPoints x kNear indices of object tokens
  std::vector<float> near_weights;  ///< same size; each point's add up to 1
  /// log scale, height of the median above the floor and of the camera above it [m], distance [m],
  /// log number of points, the four borders that cut the mask, 1 where there is no context.
  std::array<float, kGlobals> globals = {};
  std::vector<std::uint32_t> source;  ///< kObjectPoints indices into ObjectPoints::object
};

/// nullopt with fewer than 5 points on the object.
std::optional<PointInput> makePointInput(const ObjectPoints& points, std::uint64_t seed);

}  // namespace hydrabench
