// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/view_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydrabench {
namespace {

constexpr double kCell = 2 * kGridHalfSide / kCellSide;
/// Measured surfaces are no sharper than this: the ray is free up to so far before them.
constexpr double kMargin = 0.12;
constexpr float kFarthest = 6;  // units of the frame: what lies farther says only that it is far

using Cell = Eigen::Vector3i;

bool cellOf(const Eigen::Vector3d& p, Cell& cell) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::floor((p[axis] + kGridHalfSide) / kCell);
    if (!(at >= 0 && at < kCellSide)) return false;
    cell[axis] = static_cast<int>(at);
  }
  return true;
}

/// Where the features of a cell begin: blocks and the cells of a block with x fastest.
std::size_t offsetOf(const Cell& cell) {
  const Cell block = cell / kCellsPerBlock;
  const Cell inner = cell - block * kCellsPerBlock;
  const int b = (block.z() * kBlockSide + block.y()) * kBlockSide + block.x();
  const int i = (inner.z() * kCellsPerBlock + inner.y()) * kCellsPerBlock + inner.x();
  return static_cast<std::size_t>((b * ViewGrid::kCellsOfBlock + i) * ViewGrid::kCellFeatures);
}

/// Marks the cells that the ray from the camera to a point passes.
void markFree(const Eigen::Vector3d& camera, const Eigen::Vector3d& point, ViewGrid& grid) {
  const Eigen::Vector3d along = point - camera;
  const double length = along.norm();
  double from = 0;
  double to = length - kMargin;
  for (int axis = 0; axis < 3; ++axis) {  // within the cube
    const double slope = along[axis] / length;
    if (std::abs(slope) < 1e-9) {
      if (std::abs(camera[axis]) > kGridHalfSide) return;
      continue;
    }
    const double a = (-kGridHalfSide - camera[axis]) / slope;
    const double b = (kGridHalfSide - camera[axis]) / slope;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  Cell cell;
  for (double at = from + 0.25 * kCell; at < to; at += 0.5 * kCell) {
    if (cellOf(camera + at / length * along, cell)) grid.cells[offsetOf(cell) + 4] = 1;
  }
}

float bounded(double value) { return std::clamp(static_cast<float>(value), -kFarthest, kFarthest); }

}  // namespace

ViewGrid makeViewGrid(const ObjectPoints& points, const LocalFrame& frame) {
  ViewGrid grid;
  grid.cells.assign(static_cast<std::size_t>(kShapeTokens) * ViewGrid::kBlockFeatures, 0.0f);
  const Eigen::Vector3d camera = frame.toLocal(Eigen::Vector3d::Zero());
  double lowest = std::numeric_limits<double>::infinity();
  double sum_z = 0;
  Cell cell;
  for (const Eigen::Vector3f& point : points.context) {
    const Eigen::Vector3d p = frame.toLocal(point.cast<double>());
    lowest = std::min(lowest, p.z());
    markFree(camera, p, grid);
    if (cellOf(p, cell)) grid.cells[offsetOf(cell) + 5] = 1;
  }
  for (const Eigen::Vector3f& point : points.object) {
    const Eigen::Vector3d p = frame.toLocal(point.cast<double>());
    lowest = std::min(lowest, p.z());
    sum_z += p.z();
    markFree(camera, p, grid);
    if (!cellOf(p, cell)) continue;
    float* features = &grid.cells[offsetOf(cell)];
    features[0] += 1;
    const Eigen::Vector3d inner = (p.array() + kGridHalfSide) / kCell - cell.cast<double>().array();
    for (int axis = 0; axis < 3; ++axis) {
      features[1 + axis] += static_cast<float>(inner[axis] - 0.5);
    }
  }
  for (std::size_t i = 0; i < grid.cells.size(); i += ViewGrid::kCellFeatures) {
    float* features = &grid.cells[i];
    if (features[0] == 0) continue;
    for (int axis = 0; axis < 3; ++axis) features[1 + axis] *= 2 / features[0];
    features[0] = 0.5f * std::log1p(features[0]);
  }
  const double distance = std::max(camera.norm(), 1e-6);
  const double count = std::max<double>(1, static_cast<double>(points.object.size()));
  grid.globals = {static_cast<float>(std::log(frame.scale)),
                  static_cast<float>(camera.x() / distance),
                  static_cast<float>(camera.y() / distance),
                  static_cast<float>(camera.z() / distance),
                  static_cast<float>(std::log(distance)),
                  bounded(camera.z()),
                  bounded(lowest),
                  bounded(sum_z / count),
                  points.cut[0],
                  points.cut[1],
                  points.cut[2],
                  points.cut[3]};
  return grid;
}

}  // namespace hydrabench
