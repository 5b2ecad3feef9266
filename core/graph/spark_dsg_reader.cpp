// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <map>
#include <unordered_set>

#include <Eigen/Geometry>

#include "core/graph/spark_dsg_format.h"
#include "core/graph/spark_dsg_json.h"
#include "core/io/json_field.h"

namespace hydrabench {
namespace {

using namespace spark_dsg;
using Json = JsonField::Json;

constexpr std::uint64_t kMaxLabel = std::numeric_limits<Label>::max();

Label readLabel(const JsonField& field) {
  const std::uint64_t label = field.unsignedInteger("a label (an integer from 0 on)");
  if (label == kNoLabel) return kUnknownLabel;
  if (label > kMaxLabel) field.fail("a label below 2^31");
  return static_cast<Label>(label);
}

Rgb readColor(const JsonField& field) {
  const auto channel = [&](const char* key) {
    const JsonField value = field.at(key);
    const std::uint64_t number = value.unsignedInteger();
    if (number > 255) value.fail("0 to 255");
    return static_cast<std::uint8_t>(number);
  };
  return {channel("r"), channel("g"), channel("b")};
}

Eigen::Matrix3d readRotation(const JsonField& field) {
  const Eigen::Quaterniond q(field.at("w").number(), field.at("x").number(), field.at("y").number(),
                             field.at("z").number());
  if (std::abs(q.norm() - 1) > 1e-3) field.fail("a unit quaternion");
  return q.normalized().toRotationMatrix();
}

/// Reads one value per mesh vertex. Lists run to millions: `quick` handles a good value without
/// putting its place in words, and only where it declines does `careful` look again, to complain.
template <typename Value, typename Quick, typename Careful>
std::vector<Value> readPerVertex(const JsonField& list, std::size_t num_vertices, const char* what,
                                 const Quick& quick, const Careful& careful) {
  std::vector<Value> values;
  if (list.size() == 0) return values;
  if (list.size() != num_vertices) {
    list.complain(fmt::format("{} {} for {} points", list.size(), what, num_vertices));
  }
  values.reserve(num_vertices);
  list.forEach([&](std::size_t i, const Json& json) {
    const std::optional<Value> value = quick(json);
    values.push_back(value ? *value : careful(list.item(i)));
  });
  return values;
}

std::optional<Rgb> quickColor(const Json& json) {
  Rgb color;
  for (const auto& [key, channel] :
       {std::pair("r", &color.r), std::pair("g", &color.g), std::pair("b", &color.b)}) {
    const auto it = json.is_object() ? json.find(key) : json.end();
    if (!json.is_object() || it == json.end() || !it->is_number_unsigned()) return std::nullopt;
    const auto number = it->get<std::uint64_t>();
    if (number > 255) return std::nullopt;
    *channel = static_cast<std::uint8_t>(number);
  }
  return color;
}

std::optional<Label> quickLabel(const Json& json) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > kMaxLabel) return std::nullopt;
  return json.get<Label>();
}

/// The mesh as it is stored; the caller knows what its points are relative to.
Mesh readMesh(const JsonField& field, std::vector<Label>* labels = nullptr) {
  Mesh mesh;
  if (const auto points = field.find("points")) {
    mesh.vertices.reserve(points->size());
    points->forEach([&](std::size_t i, const Json& point) {
      // The common case is tested here, so that no place is put together for a million good points.
      if (point.is_array() && point.size() == 3 && point[0].is_number_float() &&
          point[1].is_number_float() && point[2].is_number_float()) {
        mesh.vertices.emplace_back(point[0].get<double>(), point[1].get<double>(),
                                   point[2].get<double>());
        if (mesh.vertices.back().allFinite()) return;
        mesh.vertices.pop_back();
      }
      mesh.vertices.push_back(points->item(i).vector3());
    });
  }
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  if (const auto faces = field.find("faces")) {
    mesh.faces.reserve(faces->size());
    faces->forEach([&](std::size_t i, const Json& face) {
      if (!face.is_array() || face.size() != 3) faces->item(i).fail("three indices");
      Eigen::Vector3i corners;
      for (int corner = 0; corner < 3; ++corner) {
        const Json& index = face[static_cast<std::size_t>(corner)];
        if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= mesh.vertices.size()) {
          faces->item(i)
              .item(static_cast<std::size_t>(corner))
              .fail(fmt::format("the index of one of the {} points", count));
        }
        corners[corner] = index.get<int>();
      }
      mesh.faces.push_back(corners);
    });
  }
  if (const auto colors = field.find("colors")) {
    mesh.colors =
        readPerVertex<Rgb>(*colors, mesh.vertices.size(), "colours", quickColor, readColor);
  }
  const auto label_list = field.find("labels");
  if (labels && label_list) {
    *labels =
        readPerVertex<Label>(*label_list, mesh.vertices.size(), "labels", quickLabel, readLabel);
  }
  return mesh;
}

