// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/object_reconstruction.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "core/mapping/frame_check.h"
#include "core/mapping/marching_cubes.h"
#include "core/objects/observed_blocks.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr Label kObject = 1;  // what binary fusion counts
constexpr Label kOther = 0;

/// One object in the works.
struct Reconstruction {
  const Track* track = nullptr;
  std::unique_ptr<TsdfVolume> volume;
  std::unique_ptr<ObservedBlocks> observed;
  std::vector<BlockIndex> blocks;  ///< that have voxels
  std::vector<BlockIndex> added;   ///< those of them that were added last
};

Aabb extentOf(const Track& track) {
  Aabb extent;
  for (const Observation& observation : track.observations) extent.extend(observation.box);
  return extent;
}

/// Twice the extent around its middle, empty as yet.
Reconstruction begin(const ObjectReconstruction::Config& config, const Track& track,
                     const Aabb& extent) {
  const double share_m =
      std::max(config.voxel_share * extent.sizes().maxCoeff(), config.min_voxel_m);
  TsdfVolume::Config tsdf;
  tsdf.voxel_size_m = config.voxel_m > 0 ? config.voxel_m : share_m;
  requireInsideGrid(track.lastSeenNs(), extent.center(), tsdf.voxel_size_m);
  tsdf.truncation_m = config.truncation_voxels * tsdf.voxel_size_m;
  tsdf.voxels_per_side = config.voxels_per_side;
  tsdf.semantics.type = "binary";

  const std::string& interpolation = config.integrator.interpolation;
  const double max_difference_m = interpolation == "nearest" ? 0.0
                                  : interpolation == "adaptive"
                                      ? config.integrator.max_range_difference_m
                                      : std::numeric_limits<double>::infinity();
  Reconstruction work;
  work.track = &track;
  work.volume = std::make_unique<TsdfVolume>(tsdf);
  work.observed = std::make_unique<ObservedBlocks>(
      work.volume->grid(), Aabb(extent.center() - extent.sizes(), extent.center() + extent.sizes()),
      tsdf.truncation_m, max_difference_m);
  return work;
}

const Observation* observationAt(const Track& track, std::int64_t stamp_ns) {
  const auto it =
      std::lower_bound(track.observations.begin(), track.observations.end(), stamp_ns,
                       [](const Observation& o, std::int64_t stamp) { return o.stamp_ns < stamp; });
  return it != track.observations.end() && it->stamp_ns == stamp_ns ? &*it : nullptr;
}

/// Frames of the buffer that show at least one of the objects, by ascending stamps.
std::vector<std::shared_ptr<const BufferedFrame>> framesOf(const std::vector<Reconstruction>& works,
                                                           const FrameBuffer& buffer) {
  std::vector<std::int64_t> stamps;
  for (const Reconstruction& work : works) {
    for (const Observation& o : work.track->observations) stamps.push_back(o.stamp_ns);
  }
  std::sort(stamps.begin(), stamps.end());
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  std::vector<std::shared_ptr<const BufferedFrame>> frames;
  for (const std::int64_t stamp : stamps) {
    if (auto frame = buffer.find(stamp)) frames.push_back(std::move(frame));
  }
  return frames;
}

/// Writes a label into the pixels of one object.
void paint(const Image<std::uint16_t>& ids, const Observation& observation, Label label,
           Image<Label>& labels) {
  const ImageRegion& region = observation.region;
  for (int v = region.v_begin; v < region.v_end; ++v) {
    for (int u = region.u_begin; u < region.u_end; ++u) {
      if (ids(u, v) == observation.candidate_id) labels(u, v) = label;
    }
  }
}

/// Fuses every frame of each object into the blocks added last.
void integrate(const std::vector<std::shared_ptr<const BufferedFrame>>& frames,
               const TsdfIntegrator& integrator, double min_range_m, double max_range_m,
               std::vector<Reconstruction>& works) {
  for (Reconstruction& work : works) {
    for (const BlockIndex& block : work.added) work.volume->allocate(block);
  }
  Image<Label> labels;
  for (const auto& frame : frames) {
    SensorView view = sensorView(frame->frame, min_range_m, max_range_m);
    if (labels.width() != view.range.width() || labels.height() != view.range.height()) {
      labels = Image<Label>(view.range.width(), view.range.height(), kOther);
    }
    view.labels = &labels;
    for (Reconstruction& work : works) {
      const Observation* observation = observationAt(*work.track, view.stamp_ns);
      if (!observation || work.added.empty()) continue;
      paint(frame->ids, *observation, kObject, labels);
      integrator.integrateBlocks(view, work.added, *work.volume);
      paint(frame->ids, *observation, kOther, labels);
    }
  }
}

/// Clears surface in the blocks added last that was measured on other things more often than
/// min_confidence allows.
void carve(double min_confidence, Reconstruction& work) {
  const auto truncation = static_cast<float>(work.volume->config().truncation_m);
  for (const BlockIndex& index : work.added) {
    VoxelBlock& block = *work.volume->find(index);
    for (std::size_t i = 0; i < block.voxels.size(); ++i) {
      TsdfVoxel& voxel = block.voxels[i];
      if (voxel.weight == 0 || voxel.distance > 0) continue;
      const float confidence = block.semantics->share(i, kObject).value_or(0.0f);
      if (confidence < min_confidence) voxel.distance = truncation;
    }
  }
}

