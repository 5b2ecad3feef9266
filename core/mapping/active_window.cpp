// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/active_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/mapping/frame_check.h"
#include "core/mapping/marching_cubes.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// Calls body(index) for the seven blocks whose cubes reach into a block.
template <typename Body>
void forLowerNeighbors(const BlockIndex& block, const Body& body) {
  for (int n = 1; n < 8; ++n) {
    body(BlockIndex(block - BlockIndex(n & 1, n >> 1 & 1, n >> 2 & 1)));
  }
}

}  // namespace

ActiveWindow::ActiveWindow(const Config& config)
    : config_(config),
      integrator_(config.integrator),
      freespace_(config.freespace),
      volume_(config.tsdf),
      mesh_(config.vertex_merge_m,
            config.revisited == "best" ? MapMesh::Revisited::kBest : MapMesh::Revisited::kBoth) {}

void ActiveWindow::integrate(const SensorView& view, const TsdfIntegrator& integrator) {
  requireInsideGrid(view.stamp_ns, view.T_world_sensor.translation(),
                    std::min(config_.vertex_merge_m, volume_.grid().voxel_size));
  const std::vector<BlockIndex> changed = integrator.integrate(view, volume_);
  if (config_.track_freespace) freespace_.update(changed, view.stamp_ns, volume_);
}

bool ActiveWindow::updateDue(std::int64_t stamp_ns) const {
  // Stamps jitter; a frame that is early by less than a millisecond is on time.
  constexpr double kTolerance_s = 1e-3;
  return !last_update_ns_ || static_cast<double>(stamp_ns - *last_update_ns_) * 1e-9 >
                                 config_.output_separation_s - kTolerance_s;
}

std::vector<BlockIndex> ActiveWindow::update(std::int64_t stamp_ns,
                                             const Eigen::Vector3d& sensor_position) {
  last_update_ns_ = stamp_ns;
  takeMesh();
  closeWindow(stamp_ns, sensor_position);
  std::vector<BlockIndex> left;
  for (const BlockIndex& index : volume_.blockIndices()) {
    bool needed = !volume_.find(index)->left_window;
    forLowerNeighbors(index, [&](const BlockIndex& lower) {
      const VoxelBlock* block = needed ? nullptr : volume_.find(lower);
      needed = needed || (block && !block->left_window);
    });
    if (!needed) left.push_back(index);
  }
  for (const BlockIndex& index : left) {
    archive(index);
    // Its cubes are theirs too: if they are measured again, they can no longer be taken in full.
    forLowerNeighbors(
        index, [&](const BlockIndex& lower) { mesh_.archive(lower, confidence(lower), false); });
  }
  return left;
}

void ActiveWindow::closeWindow(std::int64_t stamp_ns, const Eigen::Vector3d& sensor_position) {
  for (const BlockIndex& index : volume_.blockIndices()) {
    VoxelBlock& block = *volume_.find(index);
    const double distance_m = (volume_.grid().centerOfBlock(index) - sensor_position).norm();
    const double age_s = static_cast<double>(stamp_ns - block.last_updated_ns) * 1e-9;
    const bool outside = config_.archive == "spatial"
                             ? distance_m > config_.radius_m && block.last_updated_ns < stamp_ns
                             : age_s > config_.window_s;
    block.left_window = block.left_window || outside;
  }
}

void ActiveWindow::finish() {
  takeMesh();
  for (const BlockIndex& index : volume_.blockIndices()) archive(index);
}

void ActiveWindow::takeMesh() {
  std::vector<BlockIndex> outdated;
  for (const BlockIndex& index : volume_.blockIndices()) {
    VoxelBlock& block = *volume_.find(index);
    if (!block.mesh_outdated) continue;
    block.mesh_outdated = false;
    block.left_window = false;
    outdated.push_back(index);
    forLowerNeighbors(index, [&](const BlockIndex& lower) {
      const VoxelBlock* neighbor = volume_.find(lower);
      // One that left is meshed again only for what it measured itself.
      if (neighbor && (!neighbor->left_window || neighbor->mesh_outdated)) {
        outdated.push_back(lower);
      }
    });
  }
  std::sort(outdated.begin(), outdated.end(), IndexLess());
  outdated.erase(std::unique(outdated.begin(), outdated.end()), outdated.end());

  std::vector<TriangleSoup> soups(outdated.size());
  parallelFor(outdated.size(), [&](std::size_t i) {
    soups[i] = marchingCubes(volume_, outdated[i], config_.mesh_min_weight);
  });
  for (std::size_t i = 0; i < outdated.size(); ++i) mesh_.update(outdated[i], soups[i]);
}

double ActiveWindow::confidence(const BlockIndex& block) const {
  const VoxelBlock* voxels = volume_.find(block);
  if (voxels == nullptr) return 0;
  // Free space counts, too: near ground, at a grazing angle, is truncated in nearly all voxels.
  double sum = 0;
  for (const TsdfVoxel& voxel : voxels->voxels) {
    if (!voxel.assumed) sum += voxel.weight;
  }
  return sum;
}

void ActiveWindow::archive(const BlockIndex& block) {
  mesh_.archive(block, confidence(block));
  if (config_.keep_occupied) {
    const VoxelGrid& grid = volume_.grid();
    const std::vector<TsdfVoxel>& voxels = volume_.find(block)->voxels;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      if (voxels[i].distance >= 0 || voxels[i].weight < config_.mesh_min_weight) continue;
      occupied_.push_back(grid.centerOf(grid.globalOf(block, i)).cast<float>());
    }
  }
  volume_.remove(block);
}

void read(ConfigReader& reader, ActiveWindow::Config& config) {
  auto tsdf = reader.section("tsdf");
  read(tsdf, config.tsdf);
  auto integrator = reader.section("integrator");
  read(integrator, config.integrator);
  reader.choice("archive", config.archive, {"spatial", "temporal"});
  reader.field("radius_m", config.radius_m, Bounds{0.0, 1e4});
  reader.field("window_s", config.window_s, Bounds{0.0, 1e6});
  reader.field("mesh_min_weight", config.mesh_min_weight, Bounds{0.0, 1e9});
  reader.field("vertex_merge_m", config.vertex_merge_m, Bounds{1e-6, 10.0});
  reader.choice("revisited", config.revisited, {"both", "best"});
  reader.field("output_separation_s", config.output_separation_s, Bounds{0.0, 1e6});
  reader.field("keep_occupied", config.keep_occupied);
  reader.field("track_freespace", config.track_freespace);
  auto freespace = reader.section("freespace");
  read(freespace, config.freespace);
}

}  // namespace hydrabench
