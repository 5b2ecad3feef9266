// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/mesh_gallery.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/geometry/mesh_io.h"
#include "core/types/error.h"
#include "eval/datasets/dataset_config.h"
#include "eval/simulation/office_labels.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

constexpr double kMargin_m = 1;  ///< between the camera's way and the walls
constexpr double kWallHeight_m = 3;
constexpr double kWall_m = 0.1;  ///< thickness
constexpr double kLampHeight_m = 3.5;
constexpr double kLampIntensity = 6;
constexpr Label kFirstAddedLabel = 100;  ///< beyond those of the office
constexpr std::int64_t kFramePeriod_ns = 100'000'000;

/// The office's classes, all objects scored, and the others that are named.
LabelSpace galleryLabels(const std::vector<MeshGalleryConfig::Item>& items) {
  LabelSpace labels = officeLabelSpace(true);
  for (const MeshGalleryConfig::Item& item : items) {
    if (labels.find(std::string_view(item.label))) continue;
    const auto added = static_cast<Label>(labels.entries.size());
    labels.entries.push_back({kFirstAddedLabel + added,
                              item.label,
                              {200, static_cast<std::uint8_t>(40 * added % 256), 160},
                              true,
                              true});
  }
  return labels;
}

/// Of the camera from the middle of a mesh [m].
double viewDistance(const Aabb& box, const MeshGalleryConfig& config) {
  return std::max(config.min_distance_m, config.distance_factor * box.diagonal().norm());
}

Material plain(Rgb color) {
  Material material;
  material.color = material.second_color = color;
  return material;
}

/// Every mesh in a room of its own: no other is seen, and there is something behind it.
StructurePart wallsAround(const std::vector<Room>& rooms) {
  StructurePart walls;
  walls.name = "walls";
  walls.label = office_label::kWall;
  walls.surface.materials.push_back(plain({196, 200, 198}));
  for (const Room& room : rooms) {
    const Eigen::Vector3d low(room.box.min().x(), room.box.min().y(), 0);
    const Eigen::Vector3d high(room.box.max().x(), room.box.max().y(), kWallHeight_m);
    for (int axis = 0; axis < 2; ++axis) {
      Aabb near(low, high);
      near.max()[axis] = low[axis] + kWall_m;
      Aabb far(low, high);
      far.min()[axis] = high[axis] - kWall_m;
      appendBox(near, 0, walls.surface);
      appendBox(far, 0, walls.surface);
    }
  }
  roundToFloat(walls.surface.mesh);
  return walls;
}

}  // namespace

void read(ConfigReader& reader, MeshGalleryConfig& config) {
  reader.require("meshes");
  for (ConfigReader& item : reader.list("meshes")) {
    MeshGalleryConfig::Item& entry = config.items.emplace_back();
    item.require("file");
    item.field("file", entry.file);
    item.require("label");
    item.field("label", entry.label);
  }
  auto views = reader.section("views");
  views.field("per_mesh", config.views, {1, 1000});
  views.field("distance_factor", config.distance_factor, {0.6, 20});
  views.field("min_distance_m", config.min_distance_m, {0.1, 100});
  views.field("camera_height_m", config.camera_height_m, {0, 100});
  views.field("min_elevation_deg", config.min_elevation_deg, {0, 80});
}

