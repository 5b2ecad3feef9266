// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hydrabench::spark_dsg {

// What reader and writer of spark_dsg 1.1.3 must agree on.

inline constexpr const char* kHeader = "SPARK_DSG_header";
inline constexpr std::int64_t kObjectsLayer = 2;
inline constexpr std::int64_t kObjectsPartition = 0;
inline constexpr const char* kObjectsLabelSpace = "_l2p0";  ///< layer 2, partition 0

/// semantic_label of a node without one.
inline constexpr std::uint64_t kNoLabel = 4294967295;

// Ours, in places other programs keep but do not read: the free-form metadata of graph and node.
inline constexpr const char* kLabelSpaceKey = "hydrabench_label_space";
inline constexpr const char* kScaleKey = "scale";
inline constexpr const char* kPoseKey =
    "T_world_object";  ///< 3 x 4, row by row: a quaternion would not give the same bits back
/// Mesh points stand relative to the box centre; adding the centre back may round. [vertex, axis,
/// difference] where it does.
inline constexpr const char* kRemaindersKey = "vertex_remainders_m";

}  // namespace hydrabench::spark_dsg
