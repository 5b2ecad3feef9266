// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/tsdf_integrator.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mapping/lidar_projection.h"
#include "core/mapping/pinhole_projection.h"
#include "core/mapping/range_sample.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

Interpolation interpolationNamed(const std::string& name) {
  assert(name == "nearest" || name == "bilinear" || name == "adaptive");
  if (name == "nearest") return Interpolation::kNearest;
  return name == "bilinear" ? Interpolation::kBilinear : Interpolation::kAdaptive;
}

/// What a frame can say about the voxels of a block, found without looking at them.
enum class Coverage {
  kNothing,  ///< no voxel is measured
  kFree,     ///< every voxel is measured, and lies in front of the band around the surface
  kMixed     ///< voxel by voxel
};

/// Answers whether a rectangle of pixels sees ground (a summed-area table).
class GroundTable {
 public:
  GroundTable() = default;
  explicit GroundTable(const Image<std::uint8_t>& ground)
      : stride_(static_cast<std::size_t>(ground.width()) + 1),
        sums_(stride_ * (static_cast<std::size_t>(ground.height()) + 1), 0) {
    const std::uint8_t* pixel = ground.data();
    for (std::size_t v = 1; v * stride_ < sums_.size(); ++v) {
      std::uint32_t of_row = 0;
      for (std::size_t u = 1; u < stride_; ++u) {
        of_row += *pixel++ != 0;
        sums_[v * stride_ + u] = sums_[(v - 1) * stride_ + u] + of_row;
      }
    }
  }

  bool any(const PixelRect& pixels) const {
    const auto sum = [&](int u, int v) {
      return sums_[static_cast<std::size_t>(v) * stride_ + static_cast<std::size_t>(u)];
    };
    return sum(pixels.u1 + 1, pixels.v1 + 1) + sum(pixels.u0, pixels.v0) !=
           sum(pixels.u0, pixels.v1 + 1) + sum(pixels.u1 + 1, pixels.v0);
  }

 private:
  std::size_t stride_ = 1;
  std::vector<std::uint32_t> sums_;
};

/// One frame about to be fused into one volume.
template <typename Projection>
class FrameUpdate {
 public:
  FrameUpdate(const TsdfIntegrator::Config& config, const SensorView& view,
              const Projection& projection, const TsdfVolume& volume)
      : view_(view),
        grid_(volume.grid()),
        projection_(projection),
        sampler_(view.range, interpolationNamed(config.interpolation),
                 static_cast<float>(config.max_range_difference_m)),
        T_sensor_world_(view.T_world_sensor.inverse()),
        limit_m_(std::min(view.max_range_m, static_cast<double>(view.max_measured_m))),
        min_range_squared_(static_cast<float>(view.min_range_m * view.min_range_m)),
        limit_squared_(static_cast<float>(limit_m_ * limit_m_)),
        truncation_(static_cast<float>(volume.config().truncation_m)),
        rays_(static_cast<float>(grid_.voxel_size * grid_.voxel_size) * projection_.focalArea()),
        constant_weight_(config.constant_weight),
        min_weight_(static_cast<float>(config.min_weight)),
        max_weight_(static_cast<float>(config.max_weight)),
        ground_weight_(static_cast<float>(config.ground_band.weight)),
        between_rows_(view.lidar && view.ground && config.ground_band.extra_m > 0 &&
                      config.ground_band.between_rows),
        ground_limit_(static_cast<float>(config.ground_band.max_range_m)),
        row_angle_(view.lidar ? static_cast<float>(1 / view.lidar->rowsPerRadian()) : 0),
        behind_(truncation_ +
                (view.ground ? static_cast<float>(config.ground_band.extra_m) : 0.0f)) {
    assert(view.color == nullptr || view.color->size() == view.range.size());
    assert(view.labels == nullptr || view.labels->size() == view.range.size());
    assert(view.mask == nullptr || view.mask->size() == view.range.size());
    assert(view.ground == nullptr || view.ground->size() == view.range.size());
    if (between_rows_) ground_ = GroundTable(*view.ground);
    const double start = config.dropoff_start_voxels * grid_.voxel_size;
    if (config.weight_dropoff && start < volume.config().truncation_m) {
      dropoff_start_ = static_cast<float>(-start);
      dropoff_slope_ = static_cast<float>(1 / (volume.config().truncation_m - start));
    }
  }

  bool seesAnything() const { return limit_m_ > 0; }

