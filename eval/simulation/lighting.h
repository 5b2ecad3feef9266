// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "eval/simulation/scene.h"

namespace hydrabench {

/// Light of the ceiling lamps, looked up by place: for every half metre of floor the lamps of that
/// room which matter most there. Outdoors that of sun and sky, the same everywhere.
class Lighting {
 public:
  /// Light at a surface point, 1 being white on a white surface. The key lamp is the strongest; the
  /// caller asks whether anything stands between (one shadow ray).
  struct Sample {
    float ambient = 0;  ///< sky and walls, and the lesser lamps without their shadows
    float key = 0;
    Eigen::Vector3f key_position = Eigen::Vector3f::Zero();
  };
  explicit Lighting(const Scene& scene);
  Sample at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;

 private:
  static constexpr int kPerCell = 4;
  struct CellLamps {
    std::array<std::int16_t, kPerCell> lamps;
  };
  struct Source {
    Eigen::Vector3f position;
    float intensity;
  };
  Sample daylightAt(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;

  std::optional<Sun> sun_;
  std::vector<Source> lamps_;
  std::vector<CellLamps> cells_;
  Eigen::Vector2f origin_ = Eigen::Vector2f::Zero();
  int columns_ = 1;
  int rows_ = 1;
};

}  // namespace hydrabench
