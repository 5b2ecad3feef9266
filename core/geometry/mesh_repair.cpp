// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/optimal_bounding_box.h>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/geometry/mesh_topology.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Triangle = std::array<std::size_t, 3>;

struct Soup {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

Soup soupOf(const Mesh& mesh) {
  Soup soup;
  soup.points.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices) soup.points.emplace_back(v.x(), v.y(), v.z());
  soup.triangles.reserve(mesh.faces.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    soup.triangles.push_back({static_cast<std::size_t>(face[0]), static_cast<std::size_t>(face[1]),
                              static_cast<std::size_t>(face[2])});
  }
  return soup;
}

/// A soup as an oriented manifold; vertices and edges where it is none are split.
SurfaceMesh surfaceOf(const Mesh& mesh) {
  Soup soup = soupOf(mesh);
  pmp::repair_polygon_soup(soup.points, soup.triangles);
  pmp::orient_polygon_soup(soup.points, soup.triangles);
  SurfaceMesh surface;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface);
  return surface;
}

Mesh meshOf(const SurfaceMesh& surface) {
  Mesh mesh;
  std::map<SurfaceMesh::Vertex_index, int> index;
  for (const auto vertex : surface.vertices()) {
    index.emplace(vertex, static_cast<int>(mesh.vertices.size()));
    const Point& p = surface.point(vertex);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    Eigen::Vector3i corners;
    int k = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      corners[k++] = index.at(vertex);
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

SurfaceMesh closedSurfaceOf(const Mesh& mesh) {
  const MeshTopology topology = analyzeTopology(mesh);
  if (!topology.watertight()) {
    throw InputError(fmt::format(
        "mesh has {} boundary, {} non-manifold and {} misoriented edges, expected a watertight one",
        topology.boundary_edges, topology.nonmanifold_edges, topology.misoriented_edges));
  }
  SurfaceMesh surface = surfaceOf(mesh);
  if (!pmp::is_outward_oriented(surface)) pmp::reverse_face_orientations(surface);
  return surface;
}

}  // namespace

Mesh withHolesFilled(const Mesh& mesh) {
  SurfaceMesh surface = surfaceOf(mesh);
  std::vector<SurfaceMesh::Halfedge_index> holes;
  pmp::extract_boundary_cycles(surface, std::back_inserter(holes));
  for (const auto hole : holes) {
    std::vector<SurfaceMesh::Face_index> faces;
    std::vector<SurfaceMesh::Vertex_index> vertices;
    pmp::triangulate_refine_and_fair_hole(surface, hole, std::back_inserter(faces),
                                          std::back_inserter(vertices));
  }
  return meshOf(surface);
}

Mesh alphaWrapped(const Mesh& mesh, double alpha, double offset) {
  const Soup soup = soupOf(mesh);
  SurfaceMesh wrap;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset, wrap);
  return meshOf(wrap);
}

OrientedBox smallestBox(const Mesh& mesh) {
  const Soup soup = soupOf(mesh);
  const Aabb box = bounds(mesh);
  const double size = box.isEmpty() ? 0 : box.diagonal().norm();
  // Four points that span a volume: the farthest from the first, from their line, from their plane.
  const auto spans = [&] {
    if (mesh.vertices.size() < 4) return false;
    const Eigen::Vector3d& origin = mesh.vertices.front();
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    for (const auto& v : mesh.vertices)
      if ((v - origin).norm() > along.norm()) along = v - origin;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const auto& v : mesh.vertices)
      if (along.cross(v - origin).norm() > normal.norm()) normal = along.cross(v - origin);
    double height = 0;
    for (const auto& v : mesh.vertices)
      height = std::max(height, std::abs(normal.normalized().dot(v - origin)));
    return normal.norm() > 1e-9 * size * size && height > 1e-9 * size;
  };
  if (!spans())
    throw InputError(fmt::format("mesh of {} vertices spans no volume, so it has no oriented box",
                                 mesh.vertices.size()));

  std::array<Point, 8> corners;
  CGAL::oriented_bounding_box(soup.points, corners,
                              CGAL::parameters::use_convex_hull(true).random_seed(1));
  const auto vector = [](const Point& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); };
  // CGAL numbers the corners as make_hexahedron does: 1, 3 and 5 are the neighbours of 0.
  const Eigen::Vector3d origin = vector(corners[0]);
  Eigen::Matrix3d axes;
  axes << vector(corners[1]) - origin, vector(corners[3]) - origin, vector(corners[5]) - origin;
  OrientedBox result;
  result.dimensions = axes.colwise().norm();
  for (int axis = 0; axis < 3; ++axis) axes.col(axis) /= result.dimensions[axis];
  if (axes.determinant() < 0) {
    axes.col(1).swap(axes.col(2));
    std::swap(result.dimensions[1], result.dimensions[2]);
  }
  result.T_world_box.linear() = axes;
  result.T_world_box.translation() = 0.5 * (origin + vector(corners[7]));
  return result;
}

double intersectionVolume(const Mesh& a, const Mesh& b) {
  SurfaceMesh surface_a = closedSurfaceOf(a);
  SurfaceMesh surface_b = closedSurfaceOf(b);
  SurfaceMesh both;
  bool is_manifold = false;
  try {
    is_manifold = pmp::corefine_and_compute_intersection(
        surface_a, surface_b, both, CGAL::parameters::throw_on_self_intersection(true));
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    throw InputError("mesh intersects itself where the two meet, expected a simple solid");
  }
  if (!is_manifold)
    throw InputError("intersection of the meshes is no 2-manifold, its volume is not computed");
  return both.is_empty() ? 0.0 : CGAL::to_double(pmp::volume(both));
}

}  // namespace hydrabench
