// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/active_window.h"

#include <algorithm>
#include <cstddef>

#include "core/mapping/marching_cubes.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {

ActiveWindow::ActiveWindow(const Config& config)
    : config_(config),
      integrator_(config.integrator),
      freespace_(config.freespace),
      volume_(config.tsdf),
      mesh_(config.vertex_merge_m) {}

void ActiveWindow::integrate(const SensorView& view) {
  const std::vector<BlockIndex> changed = integrator_.integrate(view, volume_);
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
  std::vector<BlockIndex> left;
  for (const BlockIndex& index : volume_.blockIndices()) {
    const std::int64_t updated_ns = volume_.find(index)->last_updated_ns;
    const double distance_m = (volume_.grid().centerOfBlock(index) - sensor_position).norm();
    const bool outside = config_.archive == "spatial"
                             ? distance_m > config_.radius_m && updated_ns < stamp_ns
                             : static_cast<double>(stamp_ns - updated_ns) * 1e-9 > config_.window_s;
    if (outside) left.push_back(index);
  }
  for (const BlockIndex& index : left) archive(index);
  return left;
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
    for (int n = 0; n < 8; ++n) {
      const BlockIndex lower = index - BlockIndex(n & 1, n >> 1 & 1, n >> 2 & 1);
      if (volume_.find(lower)) outdated.push_back(lower);
    }
  }
  std::sort(outdated.begin(), outdated.end(), IndexLess());
  outdated.erase(std::unique(outdated.begin(), outdated.end()), outdated.end());

  std::vector<TriangleSoup> soups(outdated.size());
  parallelFor(outdated.size(), [&](std::size_t i) {
    soups[i] = marchingCubes(volume_, outdated[i], config_.mesh_min_weight);
  });
  for (std::size_t i = 0; i < outdated.size(); ++i) mesh_.update(outdated[i], soups[i]);
}

void ActiveWindow::archive(const BlockIndex& block) {
  mesh_.archive(block);
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
  reader.field("output_separation_s", config.output_separation_s, Bounds{0.0, 1e6});
  reader.field("track_freespace", config.track_freespace);
  auto freespace = reader.section("freespace");
  read(freespace, config.freespace);
}

}  // namespace hydrabench
