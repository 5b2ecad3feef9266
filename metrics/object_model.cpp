// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/object_model.h"

#include <cassert>
#include <mutex>

#include "core/geometry/nearest_neighbor.h"
#include "core/geometry/raycaster.h"
#include "core/geometry/surface_sampling.h"
#include "core/types/random.h"
#include "metrics/detection.h"
#include "metrics/oriented_box.h"
#include "metrics/voxelize.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kSnapToZero = 1e-9;  // [m]

/// The same for a mesh wherever it stands and whatever its id.
std::uint64_t seedOf(const Mesh& mesh, ObjectModel::Role role, std::uint64_t seed) {
  std::uint64_t hash = hashSeed(seed, role == ObjectModel::Role::kTruth ? 1 : 0);
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (const int vertex : face) hash = hashSeed(hash, static_cast<std::uint64_t>(vertex));
  }
  return hash;
}

double meanSquaredDistance(const Points& from, const NearestNeighbor& to) {
  double sum = 0;
  for (const Eigen::Vector3d& point : from) sum += to.nearest(point).squared_distance;
  return sum / static_cast<double>(from.size());
}

}  // namespace

struct ObjectModel::Impl {
  Mesh mesh;
  Aabb box;
  OrientedBox oriented_box;
  MeshTopology topology;
  std::uint64_t seed = 0;
  Points samples;
  std::optional<NearestNeighbor> sample_tree;
  Raycaster surface;
  std::vector<std::optional<VoxelSet>> solid_voxels;
  std::vector<std::optional<VoxelSet>> surface_voxels;
  mutable std::once_flag floor_once;
  mutable std::optional<double> floor;

  double computeFloor() const {
    const Points again = sampleSurface(mesh, samples.size(), mixBits(seed)).points;
    return meanSquaredDistance(samples, NearestNeighbor(again)) +
           meanSquaredDistance(again, *sample_tree);
  }
};

ObjectModel::ObjectModel(Mesh mesh_world, Role role, const Config& config)
    : impl_(std::make_unique<Impl>()) {
  assert(config.samples > 0 && config.grid.pitch_m > 0);
  impl_->mesh = std::move(mesh_world);
  const Mesh& mesh = impl_->mesh;
  impl_->box = objectBox(mesh);
  impl_->oriented_box = objectOrientedBox(mesh);
  impl_->topology = analyzeTopology(mesh);
  impl_->seed = seedOf(mesh, role, config.seed);
  impl_->samples = sampleSurface(mesh, config.samples, impl_->seed).points;
  if (!impl_->samples.empty()) {
    impl_->sample_tree.emplace(impl_->samples);
    impl_->surface.add(mesh);
    impl_->surface.commit();
  }
  const SolidVoxelizer solid(mesh);
  for (const VoxelLattice& grid :
       jitteredGrids(config.grid, config.jittered_origins, config.seed)) {
    impl_->solid_voxels.push_back(solid.voxelize(grid));
    impl_->surface_voxels.push_back(hydrabench::surfaceVoxels(mesh, grid));
  }
}
ObjectModel::~ObjectModel() = default;
ObjectModel::ObjectModel(ObjectModel&&) noexcept = default;
ObjectModel& ObjectModel::operator=(ObjectModel&&) noexcept = default;

const Mesh& ObjectModel::mesh() const { return impl_->mesh; }
const Aabb& ObjectModel::box() const { return impl_->box; }
double ObjectModel::halfDiagonal() const {
  return impl_->box.isEmpty() ? 0 : hydrabench::halfDiagonal(impl_->box);
}
const OrientedBox& ObjectModel::orientedBox() const { return impl_->oriented_box; }
const MeshTopology& ObjectModel::topology() const { return impl_->topology; }
std::span<const Eigen::Vector3d> ObjectModel::samples() const { return impl_->samples; }

double ObjectModel::squaredDistanceToSamples(const Eigen::Vector3d& point) const {
  assert(hasSurface());
  return impl_->sample_tree->nearest(point).squared_distance;
}

double ObjectModel::distanceToSurface(const Eigen::Vector3d& point) const {
  assert(hasSurface());
  const double distance = impl_->surface.nearest(point).distance;
  return distance < kSnapToZero ? 0 : distance;
}

std::optional<double> ObjectModel::samplingFloor() const {
  if (!hasSurface()) return std::nullopt;
  std::call_once(impl_->floor_once, [&] { impl_->floor = impl_->computeFloor(); });
  return impl_->floor;
}

std::span<const std::optional<VoxelSet>> ObjectModel::solidVoxels() const {
  return impl_->solid_voxels;
}
std::span<const std::optional<VoxelSet>> ObjectModel::surfaceVoxels() const {
  return impl_->surface_voxels;
}

}  // namespace hydrabench