/// Blocks of the volume without voxels as yet that a cube around a voxel behind the surface
/// reaches.
std::vector<BlockIndex> blocksAlongside(const Reconstruction& work) {
  const VoxelGrid& grid = work.volume->grid();
  const auto isBorder = [&](int i) { return i == 0 || i == grid.side - 1; };
  std::vector<BlockIndex> blocks;
  for (const BlockIndex& index : work.blocks) {
    const VoxelBlock& block = *work.volume->find(index);
    for (std::size_t i = 0; i < block.voxels.size(); ++i) {
      if (block.voxels[i].weight == 0 || block.voxels[i].distance >= 0) continue;
      const GlobalVoxel voxel = grid.globalOf(index, i);
      const Eigen::Vector3i local = voxel - grid.side * index;
      if (!isBorder(local.x()) && !isBorder(local.y()) && !isBorder(local.z())) continue;
      for (int n = 0; n < 27; ++n) {
        const BlockIndex neighbor =
            grid.blockOf(voxel + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
        if (work.observed->inVolume(neighbor) && !work.volume->find(neighbor)) {
          blocks.push_back(neighbor);
        }
      }
    }
  }
  std::sort(blocks.begin(), blocks.end(), IndexLess());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

/// Vertices with the same bits become one.
Mesh welded(const TriangleSoup& soup) {
  const auto less = [&](std::size_t a, std::size_t b) {
    const Eigen::Vector3d& p = soup.vertices[a];
    const Eigen::Vector3d& q = soup.vertices[b];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return a < b;
  };
  std::vector<std::size_t> order(soup.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), less);
  std::vector<std::size_t> first(order.size());  // corner that a corner shares its place with
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && soup.vertices[order[i]] == soup.vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }

  Mesh mesh;
  std::vector<int> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (first[i] == i) {
      number[i] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(soup.vertices[i]);
      mesh.colors.push_back(soup.colors[i]);
    } else {
      number[i] = number[first[i]];
    }
  }
  for (std::size_t i = 0; i + 2 < order.size(); i += 3) {
    const Eigen::Vector3i face(number[i], number[i + 1], number[i + 2]);
    if (face.x() != face.y() && face.y() != face.z() && face.z() != face.x()) {
      mesh.faces.push_back(face);
    }
  }
  return mesh;
}

Mesh meshOf(const Reconstruction& work, double min_weight) {
  TriangleSoup all;
  for (const BlockIndex& block : work.blocks) {
    const TriangleSoup part = marchingCubes(*work.volume, block, min_weight);
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    all.colors.insert(all.colors.end(), part.colors.begin(), part.colors.end());
  }
  return welded(all);
}

}  // namespace

std::vector<std::optional<Mesh>> ObjectReconstruction::reconstruct(std::span<const Track> tracks,
                                                                   const FrameBuffer& buffer,
                                                                   double min_range_m,
                                                                   double max_range_m) const {
  std::vector<std::optional<Mesh>> meshes(tracks.size());
  std::vector<Reconstruction> works;
  for (const Track& track : tracks) {
    const Aabb extent = extentOf(track);
    const bool has_size = !extent.isEmpty() && extent.sizes().maxCoeff() > 0;
    if (has_size && extent.volume() >= config_.min_volume_m3) {
      works.push_back(begin(config_, track, extent));
    }
  }

  // Through the frames, one view at a time: for the blocks that may hold surface, for their voxels,
  // and for those around what surface there is.
  const auto frames = framesOf(works, buffer);
  for (const auto& frame : frames) {
    const SensorView view = sensorView(frame->frame, min_range_m, max_range_m);
    parallelFor(works.size(), [&](std::size_t i) {
      const Observation* observation = observationAt(*works[i].track, view.stamp_ns);
      if (!observation) return;
      works[i].observed->add(view, frame->ids, observation->candidate_id, observation->region);
    });
  }
  const TsdfIntegrator integrator(config_.integrator);
  for (Reconstruction& work : works) work.blocks = work.added = work.observed->blocks();
  integrate(frames, integrator, min_range_m, max_range_m, works);
  parallelFor(works.size(), [&](std::size_t i) {
    Reconstruction& work = works[i];
    carve(config_.min_confidence, work);
    work.added = blocksAlongside(work);
    work.blocks.insert(work.blocks.end(), work.added.begin(), work.added.end());
    std::sort(work.blocks.begin(), work.blocks.end(), IndexLess());
  });
  integrate(frames, integrator, min_range_m, max_range_m, works);

  parallelFor(works.size(), [&](std::size_t i) {
    Reconstruction& work = works[i];
    carve(config_.min_confidence, work);
    Mesh mesh = meshOf(work, config_.mesh_min_weight);
    work.volume.reset();
    if (mesh.empty()) return;
    const double volume = bounds(mesh).volume();
    if (volume < config_.min_volume_m3 || volume > config_.max_volume_m3) return;
    meshes[static_cast<std::size_t>(work.track - tracks.data())] = std::move(mesh);
  });
  return meshes;
}

void read(ConfigReader& reader, ObjectReconstruction::Config& config) {
  reader.field("voxel_m", config.voxel_m, Bounds{0, 10});
  reader.field("voxel_share", config.voxel_share, Bounds{0.001, 1});
  reader.field("min_voxel_m", config.min_voxel_m, Bounds{0, 10});
  reader.field("voxels_per_side", config.voxels_per_side, Bounds{2, 63});
  reader.field("truncation_voxels", config.truncation_voxels, Bounds{1, 100});
  reader.field("min_volume_m3", config.min_volume_m3, Bounds{0, 1e6});
  reader.field("max_volume_m3", config.max_volume_m3, Bounds{0, 1e6});
  // Above 0: surface that was never measured on the object is always cleared, which is what lets
  // blocks without any be left out.
  reader.field("min_confidence", config.min_confidence, Bounds{1e-6, 1});
  reader.field("mesh_min_weight", config.mesh_min_weight, Bounds{0, 1e6});
  auto integrator = reader.section("integrator");
  read(integrator, config.integrator);
}

}  // namespace hydrabench
