// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/world_picture.h"

#include <algorithm>
#include <numbers>

#include "eval/simulation/contact_sheet.h"
#include "eval/simulation/preview_renderer.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

PreviewObject plainObject(Mesh mesh, const Transform& T_world_mesh, Rgb color) {
  PreviewObject object;
  object.mesh = std::move(mesh);
  object.T_world_mesh = T_world_mesh;
  object.color = color;
  return object;
}

PreviewObject surfaceObject(const Surface& surface, const Transform& T_world_mesh) {
  PreviewObject object = plainObject(surface.mesh, T_world_mesh, {190, 190, 190});
  object.materials = surface.materials;
  object.face_material = surface.face_material;
  if (!object.materials.empty() && object.face_material.empty()) {
    object.face_material.assign(object.mesh.faces.size(), 0);
  }
  return object;
}

std::vector<PreviewObject> sceneObjects(const Scene& scene) {
  std::vector<PreviewObject> objects;
  for (const StructurePart& part : scene.structure) {
    if (!part.overhead) objects.push_back(surfaceObject(part.surface, Transform::Identity()));
  }
  for (const SceneObject& object : scene.objects) {
    objects.push_back(surfaceObject(*object.surface, object.T_world_object));
  }
  return objects;
}

Rgb colorOf(Label label, const LabelSpace& label_space) {
  const LabelSpace::Entry* entry = label_space.find(label);
  return entry ? entry->color : Rgb{170, 170, 170};
}

Image<Rgb> fromAbove(const std::vector<PreviewObject>& objects, const PictureSize& size) {
  Aabb box;
  for (const PreviewObject& object : objects) {
    for (const Eigen::Vector3d& vertex : object.mesh.vertices)
      box.extend(object.T_world_mesh * vertex);
  }
  if (box.isEmpty()) return Image<Rgb>(size.width, size.height, PreviewStyle{}.background);
  PreviewStyle style;
  style.floor_z_m = box.min().z() - 0.02;
  style.to_light =
      Eigen::Vector3d(0.12, -0.25, 1.0);  // steep, so that walls leave the rooms in the light
  const Camera camera = previewCamera(size.width, size.height, 30 * kDegrees);
  return renderPreview(objects, camera,
                       previewPose(box, camera, -75 * kDegrees, 60 * kDegrees, 1.0), style);
}

/// Every vertex moved outwards along the mean normal of its faces.
Mesh inflated(Mesh mesh, double distance) {
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& face : mesh.faces) {
    const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(face[0])];
    const Eigen::Vector3d normal = (mesh.vertices[static_cast<std::size_t>(face[1])] - a)
                                       .cross(mesh.vertices[static_cast<std::size_t>(face[2])] - a);
    for (const int i : face) normals[static_cast<std::size_t>(i)] += normal;
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    mesh.vertices[i] += distance * normals[i].normalized();
  }
  return mesh;
}

/// Objects, each in a picture of its own with its name below.
class ObjectTiles {
 public:
  void add(const PreviewObject& object, const std::string& name) {
    const Aabb box = bounds(object.mesh);
    PreviewStyle style;
    style.floor_z_m = box.min().z();
    tiles_.push_back(renderPreview(
        {object}, camera_, previewPose(box, camera_, 35 * kDegrees, 22 * kDegrees, 1.15), style));
    constexpr std::size_t kLongest = 20;  // what fits below a tile
    names_.push_back(name.size() <= kLongest
                         ? name
                         : name.substr(0, kLongest - 6) + ".." + name.substr(name.size() - 4));
  }
  std::size_t size() const { return tiles_.size(); }
  Image<Rgb> picture() const {
    constexpr int kColumns = 8;
    return tiled(tiles_, names_, kColumns, PreviewStyle{}.background);
  }

 private:
  static constexpr int kTile = 220;
  Camera camera_ = previewCamera(kTile, kTile, 25 * kDegrees);
  std::vector<Image<Rgb>> tiles_;
  std::vector<std::string> names_;
};

}  // namespace

