// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

enum class Interpolation { kNearest, kBilinear, kAdaptive };

/// The pixels that speak for a place between pixels, with weights that add up to 1.
struct RangeSample {
  float range = 0;  ///< [m]
  int count = 0;    ///< 1, 2 or 4
  std::array<std::size_t, 4> pixels;
  std::array<float, 4> weights;
};

/// Reads ranges between pixels. Places up to half a pixel outside the outermost centres count as on
/// them.
class RangeSampler {
 public:
  RangeSampler(const Image<float>& range, Interpolation interpolation, float max_difference)
      : range_(range.data()),
        width_(range.width()),
        u_max_(range.width() - 1),
        v_max_(range.height() - 1),
        interpolation_(interpolation),
        max_difference_(max_difference) {}

  /// False where a pixel that would count measured nothing.
  bool sample(float u, float v, RangeSample& sample) const {
    if (interpolation_ == Interpolation::kNearest) return nearest(u, v, sample);
    const float u_on = std::clamp(u, 0.0f, static_cast<float>(u_max_));
    const float v_on = std::clamp(v, 0.0f, static_cast<float>(v_max_));
    const int u0 = std::max(std::min(static_cast<int>(u_on), u_max_ - 1), 0);
    const int v0 = std::max(std::min(static_cast<int>(v_on), v_max_ - 1), 0);
    const std::size_t corner = index(u0, v0);
    const std::size_t right = u_max_ > 0 ? 1 : 0;
    const std::size_t below = v_max_ > 0 ? static_cast<std::size_t>(width_) : 0;
    const float r00 = range_[corner];
    const float r10 = range_[corner + right];
    const float r01 = range_[corner + below];
    const float r11 = range_[corner + right + below];
    const float low = std::min(std::min(r00, r10), std::min(r01, r11));
    const float high = std::max(std::max(r00, r10), std::max(r01, r11));
    if (interpolation_ == Interpolation::kAdaptive && (low == 0.0f || high - low > max_difference_))
      return nearest(u, v, sample);
    if (low == 0.0f) return false;
    const float du = u_on - static_cast<float>(u0);
    const float dv = v_on - static_cast<float>(v0);
    sample.count = 4;
    sample.pixels = {corner, corner + right, corner + below, corner + right + below};
    sample.weights = {(1 - du) * (1 - dv), du * (1 - dv), (1 - du) * dv, du * dv};
    sample.range = sample.weights[0] * r00 + sample.weights[1] * r10 + sample.weights[2] * r01 +
                   sample.weights[3] * r11;
    return true;
  }

