// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// Exact nearest neighbours among 3-D points (FLANN single kd-tree, exact search). Queries are
/// thread-safe.
class NearestNeighbor {
 public:
  struct Match {
    std::size_t index = 0;
    double squared_distance = 0;  ///< [m^2]
  };
  explicit NearestNeighbor(
      std::span<const Eigen::Vector3d> points);  ///< throws InputError when empty
  ~NearestNeighbor();
  NearestNeighbor(NearestNeighbor&&) noexcept;
  NearestNeighbor& operator=(NearestNeighbor&&) noexcept;

  Match nearest(const Eigen::Vector3d& query) const;
  /// Nearest point of every query; in parallel over queries.
  std::vector<Match> nearest(std::span<const Eigen::Vector3d> queries) const;
  /// Indices of all points within `radius` [m] (inclusive), ascending.
  std::vector<std::size_t> within(const Eigen::Vector3d& query, double radius) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench
