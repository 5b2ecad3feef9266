// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "core/geometry/box.h"
#include "core/graph/json_text.h"
#include "core/graph/spark_dsg_format.h"
#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using namespace spark_dsg;

void writeHeader(JsonText& json) {
  json.beginObject().member("project_name", "main").key("version").beginObject();
  json.member("major", 1).member("minor", 1).member("patch", 3).endObject().endObject();
}

void writeColor(JsonText& json, const Rgb& color) {
  json.beginObject().member("r", color.r).member("g", color.g).member("b", color.b);
  json.member("a", 255).endObject();
}

void writeRotation(JsonText& json, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  json.beginObject().member("w", q.w()).member("x", q.x()).member("y", q.y());
  json.member("z", q.z()).endObject();
}

void writeLayers(JsonText& json) {
  struct Layer {
    const char* name;
    int layer;
  };
  // Names share the number of their layer; agents stand in the partition of their robot ("a", 97)
  // beside the objects.
  const Layer layers[] = {
      {"OBJECTS", 2}, {"PLACES", 3}, {"ROOMS", 4}, {"BUILDINGS", 5}, {"AGENTS", 2}};
  const auto write = [&](int layer, int partition) {
    json.beginObject().member("layer", layer).member("partition", partition).endObject();
  };
  json.key("layer_keys").beginArray();
  for (const int layer : {2, 3, 4, 5}) write(layer, 0);
  write(2, 'a');
  json.endArray().key("layer_names").beginObject();
  for (const Layer& layer : layers) {
    json.key(layer.name);
    write(layer.layer, 0);
  }
  json.endObject();
}

void writeLabelSpace(JsonText& json, const LabelSpace& label_space) {
  json.key("metadata").beginObject();
  json.key("labelspaces").beginObject().key(kObjectsLabelSpace).beginArray();
  for (const LabelSpace::Entry& entry : label_space.entries) {
    json.beginArray().value(entry.label).value(entry.name).endArray();
  }
  json.endArray().endObject();
  json.key(kLabelSpaceKey).beginArray();
  for (const LabelSpace::Entry& entry : label_space.entries) {
    json.beginObject().member("label", entry.label).member("name", entry.name).key("color");
    writeColor(json, entry.color);
    json.member("is_object", entry.is_object).member("is_scored", entry.is_scored).endObject();
  }
  json.endArray().endObject();
}

/// Points relative to `center`, which must be zero for the scene mesh.
void writeMesh(JsonText& json, const Mesh& mesh, const Eigen::Vector3d& center,
               const std::vector<Label>& labels) {
  json.beginObject().key("header");
  writeHeader(json);
  json.member("has_colors", !mesh.colors.empty()).member("has_timestamps", false);
  json.member("has_labels", !labels.empty()).member("has_first_seen_stamps", false);
  json.key("points").beginArray();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    json.value(Eigen::Vector3d(vertex - center));
  }
  json.endArray();
  if (!mesh.colors.empty()) {
    json.key("colors").beginArray();
    for (const Rgb& color : mesh.colors) writeColor(json, color);
    json.endArray();
  }
  if (!labels.empty()) {
    json.key("labels").beginArray();
    for (const Label label : labels) json.value(label);
    json.endArray();
  }
  json.key("faces").beginArray();
  for (const Eigen::Vector3i& face : mesh.faces) json.value(face);
  json.endArray().endObject();
}

void writeRemainders(JsonText& json, const Mesh& mesh, const Eigen::Vector3d& center) {
  bool any = false;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double exact = mesh.vertices[i][axis];
      const double read_back = center[axis] + (exact - center[axis]);
      if (read_back == exact) continue;
      if (!any) json.key(kRemaindersKey).beginArray();
      any = true;
      json.beginArray().value(i).value(axis).value(exact - read_back).endArray();
    }
  }
  if (any) json.endArray();
}

void writeObject(JsonText& json, const ObjectNode& object, const LabelSpace& label_space) {
  const Aabb box = object.mesh.vertices.empty() ? object.box : bounds(object.mesh);
  const LabelSpace::Entry* entry = label_space.find(object.label);
  // The library knows a box of type INVALID, but Khronos then cannot place the mesh: an object
  // without extent is a point.
  const Eigen::Vector3d center =
      box.isEmpty() ? Eigen::Vector3d(object.T_world_object.translation()) : box.center();
  const Eigen::Vector3d dimensions =
      box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(box.sizes());

  json.newline().beginObject().member("id", object.id).member("layer", kObjectsLayer);
  json.member("partition", kObjectsPartition).key("attributes").beginObject();
  json.member("type", "KhronosObjectAttributes").member("position", center);
  json.member("last_update_time_ns", object.last_observed_ns);
  json.member("is_active", false).member("is_predicted", false).member("name", object.name);
  json.member("semantic_label", object.label).key("color");
  writeColor(json, entry ? entry->color : Rgb{});
  json.key("bounding_box").beginObject().member("type", box.isEmpty() ? "INVALID" : "AABB");
  json.member("dimensions", dimensions).member("world_P_center", center).key("world_R_center");
  writeRotation(json, Eigen::Matrix3d::Identity());
  json.endObject().member("registered", true).key("world_R_object");
  writeRotation(json, object.T_world_object.linear());
  json.key("first_observed_ns").beginArray().value(object.first_observed_ns).endArray();
  json.key("last_observed_ns").beginArray().value(object.last_observed_ns).endArray();

  json.key("metadata").beginObject().member(kScaleKey, object.scale).key(kPoseKey).beginArray();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) json.value(object.T_world_object(row, column));
  }
  json.endArray();
  writeRemainders(json, object.mesh, center);
  json.endObject();

  json.key("mesh");
  writeMesh(json, object.mesh, center, {});
  json.endObject().endObject();
}

bool allFinite(const Mesh& mesh) {
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return false;
  }
  return true;
}

/// JSON has no word for NaN: found here, at the method at fault, instead of when the file is read.
void check(const std::filesystem::path& path, const SceneGraph& graph) {
  std::set<ObjectId> ids;
  for (const ObjectNode& object : graph.objects) {
    const auto fail = [&](const char* fault) {
      throw InputError(fmt::format("{}: not written: object {} ({}) {}", path.string(), object.id,
                                   object.name, fault));
    };
    if (!ids.insert(object.id).second) fail("has the id of another object");
    if (!allFinite(object.mesh)) fail("has a mesh vertex that is not finite");
    if (!object.T_world_object.matrix().allFinite()) fail("has a pose that is not finite");
    if (!std::isfinite(object.scale)) fail("has a scale that is not finite");
    const Aabb& box = object.box;
    if (!box.isEmpty() && !(box.min().allFinite() && box.max().allFinite())) {
      fail("has a box that is not finite");
    }
  }
  if (!allFinite(graph.scene_mesh)) {
    throw InputError(fmt::format("{}: not written: the scene mesh has a vertex that is not finite",
                                 path.string()));
  }
}

}  // namespace

ObjectId objectNodeId(std::uint64_t index) {
  return (static_cast<std::uint64_t>('O') << 56) | index;
}

void writeSparkDsg(const std::filesystem::path& path, const SceneGraph& graph) {
  check(path, graph);
  JsonText json;
  json.beginObject().key(kHeader);
  writeHeader(json);
  json.member("directed", false).member("multigraph", false);
  writeLayers(json);
  writeLabelSpace(json, graph.label_space);
  json.newline().key("nodes").beginArray();
  for (const ObjectNode& object : graph.objects) writeObject(json, object, graph.label_space);
  json.endArray().newline().key("edges").beginArray().endArray();
  if (!graph.scene_mesh.vertices.empty()) {
    json.newline().key("mesh");
    writeMesh(json, graph.scene_mesh, Eigen::Vector3d::Zero(), graph.scene_labels);
  }
  json.endObject().newline();
  writeFileAtomic(path, json.text());
}

}  // namespace hydrabench