Scene makeMeshGalleryScene(const MeshGalleryConfig& config) {
  Scene scene;
  scene.label_space = galleryLabels(config.items);
  double x = 0;
  Aabb floor;
  for (std::size_t i = 0; i < config.items.size(); ++i) {
    const MeshGalleryConfig::Item& item = config.items[i];
    const fs::path file = config.folder / item.file;
    auto surface = std::make_shared<Surface>();
    surface->mesh = readMesh(file);
    if (surface->mesh.empty()) {
      throw InputError(fmt::format("{}: no triangles, expected a mesh", file.string()));
    }
    surface->mesh.colors.clear();
    roundToFloat(surface->mesh);
    // Different greys: the colour of a thing should not give away its shape.
    const auto grey = static_cast<std::uint8_t>(110 + 35 * (i % 4));
    surface->materials.push_back(plain({grey, grey, static_cast<std::uint8_t>(grey - 15)}));
    const Aabb box = bounds(surface->mesh);
    const double half = viewDistance(box, config) + kMargin_m;
    x += half;

    SceneObject object;
    object.subtype = file.stem().string();
    object.name = object.subtype;
    object.label = scene.label_space.find(std::string_view(item.label))->label;
    object.scored = true;
    object.T_world_object.translation() =
        Eigen::Vector3d(x - box.center().x(), -box.center().y(), -box.min().z());
    object.surface = surface;
    object.room = object.name;
    scene.objects.push_back(std::move(object));

    Room room;
    room.name = scene.objects.back().name;
    room.box = Aabb(Eigen::Vector3d(x - half, -half, -0.1), Eigen::Vector3d(x + half, half, 10));
    floor.extend(room.box);
    scene.rooms.push_back(room);
    Lamp lamp;
    lamp.position = {x - 1.5, 1.0, kLampHeight_m + box.sizes().z()};
    lamp.intensity = kLampIntensity;
    lamp.room = static_cast<int>(i);
    scene.lamps.push_back(lamp);
    x += half;
  }
  if (scene.objects.empty()) return scene;
  StructurePart ground;
  ground.name = "floor";
  ground.label = office_label::kFloor;
  ground.surface.materials.push_back(plain({150, 140, 125}));
  Aabb slab = floor;
  slab.max().z() = 0;
  appendBox(slab, 0, ground.surface);
  roundToFloat(ground.surface.mesh);
  scene.structure.push_back(std::move(ground));
  scene.structure.push_back(wallsAround(scene.rooms));
  return scene;
}

std::vector<StampedPose> makeGalleryTrajectory(const Scene& scene,
                                               const MeshGalleryConfig& config) {
  std::vector<StampedPose> poses;
  for (const SceneObject& object : scene.objects) {
    const Aabb box = worldBounds(object);
    const Eigen::Vector3d middle = box.center();
    const double distance = viewDistance(box, config);
    const double lowest =
        middle.z() + distance * std::sin(config.min_elevation_deg * std::numbers::pi / 180);
    const double rise =
        std::min(std::max(config.camera_height_m, lowest) - middle.z(), 0.95 * distance);
    const double radius = std::sqrt(distance * distance - rise * rise);
    for (int i = 0; i < config.views; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / config.views;
      const Eigen::Vector3d eye =
          middle + Eigen::Vector3d(radius * std::cos(azimuth), radius * std::sin(azimuth), rise);
      poses.push_back(
          {static_cast<std::int64_t>(poses.size()) * kFramePeriod_ns, lookAt(eye, middle)});
    }
  }
  return poses;
}

DatasetConfig readMeshGallery(ConfigReader& reader, const fs::path&) {
  MeshGalleryConfig gallery;
  std::string name = "mesh_gallery";
  std::string folder;
  std::string preset = "default";
  std::uint64_t seed = 1;
  const fs::path root = readDataRoot(reader);
  reader.field("name", name);
  reader.require("folder");
  reader.field("folder", folder);
  reader.choice("preset", preset, {"clean", "default", "hard"});
  reader.field("seed", seed);
  read(reader, gallery);
  SimulatedConfig config = SimulatedConfig::forWorld("office", preset);
  read(reader, config.sensor);
  ConfigReader odometry = reader.section("odometry");
  read(odometry, config.odometry);
  requireFolder(reader, "folder", root, root / folder);
  if (gallery.items.empty()) reader.fault("meshes", "empty, expected at least one mesh");
  reader.finish();

  gallery.folder = root / folder;
  return {.name = name, .seed = seed, .generated = true, .files = {gallery.folder}, .open = [=] {
            const auto scene = std::make_shared<const Scene>(makeMeshGalleryScene(gallery));
            return std::make_unique<SimulatedDataset>(name, scene,
                                                      makeGalleryTrajectory(*scene, gallery),
                                                      config.sensor, config.odometry, seed);
          }};
}

}  // namespace hydrabench
