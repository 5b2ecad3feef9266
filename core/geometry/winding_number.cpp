// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace hydrabench {
namespace {

constexpr std::size_t kLeafSize = 8;
constexpr double kBeta =
    2.0;  ///< a node is far when the query is kBeta radii away (Barill et al., section 4)

struct Triangle {
  Eigen::Vector3d a, b, c;
};

/// Solid angle (van Oosterom and Strackee, IEEE TBME 1983) as seen from `query`, over 4 pi.
double windingOf(const Triangle& triangle, const Eigen::Vector3d& query) {
  const Eigen::Vector3d a = triangle.a - query;
  const Eigen::Vector3d b = triangle.b - query;
  const Eigen::Vector3d c = triangle.c - query;
  const double length_a = a.norm();
  const double length_b = b.norm();
  const double length_c = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator = length_a * length_b * length_c + a.dot(b) * length_c +
                             b.dot(c) * length_a + c.dot(a) * length_b;
  return std::atan2(numerator, denominator) / (2.0 * std::numbers::pi);
}

/// Taylor expansion of the winding of many triangles about their area-weighted centre p (Barill et
/// al., equation 12): with r = p - query and the dipole kernel g = r / (4 pi |r|^3),
///   w = N . g  +  M : grad g  +  1/2 C : grad grad g,
/// N = integral of the normal n, M = integral of (x - p) n^T, C = integral of (x - p)(x - p) n, all
/// over the surface. The second derivatives are symmetric and traceless in pairs, so of C only a
/// vector and a cubic form are needed.
struct Node {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double far_squared = 0;                            ///< (kBeta * radius)^2 [m^2]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< N
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();  ///< M, symmetric part
  double moment_trace = 0;
  Eigen::Vector3d cubic_trace = Eigen::Vector3d::Zero();
  std::array<double, 10> cubic = {};  ///< of r_i r_j r_k: xxx yyy zzz xxy xxz yyx yyz zzx zzy xyz
  std::uint32_t begin = 0;            ///< triangles [begin, end)
  std::uint32_t end = 0;
  std::uint32_t right = 0;  ///< second child; the first one follows its parent. 0: leaf

  double farField(const Eigen::Vector3d& r, double squared) const {
    const double inverse = 1.0 / squared;
    const double inverse3 = inverse * std::sqrt(inverse);
    const double x = r.x();
    const double y = r.y();
    const double z = r.z();
    const double cubic_form = x * x * (cubic[0] * x + cubic[3] * y + cubic[4] * z) +
                              y * y * (cubic[1] * y + cubic[5] * x + cubic[6] * z) +
                              z * z * (cubic[2] * z + cubic[7] * x + cubic[8] * y) +
                              cubic[9] * x * y * z;
    const double first = normal.dot(r);
    const double second = moment_trace - 3.0 * inverse * r.dot(moment * r);
    const double third = inverse * (-1.5 * cubic_trace.dot(r) + 7.5 * inverse * cubic_form);
    return inverse3 * (first + second + third) / (4.0 * std::numbers::pi);
  }
};

}  // namespace

struct WindingNumber::Impl {
  std::vector<Triangle> triangles;  ///< in the order of the leaves
  std::vector<Node> nodes;

