// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/placed_meshes_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/geometry/mesh_io.h"
#include "core/io/json_field.h"
#include "eval/datasets/json_pose.h"
#include "eval/simulation/office_labels.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

using Rule = PlacedMeshesConfig::Rule;

Rgb readMeanColor(const JsonField& field) {
  const Eigen::Vector3d rgb = field.vector3();
  if (rgb.minCoeff() < 0 || rgb.maxCoeff() > 1) field.fail("three numbers from 0 to 1");
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(std::lround(value * 255));
  };
  return {channel(rgb[0]), channel(rgb[1]), channel(rgb[2])};
}

const Rule& findRule(const std::vector<Rule>& rules, const JsonField& instance) {
  const std::string name = instance.at("name").text();
  const std::string class_name = instance.at("class").text();
  const Rule* found = nullptr;
  for (const Rule& rule : rules) {
    if (!rule.name.empty() && rule.name == name) return rule;
    if (!found && !rule.class_name.empty() && rule.class_name == class_name) found = &rule;
  }
  if (!found) instance.at("class").fail("a class of the key classes in the config");
  return *found;
}

std::string roomOf(const std::vector<Room>& rooms, const Eigen::Vector3d& point) {
  for (const Room& room : rooms) {
    if (room.box.contains(point)) return room.name;
  }
  return "";
}

/// The same file serves many instances; each combination of file and colour is read once.
class SurfaceCache {
 public:
  explicit SurfaceCache(fs::path folder) : folder_(std::move(folder)) {}
  std::shared_ptr<const Surface> get(const std::string& file, const Rgb& color) {
    auto& surface = surfaces_[{file, {color.r, color.g, color.b}}];
    if (!surface) {
      auto fresh = std::make_shared<Surface>();
      fresh->mesh = readMesh(folder_ / file);
      fresh->mesh.colors.clear();
      roundToFloat(fresh->mesh);
      Material material;
      material.color = material.second_color = color;
      fresh->materials.push_back(material);
      surface = std::move(fresh);
    }
    return surface;
  }

 private:
  fs::path folder_;
  std::map<std::pair<std::string, std::vector<int>>, std::shared_ptr<const Surface>> surfaces_;
};

void addLamps(const PlacedMeshesConfig& config, Scene& scene) {
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Aabb& box = scene.rooms[i].box;
    const auto count = [&](int axis) {
      return std::max(1, static_cast<int>(std::lround(box.sizes()[axis] / config.lamp_spacing_m)));
    };
    for (int column = 0; column < count(0); ++column) {
      for (int row = 0; row < count(1); ++row) {
        Lamp lamp;
        lamp.position = {box.min().x() + box.sizes().x() * (column + 0.5) / count(0),
                         box.min().y() + box.sizes().y() * (row + 0.5) / count(1),
                         config.lamp_height_m};
        lamp.intensity = config.lamp_intensity;
        lamp.room = static_cast<int>(i);
        scene.lamps.push_back(lamp);
      }
    }
  }
}

}  // namespace

void read(ConfigReader& reader, PlacedMeshesConfig& config) {
  const LabelSpace label_space = officeLabelSpace(false);
  std::vector<std::string> labels;
  for (const LabelSpace::Entry& entry : label_space.entries) labels.push_back(entry.name);
  reader.require("classes");
  for (ConfigReader& item : reader.list("classes")) {
    Rule rule;
    rule.label = "unknown";
    item.field("class", rule.class_name);
    item.field("name", rule.name);
    item.choice("label", rule.label, labels);
    item.field("structure", rule.structure);
    if (rule.class_name.empty() == rule.name.empty()) {
      item.fault("label", "expected either the key class or the key name beside it");
    }
    config.rules.push_back(rule);
  }
  reader.require("rooms");
  for (ConfigReader& item : reader.list("rooms")) {
    Room room;
    std::vector<double> low, high;
    item.field("name", room.name);
    item.field("min_m", low);
    item.field("max_m", high);
    if (low.size() != 3 || high.size() != 3) {
      item.fault("min_m", "min_m and max_m take three numbers each");
      continue;
    }
    room.box =
        Aabb(Eigen::Vector3d(low[0], low[1], low[2]), Eigen::Vector3d(high[0], high[1], high[2]));
    if (room.box.isEmpty()) item.fault("max_m", "expected to lie above min_m in every axis");
    config.rooms.push_back(room);
  }
  ConfigReader lamps = reader.section("lamps");
  lamps.field("height_m", config.lamp_height_m, {0, 100});
  lamps.field("spacing_m", config.lamp_spacing_m, {0.5, 100});
  lamps.field("intensity", config.lamp_intensity, {0, 1000});
}

Scene makePlacedMeshesScene(const PlacedMeshesConfig& config) {
  const nlohmann::json json = parseJsonFile(config.scene);
  const JsonField root(json, config.scene.string() + ": ");
  Scene scene;
  scene.label_space = officeLabelSpace(false);
  scene.rooms = config.rooms;
  SurfaceCache surfaces(config.scene.parent_path());

  const JsonField instances = root.at("instances");
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const JsonField instance = instances.item(i);
    const Rule& rule = findRule(config.rules, instance);
    const LabelSpace::Entry& entry = *scene.label_space.find(std::string_view(rule.label));
    const Transform T_world_object = readPose(instance.at("T_world_object"));
    const auto surface =
        surfaces.get(instance.at("mesh").text(), readMeanColor(instance.at("mean_rgb")));
    const std::string name = instance.at("name").text();

    if (rule.structure || instance.at("is_structure").boolean()) {
      StructurePart part;
      part.name = name;
      part.label = entry.label;
      part.surface = *surface;
      part.surface.mesh = transformed(T_world_object, surface->mesh);
      roundToFloat(part.surface.mesh);
      part.overhead = entry.label == office_label::kCeiling;
      scene.structure.push_back(std::move(part));
      continue;
    }
    SceneObject object;
    object.name = name;
    if (const auto model = instance.find("model")) object.subtype = model->text();
    object.label = entry.label;
    object.scored = entry.is_scored;
    object.T_world_object = T_world_object;
    object.surface = surface;
    object.room = roomOf(scene.rooms, worldBounds(object).center());
    scene.objects.push_back(std::move(object));
  }
  if (scene.objects.empty()) root.at("instances").complain("no objects among the instances");
  addLamps(config, scene);
  return scene;
}

}  // namespace hydrabench
