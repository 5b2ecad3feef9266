// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/motion_detector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/mapping/frame_check.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr std::size_t kMaxClusters = 255;  // ids are bytes, 0 is static
constexpr int kNoCluster = -1;

/// Where the points of a frame lie.
struct PixelVoxels {
  std::vector<GlobalVoxel> voxels;  ///< per pixel; meaningless where there is no point
  std::vector<std::uint8_t> kinds;  ///< per pixel
};
enum Kind : std::uint8_t { kNoPoint = 0, kPoint = 1, kSeed = 2 };

PixelVoxels locatePixels(const SensorView& view, const TsdfVolume& volume, double max_range_m) {
  const VoxelGrid& grid = volume.grid();
  const std::size_t width = static_cast<std::size_t>(view.range.width());
  PixelVoxels pixels{std::vector<GlobalVoxel>(view.range.size()),
                     std::vector<std::uint8_t>(view.range.size(), kNoPoint)};
  // What columns and rows share is taken out of the loop. In voxels.
  const Eigen::Matrix3d to_voxels = view.T_world_sensor.linear() / grid.voxel_size;
  const Eigen::Vector3d origin = view.T_world_sensor.translation() / grid.voxel_size;
  std::vector<double> x_of_column(width);
  for (std::size_t u = 0; u < width; ++u) {
    x_of_column[u] = view.camera.backproject(static_cast<double>(u), 0, 1.0).x();
  }
  parallelFor(static_cast<std::size_t>(view.range.height()), [&](std::size_t v) {
    const double y = view.camera.backproject(0, static_cast<double>(v), 1.0).y();
    const Eigen::Vector3d row_direction = y * to_voxels.col(1) + to_voxels.col(2);
    const float* ranges = view.range.data() + v * width;
    BlockIndex block_index = BlockIndex::Zero();
    const VoxelBlock* block = volume.find(block_index);  // neighbouring pixels mostly share one
    for (std::size_t u = 0; u < width; ++u) {
      const double range = static_cast<double>(ranges[u]);
      if (!(range > 0) || range > max_range_m) continue;
      const double x = x_of_column[u];
      const double depth = range / std::sqrt(x * x + y * y + 1);
      const Eigen::Vector3d scaled = origin + depth * (x * to_voxels.col(0) + row_direction);
      const GlobalVoxel voxel = floored(scaled);
      Eigen::Vector3i local = voxel - grid.side * block_index;
      if (local.minCoeff() < 0 || local.maxCoeff() >= grid.side) {
        block_index = grid.blockOf(voxel);
        block = volume.find(block_index);
        local = voxel - grid.side * block_index;
      }
      const bool seed =
          block && !block->freespace.empty() &&
          block->freespace[grid.localIndex(local.x(), local.y(), local.z())].ever_free;
      pixels.voxels[v * width + u] = voxel;
      pixels.kinds[v * width + u] = seed ? kSeed : kPoint;
    }
  });
  return pixels;
}

struct Node {
  GlobalVoxel voxel;
  int cluster = kNoCluster;
  bool has_points = false;
};
/// Voxels of clusters by place. Only looked up, never listed: the order of `nodes` is fixed.
struct Nodes {
  std::vector<Node> nodes;
  std::unordered_map<GlobalVoxel, std::size_t, IndexHash> index;

  std::size_t add(const GlobalVoxel& voxel) {
    const auto [entry, added] = index.try_emplace(voxel, nodes.size());
    if (added) nodes.push_back({voxel});
    return entry->second;
  }
};