  void build(std::uint32_t begin, std::uint32_t end) {
    const std::size_t index = nodes.size();
    nodes.push_back(expansionOf(begin, end));
    if (end - begin <= kLeafSize) return;
    Eigen::AlignedBox3d centers;
    for (std::uint32_t i = begin; i < end; ++i) centers.extend(centerOf(triangles[i]));
    int axis = 0;
    centers.sizes().maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) {
      return triangles.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Triangle& s, const Triangle& t) {
      return centerOf(s)[axis] < centerOf(t)[axis];
    });
    build(begin, middle);
    nodes[index].right = static_cast<std::uint32_t>(nodes.size());
    build(middle, end);
  }

  static Eigen::Vector3d centerOf(const Triangle& t) { return (t.a + t.b + t.c) / 3.0; }

  Node expansionOf(std::uint32_t begin, std::uint32_t end) const {
    Node node;
    node.begin = begin;
    node.end = end;
    double total_area = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::uint32_t i = begin; i < end; ++i) {
      const Triangle& t = triangles[i];
      const double area = 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
      node.center += area * centerOf(t);
      mean += centerOf(t);
      total_area += area;
    }
    node.center = total_area > 0 ? Eigen::Vector3d(node.center / total_area)
                                 : Eigen::Vector3d(mean / std::max(1u, end - begin));

    double squared_radius = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      const Eigen::Vector3d a = triangles[i].a - node.center;
      const Eigen::Vector3d b = triangles[i].b - node.center;
      const Eigen::Vector3d c = triangles[i].c - node.center;
      squared_radius =
          std::max({squared_radius, a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
      const Eigen::Vector3d n = 0.5 * (b - a).cross(c - a);  // normal times area
      const Eigen::Matrix3d outer = (a + b + c) / 3.0 * n.transpose();
      node.normal += n;
      node.moment += 0.5 * (outer + outer.transpose());
      node.moment_trace += outer.trace();
      // The midpoints of the edges integrate quadratic functions over a triangle exactly.
      for (const Eigen::Vector3d& m :
           {Eigen::Vector3d(0.5 * (a + b)), Eigen::Vector3d(0.5 * (b + c)),
            Eigen::Vector3d(0.5 * (c + a))}) {
        const Eigen::Vector3d w = n / 3.0;
        node.cubic_trace += 2.0 * m * m.dot(w) + m.squaredNorm() * w;
        const Eigen::Vector3d s = m.cwiseProduct(m);
        node.cubic[0] += s.x() * w.x();
        node.cubic[1] += s.y() * w.y();
        node.cubic[2] += s.z() * w.z();
        node.cubic[3] += s.x() * w.y() + 2.0 * m.x() * m.y() * w.x();
        node.cubic[4] += s.x() * w.z() + 2.0 * m.x() * m.z() * w.x();
        node.cubic[5] += s.y() * w.x() + 2.0 * m.x() * m.y() * w.y();
        node.cubic[6] += s.y() * w.z() + 2.0 * m.y() * m.z() * w.y();
        node.cubic[7] += s.z() * w.x() + 2.0 * m.x() * m.z() * w.z();
        node.cubic[8] += s.z() * w.y() + 2.0 * m.y() * m.z() * w.z();
        node.cubic[9] +=
            2.0 * (m.x() * m.y() * w.z() + m.y() * m.z() * w.x() + m.x() * m.z() * w.y());
      }
    }
    node.far_squared = kBeta * kBeta * squared_radius;
    return node;
  }
};

WindingNumber::WindingNumber(const Mesh& mesh) : impl_(std::make_unique<Impl>()) {
  impl_->triangles.reserve(mesh.faces.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    impl_->triangles.push_back({mesh.vertices[static_cast<std::size_t>(face[0])],
                                mesh.vertices[static_cast<std::size_t>(face[1])],
                                mesh.vertices[static_cast<std::size_t>(face[2])]});
  }
  if (!mesh.faces.empty()) impl_->build(0, static_cast<std::uint32_t>(mesh.faces.size()));
}
WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::at(const Eigen::Vector3d& query) const {
  if (impl_->nodes.empty()) return 0;
  double winding = 0;
  std::array<std::uint32_t, 64> stack;  // the tree halves: its depth is log2(faces) at most
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = impl_->nodes[index];
    const Eigen::Vector3d r = node.center - query;
    const double squared = r.squaredNorm();
    if (squared > node.far_squared) {
      winding += node.farField(r, squared);
    } else if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        winding += windingOf(impl_->triangles[i], query);
      }
    } else {
      stack[depth++] = node.right;
      stack[depth++] = index + 1;
    }
  }
  return winding;
}

double WindingNumber::exactAt(const Eigen::Vector3d& query) const {
  double winding = 0;
  for (const Triangle& triangle : impl_->triangles) winding += windingOf(triangle, query);
  return winding;
}

}  // namespace hydrabench
