// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>

#include "core/geometry/mesh_topology.h"

namespace hydrabench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Quadric error (Garland and Heckbert, SIGGRAPH 1997) of a half-edge collapse. OpenMesh's own
/// module takes a bound in area times squared length, and refuses collapses inside a plane when
/// rounding makes their error negative. Here the bound is in metres, the root mean square distance
/// to the planes of the merged faces, and rounding counts as zero.
class QuadricModule : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh> {
 public:
  // What OpenMesh's DECIMATING_MODULE declares, for a class that is no template.
  using Handle = OpenMesh::Decimater::ModHandleT<QuadricModule>;
  using Base = OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>;
  using CollapseInfo = Base::CollapseInfo;
  const std::string& name() const override {
    static const std::string name = "Quadric";
    return name;
  }

  explicit QuadricModule(HalfEdgeMesh& mesh) : Base(mesh, false) {}
  void setMaxError(double max_error) { max_squared_error_ = max_error * max_error; }

  void initialize() override {
    errors_.assign(Base::mesh().n_vertices(), {});
    for (const auto face : Base::mesh().faces()) {
      const auto edge = Base::mesh().halfedge_handle(face);
      const Eigen::Vector3d a = pointOf(Base::mesh().from_vertex_handle(edge));
      const Eigen::Vector3d b = pointOf(Base::mesh().to_vertex_handle(edge));
      const auto next = Base::mesh().next_halfedge_handle(edge);
      const Eigen::Vector3d c = pointOf(Base::mesh().to_vertex_handle(next));
      const Eigen::Vector3d cross = (b - a).cross(c - a);
      const double area = 0.5 * cross.norm();
      if (!(area > 0)) continue;
      const Error error(cross.normalized(), a, area);
      for (const auto vertex : Base::mesh().fv_range(face)) errorOf(vertex) += error;
      for (const auto border : Base::mesh().fh_range(face)) holdBorder(border, cross.normalized());
    }
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    Error error = errorOf(collapse.v0);
    error += errorOf(collapse.v1);
    const double value = error.at(pointOf(collapse.v1));
    if (value > max_squared_error_ * error.area) return Base::ILLEGAL_COLLAPSE;
    return static_cast<float>(value);
  }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    errorOf(collapse.v1) += errorOf(collapse.v0);
  }

 private:
  /// Sum of area-weighted squared distances to planes, as a quadratic form of the point.
  struct Error {
    Error() = default;
    Error(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight)
        : square(weight * normal * normal.transpose()),
          linear(-weight * normal.dot(point) * normal),
          constant(weight * normal.dot(point) * normal.dot(point)),
          area(weight) {}
    void operator+=(const Error& other) {
      square += other.square;
      linear += other.linear;
      constant += other.constant;
      area += other.area;
    }
    double at(const Eigen::Vector3d& p) const {
      return std::max(0.0, p.dot(square * p) + 2.0 * linear.dot(p) + constant);
    }
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    double constant = 0;
    double area = 0;  ///< [m^2]
  };

  /// A border edge is held by a plane through it, at right angles to its face; else an open surface
  /// would shrink for free.
  void holdBorder(OpenMesh::HalfedgeHandle edge, const Eigen::Vector3d& face_normal) {
    if (!Base::mesh().is_boundary(Base::mesh().opposite_halfedge_handle(edge))) return;
    const auto from = Base::mesh().from_vertex_handle(edge);
    const auto to = Base::mesh().to_vertex_handle(edge);
    const Eigen::Vector3d along = pointOf(to) - pointOf(from);
    const Eigen::Vector3d normal = along.cross(face_normal);
    if (!(normal.norm() > 0)) return;
    const Error error(normal.normalized(), pointOf(from), along.squaredNorm());
    errorOf(from) += error;
    errorOf(to) += error;
  }

  Error& errorOf(OpenMesh::VertexHandle v) { return errors_[static_cast<std::size_t>(v.idx())]; }
  Eigen::Vector3d pointOf(OpenMesh::VertexHandle v) {
    return Eigen::Vector3d(Base::mesh().point(v).data());
  }

  std::vector<Error> errors_;
  double max_squared_error_ = 0;
};

