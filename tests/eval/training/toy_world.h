// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/shape/latent_flow/latent_grid.h"
#include "core/types/random.h"
#include "eval/training/training_world.h"

namespace hydrabench {

/// Distance to the surface of a box around the origin; negative inside.
inline float boxDistance(const Eigen::Vector3f& p, const Eigen::Vector3f& half) {
  const Eigen::Vector3f d = p.cwiseAbs() - half;
  return d.cwiseMax(0).norm() + std::min(d.maxCoeff(), 0.0f);
}

inline Eigen::Vector3f turnedBy(double yaw, const Eigen::Vector3f& p) {
  const auto c = static_cast<float>(std::cos(yaw));
  const auto s = static_cast<float>(std::sin(yaw));
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

/// A box as an instance of a class; the largest of its half extents has to be 1.
inline TrainingShape toyShape(const std::string& class_name, int yaw_symmetry,
                              const Eigen::Vector3f& half, Random random) {
  TrainingShape shape;
  shape.family = class_name + "_toy";
  shape.class_name = class_name;
  shape.yaw_symmetry = yaw_symmetry;
  shape.half_extent_m = 0.4f;
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3f p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(random.uniform(-1.1, 1.1));
    shape.points.push_back(p);
    shape.distances.push_back(std::min(0.5f, boxDistance(p, half)));
  }
  return shape;
}

/// A view of toyShape() from 2 to 3 m: points all over its surface and on the floor around it.
inline TrainingView toyView(std::uint32_t index, const TrainingShape& shape,
                            const Eigen::Vector3f& half, Random random) {
  TrainingView view;
  view.shape = index;
  const double bearing = random.uniform(-3, 3);
  const double distance = random.uniform(2, 3);
  const float floor = -0.8f;
  view.center = {static_cast<float>(distance * std::cos(bearing)),
                 static_cast<float>(distance * std::sin(bearing)),
                 floor + shape.half_extent_m * half.z()};
  view.yaw = static_cast<float>(random.uniform(-3, 3));
  view.clean = true;
  for (int i = 0; i < 120; ++i) {
    Eigen::Vector3f p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = static_cast<float>(random.uniform(-half[axis], half[axis]));
    }
    const int face = i % 3;
    p[face] = i % 2 ? half[face] : -half[face];
    view.points.object.push_back(view.center + turnedBy(view.yaw, shape.half_extent_m * p));
    view.on_object.push_back(1);
    view.points.context.emplace_back(view.center.x() + static_cast<float>(random.uniform(-1, 1)),
                                     view.center.y() + static_cast<float>(random.uniform(-1, 1)),
                                     floor);
  }
  return view;
}

/// The distance of toyShape() in a frame that is turned a little and off its middle.
inline ShapeGrid toyGrid(const Eigen::Vector3f& half) {
  ShapeGrid grid;
  grid.frame.center = {0.05, -0.1, 0};
  grid.frame.bearing = 0.2;
  grid.frame.scale = 1.1;
  grid.values.resize(kGridSide * kGridSide * kGridSide);
  for (int z = 0; z < kGridSide; ++z) {
    for (int y = 0; y < kGridSide; ++y) {
      for (int x = 0; x < kGridSide; ++x) {
        const Eigen::Vector3d p = grid.frame.toLevel(gridNode(x, y, z));
        grid.values[gridIndex(x, y, z)] =
            quantizedDistance(boxDistance(p.cast<float>(), half) / grid.frame.scale);
      }
    }
  }
  return grid;
}

/// One box of every class, each seen from three places: a training world that is ready at once.
inline TrainingWorld toyWorld(std::uint64_t seed, int grids = 0) {
  const std::vector<Eigen::Vector3f> halves = {
      {0.5f, 0.7f, 1}, {0.6f, 0.5f, 1}, {0.5f, 1, 0.4f}, {0.5f, 0.5f, 1}};
  const std::vector<std::pair<std::string, int>> classes = {
      {"bin", 2}, {"chair", 1}, {"couch", 1}, {"plant", 0}};
  TrainingWorld world;
  const Random random(seed);
  for (std::uint32_t i = 0; i < 4; ++i) {
    world.shapes.push_back(
        toyShape(classes[i].first, classes[i].second, halves[i], random.fork(i)));
    for (int k = 0; k < grids; ++k) world.shapes.back().grids.push_back(toyGrid(halves[i]));
    for (std::uint64_t k = 0; k < 3; ++k) {
      world.views.push_back(
          toyView(i, world.shapes.back(), halves[i], random.fork(100 + 10 * i + k)));
    }
  }
  return world;
}

/// Puts toy worlds where a training that keeps its worlds in `cache` looks for its first of either
/// split.
inline void cacheToyWorlds(const std::filesystem::path& cache, const TrainingWorldConfig& config) {
  writeTrainingWorld(cache / "train_000000.world", config, toyWorld(1, config.grid_frames));
  writeTrainingWorld(cache / "train_000001.world", config, toyWorld(2, config.grid_frames));
  writeTrainingWorld(cache / "val_000000.world", config, toyWorld(3, config.grid_frames));
}

}  // namespace hydrabench