  /// Blocks that may hold a measured voxel, with what is known of them; in order of IndexLess.
  std::vector<std::pair<BlockIndex, Coverage>> candidates() const {
    std::vector<std::pair<BlockIndex, Coverage>> found;
    const Eigen::Vector3d sensor = view_.T_world_sensor.translation();
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(limit_m_);
    const BlockIndex low = grid_.blockAt(sensor - reach);
    const BlockIndex high = grid_.blockAt(sensor + reach);
    for (int x = low.x(); x <= high.x(); ++x) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int z = low.z(); z <= high.z(); ++z) {
          const BlockIndex index(x, y, z);
          const Coverage known = coverage(index);
          if (known != Coverage::kNothing) found.emplace_back(index, known);
        }
      }
    }
    return found;
  }

  Coverage coverage(const BlockIndex& index) const {
    // The convex hull of the voxels' centres, and its nearest and farthest point.
    const Eigen::Vector3d low = grid_.centerOf(grid_.side * index);
    const Eigen::Vector3d high = low.array() + (grid_.side - 1) * grid_.voxel_size;
    const Eigen::Vector3d sensor = view_.T_world_sensor.translation();
    const double nearest = (sensor.cwiseMax(low).cwiseMin(high) - sensor).norm();
    if (nearest > limit_m_ + kMargin) return Coverage::kNothing;
    const double farthest = (sensor - low).cwiseAbs().cwiseMax((high - sensor).cwiseAbs()).norm();
    if (farthest < view_.min_range_m - kMargin) return Coverage::kNothing;

    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] =
          T_sensor_world_ * Eigen::Vector3d((i & 1 ? high : low).x(), (i & 2 ? high : low).y(),
                                            (i & 4 ? high : low).z());
    }
    const Footprint footprint = projection_.footprint(corners);
    if (footprint.outside) return Coverage::kNothing;
    if (view_.tiles.empty()) return Coverage::kMixed;
    const PixelRect& pixels = footprint.pixels;
    const RangeTiles::Bounds seen = view_.tiles.over(pixels.u0, pixels.v0, pixels.u1, pixels.v1);
    if (nearest > seen.max + behind_ + kMargin) return Coverage::kNothing;
    const bool free = footprint.inside && seen.min > farthest + truncation_ + kMargin &&
                      nearest > view_.min_range_m + kMargin && farthest < limit_m_ - kMargin &&
                      !(between_rows_ && ground_.any(pixels));
    return free ? Coverage::kFree : Coverage::kMixed;
  }

  /// @return  whether a voxel was measured
  bool update(const BlockIndex& index, Coverage known, VoxelBlock& block) const {
    if (known == Coverage::kNothing) return false;
    bool changed = known == Coverage::kFree;
    forEachVoxel(index, [&](const Eigen::Vector3f& p, std::size_t voxel) {
      if (known == Coverage::kFree) {
        fuse(truncation_, weight(p, truncation_), block.voxels[voxel]);
      } else if (updateVoxel(p, voxel, block)) {
        changed = true;
      }
    });
    if (changed) {
      block.last_updated_ns = view_.stamp_ns;
      block.mesh_outdated = true;
    }
    return changed;
  }

 private:
  /// [m] above the rounding of positions and ranges in float, below any voxel.
  static constexpr double kMargin = 1e-4;

  /// Calls visit(centre in the sensor frame, local index). A centre depends on block and voxel
  /// only: double up to the start of each row, then steps from there.
  template <typename Visit>
  void forEachVoxel(const BlockIndex& index, const Visit& visit) const {
    const Eigen::Vector3d origin = T_sensor_world_ * grid_.centerOf(grid_.side * index);
    const Eigen::Matrix3d steps = T_sensor_world_.linear() * grid_.voxel_size;
    const Eigen::Vector3f step = steps.col(0).template cast<float>();
    std::size_t voxel = 0;
    for (int z = 0; z < grid_.side; ++z) {
      for (int y = 0; y < grid_.side; ++y) {
        const Eigen::Vector3f row =
            (origin + steps.col(1) * y + steps.col(2) * z).template cast<float>();
        for (int x = 0; x < grid_.side; ++x) visit(row + step * static_cast<float>(x), voxel++);
      }
    }
  }

  bool updateVoxel(const Eigen::Vector3f& p, std::size_t voxel, VoxelBlock& block) const {
    const float squared = p.squaredNorm();
    if (squared < min_range_squared_ || squared > limit_squared_) return false;
    float u = 0;
    float v = 0;
    RangeSample sample;
    if (!projection_.project(p, u, v)) return false;
    RangeSampler::GroundPlane plane;
    const float range = std::sqrt(squared);
    const bool has_plane =
        between_rows_ && sampler_.betweenRows(u, v, *view_.ground, view_.row_offset, row_angle_,
                                              static_cast<float>(grid_.voxel_size), sample, plane);
    const float above = has_plane ? (sample.range - range) * plane.height / sample.range : 0;
    const bool near_plane = has_plane && above < truncation_;
    if (near_plane && range > ground_limit_) return false;
    const bool between = near_plane && plane.on_ground;
    if (!between && !sampler_.sample(u, v, sample)) return false;
    const float along_ray = sample.range - range;
    const float distance = between ? above : along_ray;
    if (!(along_ray >= -truncation_)) {
      if (has_plane && !near_plane) return false;  // free: all as without the band
      const float behind = between ? plane.farthest - range : along_ray;
      return updateBehindGround(behind, between ? distance : -truncation_, sample,
                                block.voxels[voxel]);
    }
    // In front of what the nearer row met, but below the ground that the other one met.
    if (near_plane && !between && above < 0 && along_ray > 0) return false;
    const float sdf = std::min(distance, truncation_);
    const float w = weight(p, sdf);
    TsdfVoxel& tsdf = block.voxels[voxel];
    if (std::abs(sdf) < truncation_) {
      if (view_.mask != nullptr && chooseId(*view_.mask, sample) != 0) return false;
      if (view_.color != nullptr && hasColor(sample)) {
        fuseColor(blendColor(*view_.color, sample), w, tsdf);
      }
      if (view_.labels != nullptr && block.semantics)
        block.semantics->fuse(voxel, chooseId(*view_.labels, sample), w);
    }
    fuse(sdf, w, tsdf);
    return true;
  }

  /// The ground band: a voxel farther behind the surface than the truncation distance.
  /// @param behind  along the ray, the farthest ground that the measurement speaks of [m]
  /// @param sdf     what is known of the distance to the ground [m]
  bool updateBehindGround(float behind, float sdf, const RangeSample& sample,
                          TsdfVoxel& voxel) const {
    if (!(behind >= -behind_) || view_.ground == nullptr) return false;
    if (chooseId(*view_.ground, sample) == 0) return false;
    if (view_.mask != nullptr && chooseId(*view_.mask, sample) != 0) return false;
    if (voxel.weight > 0 && !voxel.assumed) return false;
    average(std::max(sdf, -truncation_), ground_weight_, voxel);
    voxel.assumed = true;
    return true;
  }

  /// Rays that meet the voxel over their variance, which grows with the square of depth; less and
  /// less behind the surface (Hydra, ProjectiveIntegrator).
  float weight(const Eigen::Vector3f& p, float sdf) const {
    const float inverse = projection_.inverseDepth(p);
    const float squared = inverse * inverse;
    float w = rays_ * squared;
    if (!constant_weight_) w *= squared;
    if (sdf < dropoff_start_) w *= (truncation_ + sdf) * dropoff_slope_;
    return std::max(w, min_weight_);
  }

  void fuse(float sdf, float w, TsdfVoxel& voxel) const {
    if (voxel.assumed) {
      voxel.weight = 0;
      voxel.assumed = false;
    }
    average(sdf, w, voxel);
  }

  void average(float sdf, float w, TsdfVoxel& voxel) const {
    const float total = voxel.weight + w;
    voxel.distance = (voxel.distance * voxel.weight + sdf * w) / total;
    voxel.weight = std::min(total, max_weight_);
  }

  bool hasColor(const RangeSample& sample) const {
    if (view_.uncolored == nullptr) return true;
    for (int i = 0; i < sample.count; ++i) {
      if (view_.uncolored->data()[sample.pixels[static_cast<std::size_t>(i)]] != 0) return false;
    }
    return true;
  }

  /// Before the weight is raised: the share of the new measurement is w / (W + w). (Hydra takes
  /// w / (W + 2 w) and blends the first colour with black.)
  void fuseColor(const std::array<float, 3>& color, float w, TsdfVoxel& voxel) const {
    const float share = voxel.colored ? w / (voxel.weight + w) : 1.0f;
    const auto mixed = [share](std::uint8_t old, float measured) {
      const float before = static_cast<float>(old);
      return static_cast<std::uint8_t>(before + (measured - before) * share + 0.5f);
    };
    voxel.color = {mixed(voxel.color.r, color[0]), mixed(voxel.color.g, color[1]),
                   mixed(voxel.color.b, color[2])};
    voxel.colored = true;
  }

  const SensorView& view_;
  const VoxelGrid grid_;
  const Projection projection_;
  const RangeSampler sampler_;
  const Transform T_sensor_world_;
  const double limit_m_;  ///< behind it no voxel is measured
  const float min_range_squared_;
  const float limit_squared_;
  const float truncation_;
  const float rays_;  ///< that meet a voxel at a depth of 1 m
  const bool constant_weight_;
  const float min_weight_;
  const float max_weight_;
  const float ground_weight_;
  const bool between_rows_;
  const float ground_limit_;
  const float row_angle_;  ///< of a lidar [rad]
  const float behind_;     ///< how far behind the surface anything may be written [m]
  /// Above it distances are those to the plane between rows, truncated or not.
  GroundTable ground_;
  float dropoff_start_ = -std::numeric_limits<float>::infinity();
  float dropoff_slope_ = 0;
};

