// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/freespace.h"
#include "core/mapping/map_mesh.h"
#include "core/mapping/sensor_view.h"
#include "core/mapping/tsdf_integrator.h"
#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// The part of the map that still changes: TSDF blocks around the robot, with the mesh of all that
/// was ever mapped. Per frame: integrate(); then, if updateDue(), update().
///
/// The cubes across the border of two blocks belong to the lower one, in x, y and z. So a block
/// that left the window stays for as long as a lower neighbour is in it, and the window reaches one
/// block farther at its upper sides; the neighbour itself, once it has left the window, is not
/// meshed again until it is measured again. Hydra and Khronos archive the upper block at once, and
/// lose those cubes when the lower one is meshed again: a crack where the robot drives toward
/// lower coordinates.
class ActiveWindow {
 public:
  struct Config {
    TsdfVolume::Config tsdf;
    TsdfIntegrator::Config integrator;
    /// spatial: a block that was not updated in this frame leaves the window when its centre is
    /// farther than radius_m from the sensor (Hydra). temporal: when no voxel of it was observed
    /// for window_s (Khronos).
    std::string archive = "spatial";
    double radius_m = 8;
    double window_s = 3;
    double mesh_min_weight = 1e-4;
    double vertex_merge_m = 0.005;
    /// Of a block that left the window and is seen again. both: its old and its new surface are in
    /// the map (Hydra, Khronos). best: the one whose voxels have more weight, so that a place that
    /// was passed is not drawn once more as it looks from afar.
    std::string revisited = "both";
    double output_separation_s = 0.2;  ///< of two updates of the mesh
    /// Keep a list of the voxels that are behind a surface when their block leaves the map: to
    /// judge what a map takes for solid. Voxels the mesh does not see (mesh_min_weight) are left
    /// out.
    bool keep_occupied = false;
    bool track_freespace = false;  ///< keep FreespaceVoxels: motion detection needs them
    FreespaceTracker::Config freespace;
  };
  explicit ActiveWindow(const Config& config);

  /// Fuses a frame into the volume, then, if asked for, tracks free space in the blocks that
  /// changed. Throws InputError too far from the origin, see requireInsideGrid().
  void integrate(const SensorView& view) { integrate(view, integrator_); }
  /// The same for a sensor with an integrator of its own.
  void integrate(const SensorView& view, const TsdfIntegrator& integrator);

  /// True if the last mesh update lies output_separation_s back (or there was none).
  bool updateDue(std::int64_t stamp_ns) const;
  /// First takes the mesh of the blocks that changed since the last time and of their neighbours at
  /// -x, -y, -z, whose cubes reach into them. Then archives the blocks that left the window, and
  /// whose lower neighbours did: they are deleted from the volume and their triangles frozen, those
  /// of this update included. So no measurement is lost, and a block that is seen again later
  /// starts anew.
  /// @return  the archived blocks, in order of IndexLess
  std::vector<BlockIndex> update(std::int64_t stamp_ns, const Eigen::Vector3d& sensor_position);
  /// Takes the mesh of all that is left and archives it: the end of a run.
  void finish();

  const TsdfVolume& volume() const { return volume_; }
  const MapMesh& mesh() const { return mesh_; }
  /// Their centres, in the order in which their blocks left; empty unless kept.
  std::vector<Eigen::Vector3f> takeOccupied() { return std::move(occupied_); }

 private:
  void takeMesh();
  /// Sets the blocks' left_window.
  void closeWindow(std::int64_t stamp_ns, const Eigen::Vector3d& sensor_position);
  void archive(const BlockIndex& block);
  /// Sum of the weights of what was measured in it; 0 where the block is not there.
  double confidence(const BlockIndex& block) const;

  Config config_;
  TsdfIntegrator integrator_;
  FreespaceTracker freespace_;
  TsdfVolume volume_;
  MapMesh mesh_;
  std::vector<Eigen::Vector3f> occupied_;
  std::optional<std::int64_t> last_update_ns_;
};

void read(ConfigReader& reader, ActiveWindow::Config& config);

}  // namespace hydrabench
