// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// Euclidean clusters (Rusu, "Semantic 3D Object Maps for Everyday Manipulation", 2009; as in PCL):
/// two points belong together if a chain of points with steps of at most `radius` leads from one to
/// the other. Exact, without a tree: points in one cell of half the radius always belong together.
/// @return  indices of each cluster, ascending; clusters in order of their first index
std::vector<std::vector<std::uint32_t>> euclideanClusters(std::span<const Eigen::Vector3d> points,
                                                          double radius);

}  // namespace hydrabench
