// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/clearance_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr float kFar = 1e7f;
constexpr double kComfort_m = 0.6;      // farther from obstacles no place is better than another
constexpr double kTightnessCost = 6.0;  // a way right along an obstacle counts this much longer

/// Squared distances along one line (Felzenszwalb and Huttenlocher, "Distance transforms of sampled
/// functions", 2012).
void transformLine(std::vector<float>& f, std::vector<int>& hull, std::vector<float>& border) {
  const int n = static_cast<int>(f.size());
  const std::vector<float> input = f;
  const auto value = [&](int i) { return input[static_cast<std::size_t>(i)]; };
  int k = 0;
  hull[0] = 0;
  border[0] = -kFar;
  border[1] = kFar;
  for (int q = 1; q < n; ++q) {
    const auto crossing = [&](int p) {
      return ((value(q) + static_cast<float>(q * q)) - (value(p) + static_cast<float>(p * p))) /
             static_cast<float>(2 * (q - p));
    };
    float s = crossing(hull[static_cast<std::size_t>(k)]);
    while (k > 0 && s <= border[static_cast<std::size_t>(k)]) {
      --k;
      s = crossing(hull[static_cast<std::size_t>(k)]);
    }
    ++k;
    hull[static_cast<std::size_t>(k)] = q;
    border[static_cast<std::size_t>(k)] = s;
    border[static_cast<std::size_t>(k) + 1] = kFar;
  }
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (border[static_cast<std::size_t>(k) + 1] < static_cast<float>(q)) ++k;
    const int p = hull[static_cast<std::size_t>(k)];
    f[static_cast<std::size_t>(q)] = static_cast<float>((q - p) * (q - p)) + value(p);
  }
}

}  // namespace

ClearanceMap::ClearanceMap(const Scene& scene, double z_low, double z_high) {
  const Aabb box = bounds(scene);
  origin_ = box.min().head<2>();
  columns_ = static_cast<int>(std::ceil(box.sizes().x() / kCell_m)) + 1;
  rows_ = static_cast<int>(std::ceil(box.sizes().y() / kCell_m)) + 1;
  distance_m_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kFar);

  const auto markMesh = [&](const Mesh& mesh, const Transform& T_world_mesh) {
    const auto vertex = [&](int i) -> Eigen::Vector3d {
      return T_world_mesh * mesh.vertices[static_cast<std::size_t>(i)];
    };
    for (const Eigen::Vector3i& face : mesh.faces) {
      markTriangle(vertex(face[0]), vertex(face[1]), vertex(face[2]), z_low, z_high);
    }
  };
  for (const SceneObject& object : scene.objects)
    markMesh(object.surface->mesh, object.T_world_object);
  for (const StructurePart& part : scene.structure)
    markMesh(part.surface.mesh, Transform::Identity());
  markOutside(scene);

  // Exact distances between cell centres: all columns, then all rows.
  const auto pass = [&](int lines, int length, int line_stride, int step) {
    parallelFor(static_cast<std::size_t>(lines), [&](std::size_t line) {
      std::vector<float> f(static_cast<std::size_t>(length));
      std::vector<int> hull(f.size() + 1);
      std::vector<float> border(f.size() + 2);
      const std::size_t first = line * static_cast<std::size_t>(line_stride);
      for (std::size_t i = 0; i < f.size(); ++i) {
        f[i] = distance_m_[first + i * static_cast<std::size_t>(step)];
      }
      transformLine(f, hull, border);
      for (std::size_t i = 0; i < f.size(); ++i) {
        distance_m_[first + i * static_cast<std::size_t>(step)] = f[i];
      }
    });
  };
  pass(columns_, rows_, 1, columns_);
  pass(rows_, columns_, columns_, 1);
  for (float& d : distance_m_) d = static_cast<float>(kCell_m) * std::sqrt(d);
}