/// Calls body(FrameUpdate) with the projection of the view's sensor.
template <typename Body>
auto withFrameUpdate(const TsdfIntegrator::Config& config, const SensorView& view,
                     const TsdfVolume& volume, const Body& body) {
  if (view.lidar) {
    assert(view.range.width() == view.lidar->columns + 1 &&
           view.range.height() == view.lidar->rows);
    return body(FrameUpdate(config, view, LidarProjection(*view.lidar), volume));
  }
  assert(view.range.width() == view.camera.width && view.range.height() == view.camera.height);
  return body(FrameUpdate(config, view, PinholeProjection(view.camera), volume));
}

template <typename Projection>
std::vector<BlockIndex> integrateFrame(const FrameUpdate<Projection>& frame, TsdfVolume& volume) {
  struct Task {
    BlockIndex index;
    Coverage known;
    VoxelBlock* block;
    bool is_new;
  };
  if (!frame.seesAnything()) return {};
  std::vector<Task> tasks;
  for (const auto& [index, known] : frame.candidates()) {
    VoxelBlock* block = volume.find(index);
    const bool is_new = block == nullptr;
    tasks.push_back({index, known, is_new ? &volume.allocate(index) : block, is_new});
  }

  std::vector<char> changed(tasks.size(), 0);
  parallelFor(tasks.size(), [&](std::size_t i) {
    changed[i] = frame.update(tasks[i].index, tasks[i].known, *tasks[i].block);
  });

  std::vector<BlockIndex> changed_blocks;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (changed[i]) {
      changed_blocks.push_back(tasks[i].index);
    } else if (tasks[i].is_new) {
      volume.remove(tasks[i].index);
    }
  }
  return changed_blocks;
}

}  // namespace