/// For every corner of every face the fan it belongs to: corners at one vertex whose faces are
/// connected over regular edges (two faces, opposite directions) at that vertex. OpenMesh holds
/// 2-manifolds only, so every fan becomes a vertex of its own.
std::vector<Eigen::Vector3i> splitIntoFans(const Mesh& mesh, std::vector<int>& vertex_of_fan) {
  struct Side {
    std::size_t forward = 0;  ///< corner index 3 * face + k of the half-edge low -> high, plus 1
    std::size_t backward = 0;
    int faces = 0;
  };
  std::map<std::pair<int, int>, Side> edges;
  for (std::size_t i = 0; i < 3 * mesh.faces.size(); ++i) {
    const Eigen::Vector3i& face = mesh.faces[i / 3];
    const int from = face[static_cast<int>(i % 3)];
    const int to = face[static_cast<int>((i + 1) % 3)];
    Side& side = edges[std::minmax(from, to)];
    (from < to ? side.forward : side.backward) = i + 1;
    ++side.faces;
  }
  std::vector<std::size_t> fan(3 * mesh.faces.size());
  std::iota(fan.begin(), fan.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (fan[i] != i) i = fan[i] = fan[fan[i]];
    return i;
  };
  const auto next = [](std::size_t corner) { return corner - corner % 3 + (corner + 1) % 3; };
  const auto join = [&](std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    fan[std::max(a, b)] = std::min(a, b);
  };
  for (const auto& [vertices, side] : edges) {
    if (side.faces != 2 || side.forward == 0 || side.backward == 0) continue;
    const std::size_t forward = side.forward - 1;
    const std::size_t backward = side.backward - 1;
    join(forward, next(backward));
    join(next(forward), backward);
  }
  std::vector<int> index_of_fan(fan.size(), -1);
  std::vector<Eigen::Vector3i> faces(mesh.faces.size());
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto k = static_cast<int>(i % 3);
    int& index = index_of_fan[find(i)];
    if (index < 0) {
      index = static_cast<int>(vertex_of_fan.size());
      vertex_of_fan.push_back(mesh.faces[i / 3][k]);
    }
    faces[i / 3][k] = index;
  }
  return faces;
}

}  // namespace

Mesh decimated(const Mesh& mesh, std::size_t target_faces, double max_error) {
  const Mesh input = welded(mesh);
  if (input.faces.size() <= target_faces) return input;

  std::vector<int> vertex_of_fan;
  const std::vector<Eigen::Vector3i> faces = splitIntoFans(input, vertex_of_fan);
  std::vector<int> fans_of_vertex(input.vertices.size(), 0);
  for (const int vertex : vertex_of_fan) ++fans_of_vertex[static_cast<std::size_t>(vertex)];

  // About the centre: quadrics subtract squares of coordinates.
  const Eigen::Vector3d center = bounds(input).center();
  HalfEdgeMesh half_edges;
  half_edges.request_vertex_status();
  half_edges.request_edge_status();
  half_edges.request_face_status();
  half_edges.request_face_normals();
  for (const int vertex : vertex_of_fan) {
    const Eigen::Vector3d p = input.vertices[static_cast<std::size_t>(vertex)] - center;
    const auto handle = half_edges.add_vertex({p.x(), p.y(), p.z()});
    // Where fans meet, all of them stay, so that they meet afterwards.
    half_edges.status(handle).set_locked(fans_of_vertex[static_cast<std::size_t>(vertex)] > 1);
  }
  for (const Eigen::Vector3i& face : faces) {
    const auto added =
        half_edges.add_face(OpenMesh::VertexHandle(face[0]), OpenMesh::VertexHandle(face[1]),
                            OpenMesh::VertexHandle(face[2]));
    if (!added.is_valid()) return input;  // not a surface OpenMesh can hold: better whole than torn
  }
  half_edges.update_face_normals();

  OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half_edges);
  QuadricModule::Handle quadric;
  OpenMesh::Decimater::ModHandleT<OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>> flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).setMaxError(max_error);
  decimater.module(flipping).set_max_normal_deviation(60.0);
  decimater.initialize();
  decimater.decimate_to_faces(0, target_faces);

  // A half-edge collapse moves no vertex: what remains has its position and colour from the input.
  Mesh result;
  result.vertices = input.vertices;
  result.colors = input.colors;
  for (const auto face : half_edges.faces()) {
    if (half_edges.status(face).deleted()) continue;
    Eigen::Vector3i corners;
    int k = 0;
    for (const auto vertex : half_edges.fv_range(face)) {
      corners[k++] = vertex_of_fan[static_cast<std::size_t>(vertex.idx())];
    }
    result.faces.push_back(corners);
  }
  return welded(result);
}

}  // namespace hydrabench
