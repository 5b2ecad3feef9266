// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/lighting.h"

#include <algorithm>
#include <cmath>

namespace hydrabench {
namespace {

constexpr float kCell_m = 0.5f;
constexpr float kInset_m = 0.12f;       // a point on a wall belongs to the room its face looks into
constexpr float kLampSize_m2 = 0.35f;   // keeps the light finite under a lamp that is no point
constexpr float kSunDistance_m = 1000;  // of the point that shadow rays go to; beyond any world
constexpr float kLesserLamps = 0.55f;   // their shadows are not traced, so they count for less

}  // namespace

Lighting::Lighting(const Scene& scene) : sun_(scene.sun) {
  if (sun_) return;
  for (const Lamp& lamp : scene.lamps) {
    lamps_.push_back({lamp.position.cast<float>(), static_cast<float>(lamp.intensity)});
  }
  const Aabb box = bounds(scene);
  if (box.isEmpty()) {
    cells_.push_back({});
    cells_.back().lamps.fill(-1);
    return;
  }
  origin_ = box.min().head<2>().cast<float>();
  const Eigen::Vector3d size = box.sizes();
  columns_ = static_cast<int>(size.x() / kCell_m) + 1;
  rows_ = static_cast<int>(size.y() / kCell_m) + 1;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d center(origin_.x() + (static_cast<float>(column) + 0.5f) * kCell_m,
                                   origin_.y() + (static_cast<float>(row) + 0.5f) * kCell_m);
      // The nearest room, so that cells cut by a wall still find one.
      int room = -1;
      double nearest = 1e300;
      for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
        const Aabb& area = scene.rooms[i].box;
        const double distance =
            (center - center.cwiseMax(area.min().head<2>()).cwiseMin(area.max().head<2>()))
                .squaredNorm();
        if (distance < nearest) {
          nearest = distance;
          room = static_cast<int>(i);
        }
      }
      std::vector<std::pair<double, std::int16_t>> order;
      for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
        const Lamp& lamp = scene.lamps[i];
        if (lamp.room >= 0 && lamp.room != room) continue;
        order.emplace_back((lamp.position.head<2>() - center).squaredNorm(),
                           static_cast<std::int16_t>(i));
      }
      std::sort(order.begin(), order.end());
      CellLamps cell;
      cell.lamps.fill(-1);
      for (std::size_t i = 0; i < std::min<std::size_t>(kPerCell, order.size()); ++i) {
        cell.lamps[i] = order[i].second;
      }
      cells_.push_back(cell);
    }
  }
}

Lighting::Sample Lighting::daylightAt(const Eigen::Vector3f& point,
                                      const Eigen::Vector3f& normal) const {
  const Eigen::Vector3f to_sun = sun_->to_sun.cast<float>();
  Sample sample;
  // A wall sees half of the sky; what faces down sees the lit ground only.
  sample.ambient = static_cast<float>(sun_->sky) * (0.65f + 0.35f * normal.z());
  sample.key = static_cast<float>(sun_->intensity) * std::max(0.0f, normal.dot(to_sun));
  sample.key_position = point + kSunDistance_m * to_sun;
  return sample;
}

Lighting::Sample Lighting::at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
  if (sun_) return daylightAt(point, normal);
  const Eigen::Vector2f place = (point + kInset_m * normal).head<2>() - origin_;
  const int column = std::clamp(static_cast<int>(place.x() / kCell_m), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(place.y() / kCell_m), 0, rows_ - 1);
  Sample sample;
  float sum = 0;
  for (const std::int16_t index :
       cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(column)]
           .lamps) {
    if (index < 0) break;
    const Source& lamp = lamps_[static_cast<std::size_t>(index)];
    const Eigen::Vector3f to_lamp = lamp.position - point;
    const float facing = normal.dot(to_lamp);
    if (facing <= 0) continue;
    const float squared = to_lamp.squaredNorm();
    const float distance = std::sqrt(squared);
    // The panels look down: the light falls off towards the side.
    const float downwards = std::max(0.25f, to_lamp.z() / distance);
    const float light = lamp.intensity * downwards * facing / (distance * (squared + kLampSize_m2));
    sum += light;
    if (light > sample.key) {
      sample.key = light;
      sample.key_position = lamp.position;
    }
  }
  sample.ambient = 0.40f + 0.12f * normal.z() + kLesserLamps * (sum - sample.key);
  return sample;
}

}  // namespace hydrabench
