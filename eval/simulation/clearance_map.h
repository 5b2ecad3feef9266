// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "eval/simulation/scene.h"

namespace hydrabench {

/// Distance from every place on the floor to the nearest thing a robot of some height would touch,
/// on a grid made from the meshes.
class ClearanceMap {
 public:
  static constexpr double kCell_m = 0.05;

  /// Obstacles are all surfaces between z_low and z_high [m], and whatever lies outside of the
  /// rooms.
  ClearanceMap(const Scene& scene, double z_low, double z_high);

  double at(const Eigen::Vector2d& point) const;  ///< [m], bilinear; 0 outside of the map
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cellAt(const Eigen::Vector2d& point) const;  ///< nearest cell
  Eigen::Vector2d center(std::size_t cell) const;
  double atCell(std::size_t cell) const { return distance_m_[cell]; }

 private:
  void markTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    double z_low, double z_high);
  void markOutside(const Scene& scene);

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  ///< centre of cell 0
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> distance_m_;
};

/// Cheapest ways from one cell to all others: distance, dearer where it gets tight. Cells closer to
/// an obstacle than the robot's radius are never entered.
class RouteMap {
 public:
  RouteMap(const ClearanceMap& map, std::size_t start, double robot_radius_m);
  double cost(std::size_t cell) const {
    return cost_[cell];
  }  ///< infinite where it cannot be reached
  bool reaches(std::size_t cell) const;
  std::vector<std::size_t> route(
      std::size_t to) const;  ///< cells from the start to `to`, both included

 private:
  std::vector<float> cost_;
  std::vector<std::uint32_t> previous_;
};

}  // namespace hydrabench
