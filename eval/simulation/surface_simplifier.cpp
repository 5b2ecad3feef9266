// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/surface_simplifier.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

/// Factor on the allowed squared error while there are too many faces.
constexpr double kOverdraft = 400;

/// Sum of weighted squared distances to planes n.x + d = 0, as x'Ax + 2b'x + c.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  Vector3d b = Vector3d::Zero();
  double c = 0;
  double weight = 0;

  void addPlane(const Vector3d& n, double d, double w) {
    xx += w * n.x() * n.x();
    xy += w * n.x() * n.y();
    xz += w * n.x() * n.z();
    yy += w * n.y() * n.y();
    yz += w * n.y() * n.z();
    zz += w * n.z() * n.z();
    b += w * d * n;
    c += w * d * d;
    weight += w;
  }
  void add(const Quadric& other) {
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
    b += other.b;
    c += other.c;
    weight += other.weight;
  }
  double at(const Vector3d& p) const {
    return p.x() * (xx * p.x() + 2 * (xy * p.y() + xz * p.z() + b.x())) +
           p.y() * (yy * p.y() + 2 * (yz * p.z() + b.y())) + p.z() * (zz * p.z() + 2 * b.z()) + c;
  }
};

struct Collapse {
  int from;
  int to;
  std::uint32_t from_version;
  std::uint32_t to_version;
};

/// Cheapest first, up to a factor of 1.1 in priority: collapses lie in buckets by the leading bits
/// of their priority. Several times faster than a heap, since neither end sorts.
class BucketQueue {
 public:
  void push(double priority, const Collapse& collapse) {
    const std::size_t bucket = bucketOf(priority);
    buckets_[bucket].push_back(collapse);
    lowest_ = std::min(lowest_, bucket);
  }
  bool pop(Collapse& collapse) {
    while (lowest_ < kBuckets && buckets_[lowest_].empty()) ++lowest_;
    if (lowest_ == kBuckets) return false;
    collapse = buckets_[lowest_].back();
    buckets_[lowest_].pop_back();
    return true;
  }

 private:
  static constexpr int kDroppedBits = 20;  ///< leaves sign, exponent and 3 bits of the fraction
  static constexpr std::size_t kBuckets = (0x7f800000u >> kDroppedBits) + 1;
  static std::size_t bucketOf(double priority) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(priority)) >> kDroppedBits;
  }
  std::vector<std::vector<Collapse>> buckets_ = std::vector<std::vector<Collapse>>(kBuckets);
  std::size_t lowest_ = kBuckets;
};

class Simplification {
 public:
  Simplification(const SurfaceMesh& surface, double max_error, std::size_t max_faces)
      : positions_(surface.mesh.vertices),
        faces_(surface.mesh.faces),
        face_part_(surface.face_part),
        num_faces_(surface.mesh.faces.size()),
        max_squared_error_(max_error * max_error),
        max_faces_(max_faces),
        quadrics_(positions_.size()),
        version_(positions_.size(), 0),
        faces_of_(positions_.size()),
        mark_(positions_.size(), -1) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (int id : faces_[f]) faces_of_[index(id)].push_back(static_cast<int>(f));
    }
    sumQuadrics();
  }

  SurfaceMesh run() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int a = faces_[f][k];
        const int b = faces_[f][(k + 1) % 3];
        if (a < b) enqueue(a, b);
      }
    }
    Collapse next{};
    while (queue_.pop(next)) {
      if (version_[index(next.from)] != next.from_version ||
          version_[index(next.to)] != next.to_version) {
        continue;
      }
      if (isWithinError(next.from, next.to) && isAllowed(next.from, next.to)) {
        apply(next.from, next.to);
      } else if (isWithinError(next.to, next.from) && isAllowed(next.to, next.from)) {
        apply(next.to, next.from);
      }
    }
    return compacted();
  }

 private:
  static std::size_t index(int id) { return static_cast<std::size_t>(id); }
  const Vector3d& position(int id) const { return positions_[index(id)]; }

  void sumQuadrics() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Eigen::Vector3i& face = faces_[f];
      const Vector3d cross =
          (position(face[1]) - position(face[0])).cross(position(face[2]) - position(face[0]));
      const double length = cross.norm();
      if (!(length > 0)) continue;
      const Vector3d normal = cross / length;
      const double offset = -normal.dot(position(face[0]));
      for (int k = 0; k < 3; ++k) {
        quadrics_[index(face[k])].addPlane(normal, offset, length);
        addPartBorder(static_cast<int>(f), face[k], face[(k + 1) % 3], normal);
      }
    }
  }

  /// A plane through a border edge, upright on the face, keeps the border's course.
  void addPartBorder(int f, int a, int b, const Vector3d& normal) {
    for (int other : faces_of_[index(a)]) {
      if (face_part_[index(other)] == face_part_[index(f)] || !contains(other, b)) continue;
      const Vector3d edge = position(b) - position(a);
      const Vector3d across = edge.cross(normal).normalized();
      const double offset = -across.dot(position(a));
      const double weight = edge.squaredNorm();
      quadrics_[index(a)].addPlane(across, offset, weight);
      quadrics_[index(b)].addPlane(across, offset, weight);
    }
  }

  bool contains(int f, int id) const {
    const Eigen::Vector3i& face = faces_[index(f)];
    return face[0] == id || face[1] == id || face[2] == id;
  }

  double squaredError(int from, int to) const {
    const Quadric& a = quadrics_[index(from)];
    const Quadric& b = quadrics_[index(to)];
    const double weight = a.weight + b.weight;
    if (!(weight > 0)) return 0;
    return std::max(0.0, (a.at(position(to)) + b.at(position(to))) / weight);
  }

  bool isWithinError(int from, int to) const {
    const double limit =
        num_faces_ > max_faces_ ? kOverdraft * max_squared_error_ : max_squared_error_;
    return squaredError(from, to) <= limit;
  }

  /// Puts the better direction of an edge in the queue, unless it will never be allowed.
  void enqueue(int a, int b) {
    const double a_to_b = squaredError(a, b);
    const double b_to_a = squaredError(b, a);
    const double error = std::min(a_to_b, b_to_a);
    if (error > kOverdraft * max_squared_error_) return;
    const int from = a_to_b <= b_to_a ? a : b;
    const int to = from == a ? b : a;
    // On flat ground, where all errors are zero, short edges go first: that gives well-shaped
    // triangles.
    const double priority = error + 1e-7 * (position(a) - position(b)).squaredNorm();
    queue_.push(priority, {from, to, version_[index(from)], version_[index(to)]});
  }

  /// Link condition (Dey et al. 1999): the ends have exactly two common neighbours. And no face may
  /// turn over or degenerate.
  bool isAllowed(int from, int to) {
    ++mark_value_;
    for (int f : faces_of_[index(to)]) {
      for (int id : faces_[index(f)]) mark_[index(id)] = mark_value_;
    }
    common_.clear();
    for (int f : faces_of_[index(from)]) {
      for (int id : faces_[index(f)]) {
        if (id != from && id != to && mark_[index(id)] == mark_value_ &&
            std::find(common_.begin(), common_.end(), id) == common_.end()) {
          common_.push_back(id);
        }
      }
    }
    if (common_.size() != 2) return false;
    for (int id : common_) {
      if (faces_of_[index(id)].size() <= 3) return false;
    }
    return !std::any_of(faces_of_[index(from)].begin(), faces_of_[index(from)].end(),
                        [&](int f) { return !contains(f, to) && spoilsFace(f, from, to); });
  }

  bool spoilsFace(int f, int from, int to) const {
    std::array<Vector3d, 3> p;
    std::array<Vector3d, 3> q;
    for (int k = 0; k < 3; ++k) {
      const int id = faces_[index(f)][k];
      p[index(k)] = position(id);
      q[index(k)] = position(id == from ? to : id);
    }
    const Vector3d before = (p[1] - p[0]).cross(p[2] - p[0]);
    const Vector3d after = (q[1] - q[0]).cross(q[2] - q[0]);
    const double size = after.norm();
    const double longest = std::max(
        {(q[1] - q[0]).squaredNorm(), (q[2] - q[1]).squaredNorm(), (q[0] - q[2]).squaredNorm()});
    if (size < 0.02 * longest && size < 0.5 * before.norm()) return true;  // sliver
    return before.dot(after) < 0.5 * before.norm() * size;
  }

  void apply(int from, int to) {
    std::vector<int>& faces_to = faces_of_[index(to)];
    for (int f : faces_of_[index(from)]) {
      if (contains(f, to)) {
        for (int id : faces_[index(f)]) {
          if (id != from) std::erase(faces_of_[index(id)], f);
        }
        faces_[index(f)][0] = -1;
        --num_faces_;
      } else {
        for (int& id : faces_[index(f)]) {
          if (id == from) id = to;
        }
        faces_to.push_back(f);
      }
    }
    faces_of_[index(from)].clear();
    quadrics_[index(to)].add(quadrics_[index(from)]);
    ++version_[index(from)];
    ++version_[index(to)];
    ++mark_value_;
    for (int f : faces_to) {
      for (int id : faces_[index(f)]) {
        if (id == to || mark_[index(id)] == mark_value_) continue;
        mark_[index(id)] = mark_value_;
        enqueue(to, id);
      }
    }
  }

  SurfaceMesh compacted() const {
    SurfaceMesh result;
    std::vector<int> new_id(positions_.size(), -1);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f][0] < 0) continue;
      Eigen::Vector3i face;
      for (int k = 0; k < 3; ++k) {
        int& id = new_id[index(faces_[f][k])];
        if (id < 0) {
          id = static_cast<int>(result.mesh.vertices.size());
          result.mesh.vertices.push_back(position(faces_[f][k]));
        }
        face[k] = id;
      }
      result.mesh.faces.push_back(face);
      result.face_part.push_back(face_part_[f]);
    }
    return result;
  }

  std::vector<Vector3d> positions_;
  std::vector<Eigen::Vector3i> faces_;  ///< first index -1: removed
  std::vector<std::uint16_t> face_part_;
  std::size_t num_faces_;
  double max_squared_error_;
  std::size_t max_faces_;
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t>
      version_;  ///< counts changes; a queued collapse of an older version is stale
  std::vector<std::vector<int>> faces_of_;
  std::vector<int> mark_;
  int mark_value_ = -1;
  std::vector<int> common_;
  BucketQueue queue_;
};

}  // namespace

SurfaceMesh simplifySurface(const SurfaceMesh& surface, double max_error_m, std::size_t max_faces) {
  return Simplification(surface, max_error_m, max_faces).run();
}

}  // namespace hydrabench
