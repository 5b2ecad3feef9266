// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/sensor_view.h"
#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// Fuses range images into a TSDF by projecting voxels into the image, as Hydra and Khronos do
/// (Curless and Levoy, SIGGRAPH 1996). The signed
/// distance of a voxel is measured range minus its own range, along the ray. In parallel over
/// blocks; results do not depend on the number of threads.
///
/// Behind ground that is seen at a grazing angle, a distance along the ray is many times the
/// distance to the surface, and the voxels just below the ground fall behind the band: there is no
/// change of sign, and the ground has holes. The ground band (paper, "Ground-Aware Adaptive
/// Integration Strategy") lets measurements of ground through up to extra_m behind the band,
/// clamped to its lower end, with a small constant weight. Where anything is measured, before or
/// after, that alone counts (the paper leaves it to the weights), so that surfaces other than
/// ground are the same with and without the band. Where nothing is, as behind a kerb, a step or the
/// edge of a terrace, it fills what is empty. Hydra's extra_integration_distance is similar; with a
/// list of labels it also drops free space in front of whatever is not listed, which is not done
/// here.
class TsdfIntegrator {
 public:
  /// Of views that tell the ground.
  struct GroundBand {
    double extra_m = 0;    ///< the paper's d_extra; 0: off
    double weight = 1e-3;  ///< a mesh that asks for more has none of it, see mesh_min_weight
    /// Rows of a lidar meet the ground metres apart: seen from 0.5 m, rows of 0.4 degrees are 6 m
    /// apart at 20 m. So a voxel between two rows that both measured ground, more than a voxel
    /// apart, is compared with the plane through both instead of the nearer row, whose range is
    /// wrong by up to half of that, and the reach of the band counts from the farther row. Up to
    /// the truncation distance above the plane its distance is that to the plane: at a grazing
    /// angle the distance along the ray is truncated a centimetre above and below the ground, and
    /// the mesh knows its height no better than to half a voxel. Not in the paper.
    /// false: the nearer row decides, along the ray, as everywhere else.
    bool between_rows = true;
    /// With between_rows: ground farther from a lidar says nothing of the ground; what stands on it
    /// is seen as without the band. 30 m away, from 0.5 m, a ray meets it at one degree: half a row
    /// is 10 cm of height there, and every bump hides metres.
    double max_range_m = 30;
  };
  struct Config {
    /// nearest, bilinear, or adaptive: bilinear unless the four ranges around the projection differ
    /// by more than max_range_difference_m.
    std::string interpolation = "adaptive";
    double max_range_difference_m = 0.2;
    bool constant_weight = false;  ///< leave out the 1/depth^2 of the sensor noise
    bool weight_dropoff = true;    ///< weight falls to 0 across the band behind the surface
    double dropoff_start_voxels = 1;
    double min_weight = 1e-4;  ///< of one measurement
    double max_weight = 1e5;   ///< of a voxel
    GroundBand ground_band = {};
  };
  explicit TsdfIntegrator(const Config& config) : config_(config) {}

  /// Updates every voxel in view, allocating blocks; blocks that got no measurement are not kept.
  /// @return  blocks that changed, in order of IndexLess
  std::vector<BlockIndex> integrate(const SensorView& view, TsdfVolume& volume) const;

  /// Updates the given blocks, which must exist, and no others: for a volume around one object.
  void integrateBlocks(const SensorView& view, std::span<const BlockIndex> blocks,
                       TsdfVolume& volume) const;

 private:
  Config config_;
};

void read(ConfigReader& reader, TsdfIntegrator::Config& config);

}  // namespace hydrabench
