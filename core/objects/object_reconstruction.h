// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/mesh.h"
#include "core/mapping/tsdf_integrator.h"
#include "core/objects/frame_buffer.h"
#include "core/objects/max_iou_tracker.h"

namespace hydrabench {

/// Meshes of tracked objects, each from a fine TSDF of its own (Khronos' MeshObjectExtractor): all
/// buffered frames of the track are fused once more, each voxel counts how often it was measured on
/// the object and off it, and what is less than min_confidence the object's is cleared away. What
/// remains is the side that was seen.
class ObjectReconstruction {
 public:
  struct Config {
    double voxel_m = 0;         ///< 0: voxel_share of the longest side of the track's box
    double voxel_share = 0.02;  ///< of the longest side
    double min_voxel_m = 0;     ///< with voxel_share
    int voxels_per_side = 4;    ///< of a block; Khronos has 8. Small ones hug the surface: faster
    double truncation_voxels = 2;
    double min_volume_m3 = 0.005;  ///< of the track's box, and of the mesh's
    double max_volume_m3 = 10;     ///< of the mesh's box
    double min_confidence = 0.5;   ///< share of the measurements that are on the object
    double mesh_min_weight = 1e-4;
    TsdfIntegrator::Config integrator;
  };
  explicit ObjectReconstruction(const Config& config) : config_(config) {}

  /// Independent of the number of threads, and of which tracks are asked for together.
  /// @param min_range_m, max_range_m  limits of the sensor
  /// @return  a mesh in the world per track, welded; nullopt where nothing remains or a volume is
  ///          out of its limits. Frames that left the buffer are missing without a word.
  std::vector<std::optional<Mesh>> reconstruct(std::span<const Track> tracks,
                                               const FrameBuffer& buffer, double min_range_m,
                                               double max_range_m) const;

 private:
  Config config_;
};

void read(ConfigReader& reader, ObjectReconstruction::Config& config);

}  // namespace hydrabench