struct Box {
  Transform T_world_box = Transform::Identity();
  Eigen::Vector3d dimensions = Eigen::Vector3d::Zero();
  bool valid = false;
};

Box readBox(const JsonField& field) {
  Box box;
  const std::string type = field.at("type").text();
  if (type != "INVALID" && type != "AABB" && type != "OBB" && type != "RAABB") {
    field.at("type").fail("INVALID, AABB, OBB or RAABB");
  }
  box.valid = type != "INVALID";
  if (!box.valid && !field.has("world_P_center")) return box;
  box.T_world_box.translation() = field.at("world_P_center").vector3();
  box.T_world_box.linear() = readRotation(field.at("world_R_center"));
  box.dimensions = field.at("dimensions").vector3();
  if (box.valid && box.dimensions.minCoeff() < 0) field.at("dimensions").fail("lengths from 0 on");
  return box;
}

Aabb axisAligned(const Box& box) {
  const Eigen::Vector3d half = box.T_world_box.linear().cwiseAbs() * (box.dimensions / 2);
  const Eigen::Vector3d center = box.T_world_box.translation();
  return Aabb(Eigen::Vector3d(center - half), Eigen::Vector3d(center + half));
}

/// Hydra keeps no mesh per object but the indices of its vertices in the scene mesh: the object is
/// made of the faces all of whose corners are listed.
Mesh connectedPart(const JsonField& connections, const Mesh& scene) {
  std::vector<int> part_index(scene.vertices.size(), -1);
  Mesh part;
  connections.forEach([&](std::size_t i, const Json&) {
    const std::uint64_t vertex = connections.item(i).unsignedInteger("the index of a scene vertex");
    if (vertex >= scene.vertices.size()) {
      connections.item(i).fail(fmt::format("the index of one of the {} points of the scene mesh",
                                           scene.vertices.size()));
    }
    if (part_index[vertex] >= 0) return;
    part_index[vertex] = static_cast<int>(part.vertices.size());
    part.vertices.push_back(scene.vertices[vertex]);
    if (!scene.colors.empty()) part.colors.push_back(scene.colors[vertex]);
  });
  for (const Eigen::Vector3i& face : scene.faces) {
    const Eigen::Vector3i corners(part_index[static_cast<std::size_t>(face[0])],
                                  part_index[static_cast<std::size_t>(face[1])],
                                  part_index[static_cast<std::size_t>(face[2])]);
    if (corners.minCoeff() >= 0) part.faces.push_back(corners);
  }
  return part;
}

std::int64_t readStamp(const JsonField& attributes, const char* key, bool latest) {
  const auto stamps = attributes.find(key);
  if (!stamps || stamps->size() == 0) return 0;
  std::int64_t result = stamps->item(0).integer();
  for (std::size_t i = 1; i < stamps->size(); ++i) {
    const std::int64_t stamp = stamps->item(i).integer();
    result = latest ? std::max(result, stamp) : std::min(result, stamp);
  }
  return result;
}

/// What only our own writer leaves: exact pose, scale, and what rounding took from the vertices.
void readOwnMetadata(const JsonField& metadata, ObjectNode& object) {
  if (const auto scale = metadata.find(kScaleKey)) object.scale = scale->number();
  if (const auto pose = metadata.find(kPoseKey)) {
    if (pose->size() != 12) pose->fail("12 numbers");
    for (std::size_t i = 0; i < 12; ++i) {
      object.T_world_object(static_cast<int>(i / 4), static_cast<int>(i % 4)) =
          pose->item(i).number();
    }
  }
  const auto remainders = metadata.find(kRemaindersKey);
  for (std::size_t i = 0; remainders && i < remainders->size(); ++i) {
    const JsonField entry = remainders->item(i);
    if (entry.size() != 3) entry.fail("[vertex, axis, difference]");
    const std::uint64_t vertex = entry.item(0).unsignedInteger();
    const std::uint64_t axis = entry.item(1).unsignedInteger();
    if (vertex >= object.mesh.vertices.size() || axis > 2) entry.complain("no such vertex or axis");
    object.mesh.vertices[vertex][static_cast<int>(axis)] += entry.item(2).number();
  }
}