  /// The plane through where two rows met the ground, or one of them what stands on it. Along a ray
  /// between them it is nearer by height / sample.range for every metre of way.
  struct GroundPlane {
    float height = 0;        ///< of the sensor above it [m]
    float farthest = 0;      ///< the larger range of the two rows [m]
    float gap = 0;           ///< between the ranges of the two rows [m]
    bool on_ground = false;  ///< both places are; else one of them
  };
  /// On the ground between two rows, as if it were a plane there: 1/range is a straight line in the
  /// angle. False unless both rows next to v measured something in the column next to u, at least
  /// one of them ground, farther apart than min_gap. Up to kMostLost rows without a return are
  /// passed over on either side.
  /// @param ground     pixels other than 0 see ground
  /// @param offset     see SensorView::row_offset; null: no ray is off
  /// @param row_angle  between two rows [rad]
  bool betweenRows(float u, float v, const Image<std::uint8_t>& ground, const Image<float>* offset,
                   float row_angle, float min_gap, RangeSample& sample, GroundPlane& plane) const {
    if (v < 0.0f || v >= static_cast<float>(v_max_)) return false;
    const int u0 = std::min(static_cast<int>(u + 0.5f), u_max_);
    const auto rayOf = [&](int row) {
      return static_cast<float>(row) + (offset ? offset->data()[index(u0, row)] : 0.0f);
    };
    int v0 = static_cast<int>(v);
    if (v < rayOf(v0)) {
      --v0;
    } else if (v > rayOf(v0 + 1)) {
      ++v0;
    }
    int v1 = v0 + 1;
    const auto isLost = [&](int row) {
      return row >= 0 && row <= v_max_ && range_[index(u0, row)] == 0.0f;
    };
    for (int lost = 0; lost < kMostLost && isLost(v0); ++lost) --v0;
    for (int lost = 0; lost < kMostLost && isLost(v1); ++lost) ++v1;
    if (v0 < 0 || v1 > v_max_) return false;
    const std::size_t upper = index(u0, v0);
    const std::size_t lower = index(u0, v1);
    const float upper_range = range_[upper];
    const float lower_range = range_[lower];
    if (upper_range == 0.0f || lower_range == 0.0f) return false;
    const int num_ground = (ground.data()[upper] != 0) + (ground.data()[lower] != 0);
    if (num_ground == 0) return false;
    plane.on_ground = num_ground == 2;
    plane.gap = std::abs(upper_range - lower_range);
    if (plane.gap < min_gap) return false;
    const float first = rayOf(v0);
    const float rows = rayOf(v1) - first;
    if (v < first || v > first + rows || rows < kLeastRows) return false;
    const float dv = (v - first) / rows;
    sample.count = 2;
    sample.pixels[0] = upper;
    sample.pixels[1] = lower;
    sample.weights[0] = 1 - dv;
    sample.weights[1] = dv;
    sample.range = 1 / ((1 - dv) / upper_range + dv / lower_range);
    plane.farthest = std::max(upper_range, lower_range);
    // Twice the area of the triangle of the sensor and both places, over its base on the ground.
    const float angle = rows * row_angle;
    const float product = upper_range * lower_range * angle;
    const float base = std::sqrt(plane.gap * plane.gap + product * angle);
    plane.height = product / base;
    return true;
  }

 private:
  static constexpr float kLeastRows = 0.1f;  ///< nearer rays tell no plane
  static constexpr int kMostLost = 3;        ///< rows without a return, as grazing ones often are

  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(u);
  }
  bool nearest(float u, float v, RangeSample& sample) const {
    const int u0 = std::min(static_cast<int>(u + 0.5f), u_max_);
    const int v0 = std::min(static_cast<int>(v + 0.5f), v_max_);
    sample.count = 1;
    sample.pixels[0] = index(u0, v0);
    sample.weights[0] = 1;
    sample.range = range_[sample.pixels[0]];
    return sample.range > 0.0f;
  }

  const float* range_;
  int width_;
  int u_max_, v_max_;
  Interpolation interpolation_;
  float max_difference_;
};

/// The id with the highest sum of weights, the first of equals: ids are never blended.
template <typename Id>
Id chooseId(const Image<Id>& image, const RangeSample& sample) {
  const Id* ids = image.data();
  Id best = ids[sample.pixels[0]];
  float best_weight = -1;
  for (int i = 0; i < sample.count; ++i) {
    const Id id = ids[sample.pixels[static_cast<std::size_t>(i)]];
    float weight = 0;
    for (int j = 0; j < sample.count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      if (ids[sample.pixels[k]] == id) weight += sample.weights[k];
    }
    if (weight > best_weight) {
      best = id;
      best_weight = weight;
    }
  }
  return best;
}

/// Weighted mean of the colours: red, green, blue from 0 to 255.
inline std::array<float, 3> blendColor(const Image<Rgb>& image, const RangeSample& sample) {
  std::array<float, 3> sum{};
  for (int i = 0; i < sample.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Rgb& c = image.data()[sample.pixels[k]];
    sum[0] += sample.weights[k] * static_cast<float>(c.r);
    sum[1] += sample.weights[k] * static_cast<float>(c.g);
    sum[2] += sample.weights[k] * static_cast<float>(c.b);
  }
  return sum;
}

}  // namespace hydrabench