template <typename Body>
void forNeighbors26(const GlobalVoxel& voxel, const Body& body) {
  for (int i = 0; i < 27; ++i) {
    if (i == 13) continue;
    body(GlobalVoxel(voxel + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
  }
}

/// Numbers 26-connected seeds; returns how many clusters there are.
int clusterSeeds(Nodes& seeds) {
  int count = 0;
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < seeds.nodes.size(); ++first) {
    if (seeds.nodes[first].cluster != kNoCluster) continue;
    seeds.nodes[first].cluster = count;
    stack.push_back(first);
    while (!stack.empty()) {
      const GlobalVoxel voxel = seeds.nodes[stack.back()].voxel;
      stack.pop_back();
      forNeighbors26(voxel, [&](const GlobalVoxel& neighbor) {
        const auto entry = seeds.index.find(neighbor);
        if (entry == seeds.index.end() || seeds.nodes[entry->second].cluster != kNoCluster) return;
        seeds.nodes[entry->second].cluster = count;
        stack.push_back(entry->second);
      });
    }
    ++count;
  }
  return count;
}

/// Adds the voxels around seeds; one that touches two clusters goes to the earlier seed's.
void growByOneVoxel(Nodes& nodes) {
  const std::size_t num_seeds = nodes.nodes.size();
  for (std::size_t i = 0; i < num_seeds; ++i) {
    const Node seed = nodes.nodes[i];
    forNeighbors26(seed.voxel, [&](const GlobalVoxel& neighbor) {
      Node& node = nodes.nodes[nodes.add(neighbor)];
      if (node.cluster == kNoCluster) node.cluster = seed.cluster;
    });
  }
}

/// Voxels of a cluster that hold points, and the box around them.
struct Extent {
  std::vector<GlobalVoxel> voxels;
  Eigen::AlignedBox3i box;
};

bool closerThan(double distance, const Extent& a, const Extent& b) {
  const auto close = [&](const auto& gap) {
    return gap.template cast<double>().squaredNorm() < distance * distance;
  };
  const Eigen::Vector3i gap =
      (a.box.min() - b.box.max()).cwiseMax(b.box.min() - a.box.max()).cwiseMax(0);
  if (!close(gap)) return false;
  for (const GlobalVoxel& p : a.voxels) {
    for (const GlobalVoxel& q : b.voxels) {
      if (close(GlobalVoxel(p - q))) return true;
    }
  }
  return false;
}

/// For every cluster the first of those it is merged with, directly or over others.
std::vector<int> mergedWith(const Nodes& nodes, int num_clusters, double min_separation_voxels) {
  std::vector<Extent> extents(static_cast<std::size_t>(num_clusters));
  for (const Node& node : nodes.nodes) {
    if (!node.has_points) continue;
    Extent& extent = extents[static_cast<std::size_t>(node.cluster)];
    extent.voxels.push_back(node.voxel);
    extent.box.extend(node.voxel);
  }
  std::vector<int> first(extents.size());
  std::iota(first.begin(), first.end(), 0);
  for (std::size_t b = 1; b < extents.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (first[a] == first[b] || !closerThan(min_separation_voxels, extents[a], extents[b])) {
        continue;
      }
      const auto [low, high] = std::minmax({first[a], first[b]});
      std::replace(first.begin(), first.end(), int{high}, int{low});
    }
  }
  return first;
}

}  // namespace

MotionDetection MotionDetector::detect(const SensorView& view, const TsdfVolume& volume) const {
  MotionDetection result;
  result.ids = Image<std::uint8_t>(view.range.width(), view.range.height());
  if (!config_.enabled) return result;
  requireInsideGrid(view.stamp_ns, view.T_world_sensor.translation(), volume.grid().voxel_size);

  const PixelVoxels pixels = locatePixels(view, volume, config_.max_range_m);
  Nodes nodes;
  Eigen::AlignedBox3i region;  // in which a point can belong to a cluster
  for (std::size_t i = 0; i < pixels.kinds.size(); ++i) {
    if (pixels.kinds[i] != kSeed) continue;
    nodes.add(pixels.voxels[i]);
    region.extend(pixels.voxels[i]);
  }
  if (nodes.nodes.empty()) return result;
  region.extend(GlobalVoxel(region.min().array() - 1));
  region.extend(GlobalVoxel(region.max().array() + 1));

  const int num_clusters = clusterSeeds(nodes);
  growByOneVoxel(nodes);
  std::vector<std::pair<std::uint32_t, int>> members;  // pixel and cluster
  for (std::size_t i = 0; i < pixels.kinds.size(); ++i) {
    if (pixels.kinds[i] == kNoPoint || !region.contains(pixels.voxels[i])) continue;
    const auto entry = nodes.index.find(pixels.voxels[i]);
    if (entry == nodes.index.end()) continue;
    Node& node = nodes.nodes[entry->second];
    node.has_points = true;
    members.emplace_back(static_cast<std::uint32_t>(i), node.cluster);
  }

  const std::vector<int> merged = mergedWith(nodes, num_clusters, config_.min_separation_voxels);
  std::vector<MotionDetection::Cluster> clusters(merged.size());
  for (const auto& [pixel, cluster] : members) {
    const int owner = merged[static_cast<std::size_t>(cluster)];
    clusters[static_cast<std::size_t>(owner)].pixels.push_back(pixel);
  }
  for (MotionDetection::Cluster& cluster : clusters) {
    const auto count = static_cast<std::int64_t>(cluster.pixels.size());
    if (count == 0 || count < config_.min_pixels || count > config_.max_pixels) continue;
    if (result.clusters.size() == kMaxClusters) break;
    const auto id = static_cast<std::uint8_t>(result.clusters.size() + 1);
    for (const std::uint32_t pixel : cluster.pixels) result.ids.data()[pixel] = id;
    result.clusters.push_back(std::move(cluster));
  }
  return result;
}

void read(ConfigReader& reader, MotionDetector::Config& config) {
  reader.field("enabled", config.enabled);
  reader.field("min_pixels", config.min_pixels, Bounds{1, 1e9});
  reader.field("max_pixels", config.max_pixels, Bounds{1, 1e9});
  reader.field("min_separation_voxels", config.min_separation_voxels, Bounds{0, 1000});
  reader.field("max_range_m", config.max_range_m, Bounds{0, 1e4});
}

}  // namespace hydrabench
