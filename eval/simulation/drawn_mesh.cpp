// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/drawn_mesh.h"

#include "eval/simulation/smooth_normals.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

const Rgb kGrey = {165, 165, 165};

}  // namespace

DrawnMesh::DrawnMesh(const Surface& surface, const Transform& T_world_mesh, Label label,
                     bool emissive)
    : corner_normals_(cornerNormals(surface.mesh)),
      materials_(surface.materials),
      face_material_(surface.face_material),
      R_mesh_world_(T_world_mesh.linear().transpose().cast<float>()),
      t_mesh_world_(T_world_mesh.inverse().translation().cast<float>()),
      label_(label),
      emissive_(emissive) {
  const Eigen::Matrix3f R_world_mesh = R_mesh_world_.transpose();
  for (Vector3f& normal : corner_normals_) normal = R_world_mesh * normal;
  const auto vertex = [](int index) { return static_cast<std::size_t>(index); };
  const Mesh& mesh = surface.mesh;
  face_normals_.reserve(mesh.faces.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices[vertex(face[0])];
    const Eigen::Vector3d normal =
        (mesh.vertices[vertex(face[1])] - a).cross(mesh.vertices[vertex(face[2])] - a).normalized();
    face_normals_.push_back(R_world_mesh * normal.cast<float>());
    if (materials_.empty() && !mesh.colors.empty()) {
      for (const int i : face) corner_colors_.push_back(mesh.colors[vertex(i)]);
    }
  }
}

DrawnMesh::SurfaceSample DrawnMesh::sample(const Raycaster::Hit& hit, const Vector3f& point,
                                           const Vector3f& direction) const {
  SurfaceSample sample;
  const Vector3f& flat = face_normals_[hit.face];
  const Vector3f* corners = corner_normals_.data() + 3 * std::size_t{hit.face};
  const float weights[3] = {1 - hit.u - hit.v, hit.u, hit.v};
  const Vector3f smooth =
      (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]).normalized();
  const float side = flat.dot(direction) > 0 ? -1.0f : 1.0f;
  sample.face_normal = side * flat;
  sample.normal = side * smooth;
  if (!materials_.empty()) {
    const Material& material =
        materials_[face_material_.empty() ? 0 : std::size_t{face_material_[hit.face]}];
    sample.reflectance =
        evaluate(material, R_mesh_world_ * point + t_mesh_world_, R_mesh_world_ * smooth);
    sample.gloss = static_cast<float>(material.gloss);
  } else if (corner_colors_.empty()) {
    sample.reflectance = linearFromSrgb(kGrey);
  } else {
    sample.reflectance.setZero();
    for (std::size_t i = 0; i < 3; ++i) {
      sample.reflectance +=
          weights[i] * linearFromSrgb(corner_colors_[3 * std::size_t{hit.face} + i]);
    }
  }
  return sample;
}

}  // namespace hydrabench