Image<Rgb> worldPicture(const Dataset& dataset, const PictureSize& size) {
  if (const auto* simulated = dynamic_cast<const SimulatedDataset*>(&dataset)) {
    return fromAbove(sceneObjects(simulated->scene()), size);
  }
  std::vector<PreviewObject> objects;
  const GroundTruth& truth = dataset.groundTruth();
  for (const GroundTruthObject& object : truth.objects) {
    objects.push_back(plainObject(*object.mesh, object.T_world_object,
                                  colorOf(object.label, dataset.labelSpace())));
  }
  if (objects.empty())
    objects.push_back(plainObject(truth.scene_mesh, Transform::Identity(), {190, 190, 190}));
  return fromAbove(objects, size);
}

Image<Rgb> predictionPicture(const SceneGraph& graph, const PictureSize& size) {
  constexpr double kLift = 0.015;  // [m], clear of a scene mesh that holds the same surface
  std::vector<PreviewObject> objects;
  if (!graph.scene_mesh.empty()) {
    objects.push_back(plainObject(graph.scene_mesh, Transform::Identity(), {200, 200, 200}));
    objects.back().mesh.colors.clear();
  }
  for (const ObjectNode& node : graph.objects) {
    const bool has_mesh = !node.mesh.empty();
    if (!has_mesh && node.box.isEmpty()) continue;
    objects.push_back(plainObject(has_mesh ? inflated(node.mesh, kLift) : boxMesh(node.box),
                                  Transform::Identity(), colorOf(node.label, graph.label_space)));
    objects.back().mesh.colors.clear();
  }
  return fromAbove(objects, size);
}

Image<Rgb> sceneMeshPicture(const SceneGraph& graph, const PictureSize& size) {
  PreviewObject scene = plainObject(graph.scene_mesh, Transform::Identity(), {200, 200, 200});
  // What only a lidar saw has no colour: there the class shows, or grey.
  for (std::size_t i = 0; i < scene.mesh.colors.size(); ++i) {
    if (scene.mesh.colors[i] != Rgb{}) continue;
    const bool known = !graph.scene_labels.empty() && graph.scene_labels[i] != kUnknownLabel;
    scene.mesh.colors[i] =
        known ? colorOf(graph.scene_labels[i], graph.label_space) : Rgb{170, 170, 170};
  }
  return fromAbove({scene}, size);
}

Image<Rgb> objectSheet(const SceneGraph& graph, std::size_t count) {
  ObjectTiles tiles;
  for (const ObjectNode& node : graph.objects) {
    if (node.mesh.empty() || tiles.size() == count) continue;
    tiles.add(plainObject(node.mesh, Transform::Identity(), colorOf(node.label, graph.label_space)),
              graph.label_space.nameOf(node.label) + " " +
                  std::to_string(node.id & ((ObjectId{1} << 56) - 1)));
  }
  return tiles.picture();
}

Image<Rgb> objectSheet(const Dataset& dataset, std::size_t count) {
  std::vector<const GroundTruthObject*> chosen;
  for (const GroundTruthObject& object : dataset.groundTruth().objects) {
    if (object.scored && chosen.size() < count) chosen.push_back(&object);
  }
  // A generated object is drawn with its materials.
  const auto* simulated = dynamic_cast<const SimulatedDataset*>(&dataset);
  ObjectTiles tiles;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    PreviewObject object = plainObject(*chosen[i]->mesh, Transform::Identity(),
                                       colorOf(chosen[i]->label, dataset.labelSpace()));
    if (simulated) {
      for (const SceneObject& candidate : simulated->scene().objects) {
        if (candidate.name == chosen[i]->name)
          object = surfaceObject(*candidate.surface, Transform::Identity());
      }
    }
    tiles.add(object, chosen[i]->name);
  }
  return tiles.picture();
}

}  // namespace hydrabench
