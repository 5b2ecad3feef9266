// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/observed_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydrabench {
namespace {

constexpr double kMarginM = 1e-3;   ///< above the rounding of ranges in float
constexpr double kMarginPx = 1.05;  ///< a pixel that interpolation reads, and rounding

struct RangeInterval {
  float low = std::numeric_limits<float>::infinity();
  float high = 0;
};

/// Ranges that interpolation at the pixels of one object can give, per square tile of the image.
class ObjectTiles {
 public:
  ObjectTiles(const ImageRegion& region, int side)
      : region_(region),
        side_(side),
        tiles_((region.u_end - region.u_begin + side - 1) / side,
               (region.v_end - region.v_begin + side - 1) / side) {}

  void fill(const Image<float>& range, const Image<std::uint16_t>& ids, std::uint16_t id,
            float max_difference) {
    for (int v = region_.v_begin; v < region_.v_end; ++v) {
      for (int u = region_.u_begin; u < region_.u_end; ++u) {
        const float own = range(u, v);
        if (ids(u, v) != id || !(own > 0)) continue;
        RangeInterval& tile = tiles_((u - region_.u_begin) / side_, (v - region_.v_begin) / side_);
        for (int j = std::max(v - 1, 0); j <= std::min(v + 1, range.height() - 1); ++j) {
          for (int i = std::max(u - 1, 0); i <= std::min(u + 1, range.width() - 1); ++i) {
            const float other = range(i, j);
            if (!(other > 0)) continue;
            tile.low = std::min(tile.low, std::max(other, own - max_difference));
            tile.high = std::max(tile.high, std::min(other, own + max_difference));
          }
        }
      }
    }
  }

  /// Whether a tile that touches the given pixels has a range between near and far.
  bool meets(const Eigen::Array2d& low_px, const Eigen::Array2d& high_px, double near,
             double far) const {
    const int i0 = tileOf(low_px.x() - region_.u_begin, tiles_.width());
    const int i1 = tileOf(high_px.x() - region_.u_begin, tiles_.width());
    const int j0 = tileOf(low_px.y() - region_.v_begin, tiles_.height());
    const int j1 = tileOf(high_px.y() - region_.v_begin, tiles_.height());
    for (int j = std::max(j0, 0); j <= std::min(j1, tiles_.height() - 1); ++j) {
      for (int i = std::max(i0, 0); i <= std::min(i1, tiles_.width() - 1); ++i) {
        if (tiles_(i, j).low <= far && tiles_(i, j).high >= near) return true;
      }
    }
    return false;
  }

 private:
  /// -1 before the first tile, `count` behind the last.
  int tileOf(double offset_px, int count) const {
    return static_cast<int>(
        std::clamp(std::floor(offset_px / side_), -1.0, static_cast<double>(count)));
  }

  ImageRegion region_;
  int side_;
  Image<RangeInterval> tiles_;
};

}  // namespace

ObservedBlocks::ObservedBlocks(const VoxelGrid& grid, const Aabb& volume, double truncation_m,
                               double max_range_difference_m)
    : grid_(grid),
      truncation_m_(truncation_m),
      max_difference_m_(static_cast<float>(max_range_difference_m)),
      low_(grid.blockAt(volume.min())),
      size_(grid.blockAt(volume.max()) - low_ + BlockIndex::Ones()),
      observed_(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                    static_cast<std::size_t>(size_.z()),
                0) {}

std::size_t ObservedBlocks::numberOf(const BlockIndex& block) const {
  const BlockIndex at = block - low_;
  return (static_cast<std::size_t>(at.x()) * static_cast<std::size_t>(size_.y()) +
          static_cast<std::size_t>(at.y())) *
             static_cast<std::size_t>(size_.z()) +
         static_cast<std::size_t>(at.z());
}

void ObservedBlocks::add(const SensorView& view, const Image<std::uint16_t>& ids, std::uint16_t id,
                         const ImageRegion& region) {
  const Eigen::Vector3d sensor = view.T_world_sensor.translation();
  const Transform T_sensor_world = view.T_world_sensor.inverse();
  // Around the centres of a block's voxels.
  const double half_m = 0.5 * (grid_.side - 1) * grid_.voxel_size;
  const double radius_m = std::sqrt(3.0) * half_m;

  // A block covers some ten tiles in the middle of the volume.
  const Eigen::Vector3d middle =
      (low_.cast<double>() + 0.5 * size_.cast<double>()) * grid_.blockSize();
  const double block_px =
      view.camera.fx * grid_.blockSize() / std::max((middle - sensor).norm(), 0.1);
  ObjectTiles tiles(region, static_cast<int>(std::clamp(block_px / 3, 2.0, 64.0)));
  tiles.fill(view.range, ids, id, max_difference_m_);

  for (int x = 0; x < size_.x(); ++x) {
    for (int y = 0; y < size_.y(); ++y) {
      for (int z = 0; z < size_.z(); ++z) {
        const BlockIndex block = low_ + BlockIndex(x, y, z);
        char& observed = observed_[numberOf(block)];
        if (observed) continue;
        const Eigen::Vector3d center = grid_.centerOfBlock(block);
        // The image of the sphere around the block lies in the square around that of its middle.
        const Eigen::Vector3d p = T_sensor_world * center;
        const double z_near = p.z() - radius_m;
        if (p.z() + radius_m < 0) continue;
        if (z_near < 0.05) {
          observed = 1;  // around the camera: no need to be exact
          continue;
        }
        const Eigen::Array2d ray(p.x() / p.z(), p.y() / p.z());
        const Eigen::Array2d spread = radius_m / z_near * (1 + ray.abs());
        const Eigen::Array2d focal(view.camera.fx, view.camera.fy);
        const Eigen::Array2d principal(view.camera.cx, view.camera.cy);
        const Eigen::Array2d low_px = (ray - spread) * focal + principal - kMarginPx;
        const Eigen::Array2d high_px = (ray + spread) * focal + principal + kMarginPx;
        const Eigen::Array3d offset = (center - sensor).array().abs();
        const double nearest = (offset - half_m).max(0.0).matrix().norm();
        const double farthest = (offset + half_m).matrix().norm();
        const double reach_m = truncation_m_ + kMarginM;
        observed = tiles.meets(low_px, high_px, nearest - reach_m, farthest + reach_m);
      }
    }
  }
}

std::vector<BlockIndex> ObservedBlocks::blocks() const {
  std::vector<BlockIndex> blocks;
  for (int x = 0; x < size_.x(); ++x) {
    for (int y = 0; y < size_.y(); ++y) {
      for (int z = 0; z < size_.z(); ++z) {
        const BlockIndex block = low_ + BlockIndex(x, y, z);
        if (observed_[numberOf(block)]) blocks.push_back(block);
      }
    }
  }
  return blocks;
}

bool ObservedBlocks::inVolume(const BlockIndex& block) const {
  const BlockIndex at = block - low_;
  return at.minCoeff() >= 0 && (size_ - at).minCoeff() > 0;
}

}  // namespace hydrabench