ObjectNode readObject(ObjectId id, const JsonField& attributes, const Mesh& scene) {
  const std::string type = attributes.at("type").text();
  if (type != "KhronosObjectAttributes" && type != "ObjectNodeAttributes") {
    attributes.at("type").fail("KhronosObjectAttributes or ObjectNodeAttributes");
  }
  ObjectNode object;
  object.id = id;
  if (const auto name = attributes.find("name")) object.name = name->text();
  if (const auto label = attributes.find("semantic_label")) object.label = readLabel(*label);
  object.T_world_object.translation() = attributes.at("position").vector3();
  if (const auto rotation = attributes.find("world_R_object")) {
    object.T_world_object.linear() = readRotation(*rotation);
  }
  object.first_observed_ns = readStamp(attributes, "first_observed_ns", false);
  object.last_observed_ns = readStamp(attributes, "last_observed_ns", true);

  const Box box = readBox(attributes.at("bounding_box"));
  const auto connections = attributes.find("mesh_connections");
  if (const auto mesh = attributes.find("mesh")) {
    object.mesh = readMesh(*mesh);
    const Eigen::Vector3d center = box.T_world_box.translation();
    const bool turned = !box.T_world_box.linear().isIdentity(0);
    for (Eigen::Vector3d& vertex : object.mesh.vertices) {
      const Eigen::Vector3d rotated =
          turned ? Eigen::Vector3d(box.T_world_box.linear() * vertex) : vertex;
      vertex = center + rotated;
    }
  } else if (connections && !scene.vertices.empty()) {
    object.mesh = connectedPart(*connections, scene);
  }
  if (const auto metadata = attributes.find("metadata")) readOwnMetadata(*metadata, object);
  if (!object.mesh.vertices.empty()) {
    object.box = bounds(object.mesh);
  } else if (box.valid) {
    object.box = axisAligned(box);
  }
  return object;
}

struct LayerKey {
  std::int64_t layer = kObjectsLayer;
  std::int64_t partition = kObjectsPartition;
  friend bool operator==(const LayerKey&, const LayerKey&) = default;
};

LayerKey readLayerKey(const JsonField& field) {
  LayerKey key{field.at("layer").integer(), 0};
  if (const auto partition = field.find("partition")) key.partition = partition->integer();
  return key;
}

LabelSpace readLabelSpace(const JsonField& metadata, const LayerKey& objects) {
  LabelSpace label_space;
  if (const auto own = metadata.find(kLabelSpaceKey)) {
    for (std::size_t i = 0; i < own->size(); ++i) {
      const JsonField entry = own->item(i);
      label_space.entries.push_back({readLabel(entry.at("label")), entry.at("name").text(),
                                     readColor(entry.at("color")), entry.at("is_object").boolean(),
                                     entry.at("is_scored").boolean()});
    }
    return label_space;
  }
  const auto spaces = metadata.find("labelspaces");
  const auto names =
      spaces ? spaces->find(fmt::format("_l{}p{}", objects.layer, objects.partition).c_str())
             : std::nullopt;
  for (std::size_t i = 0; names && i < names->size(); ++i) {
    const JsonField pair = names->item(i);
    if (pair.size() != 2) pair.fail("[label, name]");
    label_space.entries.push_back({readLabel(pair.item(0)), pair.item(1).text(), {}, false, false});
  }
  return label_space;
}

/// "node 12345 (O7)"
std::string nodeName(std::uint64_t id) {
  const auto symbol = static_cast<char>(id >> 56);
  const bool printable = symbol > ' ' && symbol < 127;
  return printable ? fmt::format("node {} ({}{})", id, symbol, id & 0xffffffffffffffull)
                   : fmt::format("node {}", id);
}

}  // namespace

SceneGraph readSparkDsg(const std::filesystem::path& path) {
  const Json json = parseJsonFile(path);
  const JsonField root(json, path.string() + ": ");
  if (!root.has(kHeader)) {
    root.complain(fmt::format("no {}{}", kHeader,
                              root.has("layer_ids")
                                  ? ": the format before spark_dsg 1.1; load and save it once there"
                                  : ", expected a scene graph of spark_dsg 1.1"));
  }
  SceneGraph graph;
  if (const auto mesh = root.find("mesh")) graph.scene_mesh = readMesh(*mesh, &graph.scene_labels);

  LayerKey objects;
  if (const auto names = root.find("layer_names")) {
    if (const auto key = names->find("OBJECTS")) objects = readLayerKey(*key);
  }
  if (const auto metadata = root.find("metadata")) {
    graph.label_space = readLabelSpace(*metadata, objects);
  }
  const bool own_label_space = root.has("metadata") && root.at("metadata").has(kLabelSpaceKey);

  const JsonField nodes = root.at("nodes");
  std::unordered_set<std::uint64_t> ids;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const JsonField entry = nodes.item(i);
    const std::uint64_t id = entry.at("id").unsignedInteger("a 64-bit integer");
    const JsonField node = entry.renamed(fmt::format("{}: {}: ", path.string(), nodeName(id)));
    if (!ids.insert(id).second) {
      entry.at("id").complain(fmt::format("{} is in the file already", nodeName(id)));
    }
    if (readLayerKey(node) != objects) continue;
    graph.objects.push_back(readObject(id, node.at("attributes"), graph.scene_mesh));
    if (own_label_space) continue;
    // A foreign file does not say which classes are objects: those that occur as objects are, drawn
    // as the nodes are.
    for (LabelSpace::Entry& known : graph.label_space.entries) {
      if (known.label != graph.objects.back().label) continue;
      known.is_object = true;
      if (const auto color = node.at("attributes").find("color")) known.color = readColor(*color);
    }
  }
  return graph;
}

}  // namespace hydrabench