void ClearanceMap::markTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, double z_low, double z_high) {
  const double top = std::max({a.z(), b.z(), c.z()});
  const double bottom = std::min({a.z(), b.z(), c.z()});
  if (top < z_low || bottom > z_high) return;
  // Points of the triangle no farther apart than half a cell.
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * longest / kCell_m)));
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Eigen::Vector3d p = a + (b - a) * i / steps + (c - a) * j / steps;
      if (p.z() >= z_low && p.z() <= z_high) distance_m_[cellAt(p.head<2>())] = 0;
    }
  }
}

void ClearanceMap::markOutside(const Scene& scene) {
  constexpr double kWall_m = 0.3;  // doorways lie between the rooms' boxes
  if (scene.rooms.empty()) return;
  for (std::size_t cell = 0; cell < distance_m_.size(); ++cell) {
    const Eigen::Vector2d p = center(cell);
    const bool inside = std::any_of(scene.rooms.begin(), scene.rooms.end(), [&](const Room& room) {
      return (p.array() > room.box.min().head<2>().array() - kWall_m).all() &&
             (p.array() < room.box.max().head<2>().array() + kWall_m).all();
    });
    if (!inside) distance_m_[cell] = 0;
  }
}

double ClearanceMap::at(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d p = (point - origin_) / kCell_m;
  const int column = static_cast<int>(std::floor(p.x()));
  const int row = static_cast<int>(std::floor(p.y()));
  if (column < 0 || row < 0 || column + 1 >= columns_ || row + 1 >= rows_) return 0;
  const double fx = p.x() - column;
  const double fy = p.y() - row;
  const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(column);
  const std::size_t next = cell + static_cast<std::size_t>(columns_);
  return (1 - fy) * ((1 - fx) * distance_m_[cell] + fx * distance_m_[cell + 1]) +
         fy * ((1 - fx) * distance_m_[next] + fx * distance_m_[next + 1]);
}

std::size_t ClearanceMap::cellAt(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d p = (point - origin_) / kCell_m;
  const int column = std::clamp(static_cast<int>(std::lround(p.x())), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(std::lround(p.y())), 0, rows_ - 1);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

Eigen::Vector2d ClearanceMap::center(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(columns_);
  return origin_ + kCell_m * Eigen::Vector2d(static_cast<double>(cell % columns),
                                             static_cast<double>(cell / columns));
}

RouteMap::RouteMap(const ClearanceMap& map, std::size_t start, double robot_radius_m)
    : cost_(static_cast<std::size_t>(map.columns()) * static_cast<std::size_t>(map.rows()),
            std::numeric_limits<float>::infinity()),
      previous_(cost_.size(), static_cast<std::uint32_t>(start)) {
  const int columns = map.columns();
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_[start] = 0;
  open.emplace(0.0f, static_cast<std::uint32_t>(start));
  while (!open.empty()) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost > cost_[cell]) continue;
    const int column = static_cast<int>(cell) % columns;
    const int row = static_cast<int>(cell) / columns;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = column + dx;
        const int y = row + dy;
        if ((dx == 0 && dy == 0) || x < 0 || y < 0 || x >= columns || y >= map.rows()) continue;
        const auto next = static_cast<std::uint32_t>(y * columns + x);
        const double clearance = map.atCell(next);
        if (clearance < robot_radius_m) continue;
        const double tightness = std::max(0.0, 1 - clearance / kComfort_m);
        const double length =
            ClearanceMap::kCell_m * std::sqrt(static_cast<double>(dx * dx + dy * dy));
        const auto total =
            cost + static_cast<float>(length * (1 + kTightnessCost * tightness * tightness));
        if (total < cost_[next]) {
          cost_[next] = total;
          previous_[next] = cell;
          open.emplace(total, next);
        }
      }
    }
  }
}

bool RouteMap::reaches(std::size_t cell) const { return std::isfinite(cost_[cell]); }

std::vector<std::size_t> RouteMap::route(std::size_t to) const {
  std::vector<std::size_t> cells = {to};
  while (previous_[cells.back()] != cells.back()) cells.push_back(previous_[cells.back()]);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace hydrabench