std::vector<BlockIndex> TsdfIntegrator::integrate(const SensorView& view,
                                                  TsdfVolume& volume) const {
  return withFrameUpdate(config_, view, volume,
                         [&](const auto& frame) { return integrateFrame(frame, volume); });
}

void TsdfIntegrator::integrateBlocks(const SensorView& view, std::span<const BlockIndex> blocks,
                                     TsdfVolume& volume) const {
  withFrameUpdate(config_, view, volume, [&](const auto& frame) {
    if (!frame.seesAnything()) return;
    constexpr std::size_t kGrain = 8;  // blocks may be small
    parallelFor(
        blocks.size(),
        [&](std::size_t i) {
          VoxelBlock* block = volume.find(blocks[i]);
          assert(block != nullptr);
          // Without tiles every voxel is looked at: the reference for what is decided early.
          const bool decide = !view.tiles.empty();
          frame.update(blocks[i], decide ? frame.coverage(blocks[i]) : Coverage::kMixed, *block);
        },
        kGrain);
  });
}

void read(ConfigReader& reader, TsdfIntegrator::Config& config) {
  reader.choice("interpolation", config.interpolation, {"nearest", "bilinear", "adaptive"});
  reader.field("max_range_difference_m", config.max_range_difference_m, {0, 100});
  reader.field("constant_weight", config.constant_weight);
  reader.field("weight_dropoff", config.weight_dropoff);
  reader.field("dropoff_start_voxels", config.dropoff_start_voxels, {0, 100});
  reader.field("min_weight", config.min_weight, {1e-12, 1e6});
  reader.field("max_weight", config.max_weight, {1e-6, 1e12});
  auto ground_band = reader.section("ground_band");
  ground_band.field("extra_m", config.ground_band.extra_m, {0, 100});
  ground_band.field("max_range_m", config.ground_band.max_range_m, {0.1, 1000});
  ground_band.field("weight", config.ground_band.weight, {1e-12, 1e6});
  ground_band.field("between_rows", config.ground_band.between_rows);
}

}  // namespace hydrabench
