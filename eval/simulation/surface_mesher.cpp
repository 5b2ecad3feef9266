// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/surface_mesher.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/geometry/cube_contours.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// A member of the union and the part it belongs to.
struct Member {
  const Sdf* sdf;
  std::uint16_t part;
};

class Extraction {
 public:
  Extraction(const std::vector<ShapePart>& parts, double pitch) : pitch_(pitch) {
    Aabb box;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      box.extend(parts[i].sdf->bounds());
      std::vector<const Sdf*> leaves;
      parts[i].sdf->collectMembers(leaves);
      for (const Sdf* leaf : leaves) members_.push_back({leaf, static_cast<std::uint16_t>(i)});
    }
    // An uneven offset keeps grid planes off the faces of shapes made in round numbers.
    origin_ = box.min() - pitch * Vector3d(1.317, 1.291, 1.343);
    cells_ = ((box.max() - origin_) / pitch).array().ceil().cast<int>() + 1;
    corners_ = cells_ + Vector3i::Ones();
    values_.assign(static_cast<std::size_t>(corners_.x()) * static_cast<std::size_t>(corners_.y()) *
                       static_cast<std::size_t>(corners_.z()),
                   std::numeric_limits<float>::quiet_NaN());
  }

  SurfaceMesh run() {
    int size = 1;
    while (size < cells_.maxCoeff()) size *= 2;
    descend(Vector3i::Zero(), size, members_);
    return std::move(surface_);
  }

 private:
  static double valueOf(const std::vector<Member>& members, const Vector3d& p) {
    double best = std::numeric_limits<double>::infinity();
    for (const Member& member : members) best = std::min(best, member.sdf->value(p));
    return best;
  }

  void descend(const Vector3i& cell, int size, const std::vector<Member>& members) {
    if ((cell.array() >= cells_.array()).any()) return;
    const Vector3d center = origin_ + pitch_ * (cell.cast<double>().array() + 0.5 * size).matrix();
    const double reach = 0.5 * std::sqrt(3.0) * size * pitch_ * (1 + 1e-9);
    std::vector<double> values(members.size());
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < members.size(); ++i) {
      values[i] = members[i].sdf->value(center);
      best = std::min(best, values[i]);
    }
    if (std::abs(best) > reach) return;
    std::vector<Member> relevant;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (values[i] <= best + 2 * reach) relevant.push_back(members[i]);
    }
    if (size == 1) {
      cutCell(cell, relevant);
      return;
    }
    const int half = size / 2;
    for (int child = 0; child < 8; ++child) {
      descend(cell + half * cornerOffset(child), half, relevant);
    }
  }

  static Vector3i cornerOffset(int corner) {
    return {corner & 1, corner >> 1 & 1, corner >> 2 & 1};
  }

  std::uint64_t cornerIndex(const Vector3i& corner) const {
    return static_cast<std::uint64_t>(corner.x()) +
           static_cast<std::uint64_t>(corners_.x()) *
               (static_cast<std::uint64_t>(corner.y()) +
                static_cast<std::uint64_t>(corners_.y()) * static_cast<std::uint64_t>(corner.z()));
  }
  Vector3d cornerPosition(const Vector3i& corner) const {
    return origin_ + pitch_ * corner.cast<double>();
  }
  float cornerValue(const Vector3i& corner, const std::vector<Member>& members) {
    float& value = values_[cornerIndex(corner)];
    if (std::isnan(value)) value = static_cast<float>(valueOf(members, cornerPosition(corner)));
    return value;
  }

  void cutCell(const Vector3i& cell, const std::vector<Member>& members) {
    std::array<float, 8> values;
    int mask = 0;
    for (int c = 0; c < 8; ++c) {
      values[static_cast<std::size_t>(c)] = cornerValue(cell + cornerOffset(c), members);
      if (values[static_cast<std::size_t>(c)] < 0) mask |= 1 << c;
    }
    for (const CubeContour& contour : cubeContours(mask)) {
      std::vector<int> ids;
      for (int edge : contour.edges) ids.push_back(edgeVertex(cell, edge, values, members));
      if (contour.fan_at_first) {
        for (std::size_t k = 1; k + 1 < ids.size(); ++k) {
          addFace({ids[0], ids[k], ids[k + 1]}, members);
        }
      } else {
        const int middle = middleVertex(ids, members);
        for (std::size_t k = 0; k < ids.size(); ++k) {
          addFace({middle, ids[k], ids[(k + 1) % ids.size()]}, members);
        }
      }
    }
  }

  int edgeVertex(const Vector3i& cell, int edge, const std::array<float, 8>& values,
                 const std::vector<Member>& members) {
    const Vector3i start = cell + cornerOffset(cubeEdgeStart(edge));
    const std::uint64_t key = 3 * cornerIndex(start) + static_cast<std::uint64_t>(edge / 4);
    const auto [entry, is_new] = edge_vertices_.try_emplace(key, 0);
    if (is_new) {
      const Vector3d a = cornerPosition(start);
      const Vector3d b = cornerPosition(cell + cornerOffset(cubeEdgeEnd(edge)));
      entry->second =
          addVertex(crossing(a, b, values[static_cast<std::size_t>(cubeEdgeStart(edge))],
                             values[static_cast<std::size_t>(cubeEdgeEnd(edge))], members),
                    members);
    }
    return entry->second;
  }

  /// Zero between two points of opposite sign, by false position with halved end values (the
  /// Illinois rule).
  static Vector3d crossing(const Vector3d& a, const Vector3d& b, double value_a, double value_b,
                           const std::vector<Member>& members) {
    double low = 0;
    double high = 1;
    double t = 0.5;
    int last_side = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      t = low + (high - low) * value_a / (value_a - value_b);
      const double value = valueOf(members, a + t * (b - a));
      if (std::abs(value) < 2e-6) break;
      if ((value < 0) == (value_a < 0)) {
        low = t;
        value_a = value;
        if (last_side == 1) value_b *= 0.5;
        last_side = 1;
      } else {
        high = t;
        value_b = value;
        if (last_side == -1) value_a *= 0.5;
        last_side = -1;
      }
    }
    // Off the corners, so that vertices of different edges never share a position.
    return a + std::clamp(t, 1e-3, 1 - 1e-3) * (b - a);
  }

  int addVertex(const Vector3d& p, const std::vector<Member>& members) {
    surface_.mesh.vertices.push_back(p);
    vertex_part_.push_back(nearestPart(p, members));
    return static_cast<int>(surface_.mesh.vertices.size()) - 1;
  }
  const Vector3d& position(int id) const {
    return surface_.mesh.vertices[static_cast<std::size_t>(id)];
  }

  static std::uint16_t nearestPart(const Vector3d& p, const std::vector<Member>& members) {
    std::uint16_t part = members.front().part;
    if (members.size() == 1) return part;
    double best = std::numeric_limits<double>::infinity();
    for (const Member& member : members) {
      const double value = member.sdf->value(p);
      if (value < best) {
        best = value;
        part = member.part;
      }
    }
    return part;
  }

  /// Newton steps along the gradient; where a crease defeats them, the zero on the line along it.
  static Vector3d projected(Vector3d p, const std::vector<Member>& members) {
    double value = valueOf(members, p);
    Vector3d gradient = Vector3d::UnitZ();
    for (int iteration = 0; iteration < 6 && std::abs(value) > 2e-6; ++iteration) {
      constexpr double kStep = 1e-5;
      for (int i = 0; i < 3; ++i) {
        const Vector3d d = kStep * Vector3d::Unit(i);
        gradient[i] = (valueOf(members, p + d) - valueOf(members, p - d)) / (2 * kStep);
      }
      p -= value * gradient / std::max(gradient.squaredNorm(), 0.25);
      value = valueOf(members, p);
    }
    if (std::abs(value) <= 2e-6) return p;
    for (double reach = 2 * value; std::abs(reach) < 100 * std::abs(value); reach *= 2) {
      const Vector3d q = p - reach * gradient.normalized();
      const double value_q = valueOf(members, q);
      if ((value_q < 0) != (value < 0)) return crossing(p, q, value, value_q, members);
    }
    return p;
  }

  int middleVertex(const std::vector<int>& ids, const std::vector<Member>& members) {
    Vector3d p = Vector3d::Zero();
    for (int id : ids) p += position(id) / static_cast<double>(ids.size());
    return addVertex(projected(p, members), members);
  }

  static double valueOfPart(const std::vector<Member>& members, std::uint16_t part,
                            const Vector3d& p) {
    double best = 1;  // [m], far
    for (const Member& member : members) {
      if (member.part == part) best = std::min(best, member.sdf->value(p));
    }
    return best;
  }

  /// The vertex that splits an edge where its ends' parts are equally near.
  int borderVertex(int a, int b, const std::vector<Member>& members) {
    const auto key = std::minmax(a, b);
    const auto [entry, is_new] = border_vertices_.try_emplace(
        static_cast<std::uint64_t>(key.first) << 32 | static_cast<std::uint64_t>(key.second), 0);
    if (is_new) {
      const std::uint16_t part_a = vertex_part_[static_cast<std::size_t>(a)];
      const std::uint16_t part_b = vertex_part_[static_cast<std::size_t>(b)];
      double low = 0;
      double high = 1;
      for (int iteration = 0; iteration < 12; ++iteration) {
        const double t = 0.5 * (low + high);
        const Vector3d p = position(a) + t * (position(b) - position(a));
        (valueOfPart(members, part_a, p) < valueOfPart(members, part_b, p) ? low : high) = t;
      }
      const double t = std::clamp(low, 0.04, 0.96);
      entry->second =
          addVertex(projected(position(a) + t * (position(b) - position(a)), members), members);
    }
    return entry->second;
  }

  /// A triangle across a border between parts is cut along it.
  void addFace(const Vector3i& face, const std::vector<Member>& members) {
    const auto partOf = [&](int k) { return vertex_part_[static_cast<std::size_t>(face[k % 3])]; };
    if (partOf(0) == partOf(1) && partOf(1) == partOf(2)) {
      emitFace(face, partOf(0));
      return;
    }
    for (int odd = 0; odd < 3; ++odd) {  // one corner differs from the other two
      if (partOf(odd + 1) != partOf(odd + 2)) continue;
      const int c = face[odd];
      const int a = face[(odd + 1) % 3];
      const int b = face[(odd + 2) % 3];
      const int p = borderVertex(b, c, members);
      const int q = borderVertex(c, a, members);
      emitFace({a, b, p}, partOf(odd + 1));
      emitFace({a, p, q}, partOf(odd + 1));
      emitFace({q, p, c}, partOf(odd));
      return;
    }
    const int middle = middleVertex({face[0], face[1], face[2]}, members);
    for (int k = 0; k < 3; ++k) {
      const int next = borderVertex(face[k], face[(k + 1) % 3], members);
      const int previous = borderVertex(face[(k + 2) % 3], face[k], members);
      emitFace({face[k], next, middle}, partOf(k));
      emitFace({face[k], middle, previous}, partOf(k));
    }
  }

  void emitFace(const Vector3i& face, std::uint16_t part) {
    surface_.mesh.faces.push_back(face);
    surface_.face_part.push_back(part);
  }

  double pitch_;
  std::vector<Member> members_;
  Vector3d origin_;
  Vector3i cells_;
  Vector3i corners_;
  std::vector<float> values_;                             ///< at grid corners; NaN: not needed yet
  std::unordered_map<std::uint64_t, int> edge_vertices_;  ///< by grid edge
  std::unordered_map<std::uint64_t, int> border_vertices_;  ///< by the pair of vertices they part
  std::vector<std::uint16_t> vertex_part_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh extractSurface(const std::vector<ShapePart>& parts, double pitch_m) {
  assert(pitch_m > 0 && !parts.empty());
  return Extraction(parts, pitch_m).run();
}

}  // namespace hydrabench
