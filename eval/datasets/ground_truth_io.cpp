// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/ground_truth_io.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/config/config_value.h"
#include "core/geometry/mesh_io.h"
#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

constexpr const char* kObjectsFile = "objects.yaml";
constexpr const char* kSceneFile = "scene.ply";
constexpr const char* kTrajectoryFile = "trajectory.txt";

std::string numbers(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string poseNumbers(const Transform& pose) {
  std::string text = "[";
  for (int i = 0; i < 12; ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", pose(i / 4, i % 4));
  }
  return text + "]";
}

std::string meshFile(std::size_t index) { return fmt::format("meshes/{:04d}.ply", index); }

std::string objectsYaml(const GroundTruth& ground_truth) {
  std::string yaml = ground_truth.rooms.empty() ? "rooms: []\n" : "rooms:\n";
  for (const Room& room : ground_truth.rooms) {
    yaml += fmt::format("  - {{name: {}, min_m: {}, max_m: {}}}\n", yamlText(room.name),
                        numbers(room.box.min()), numbers(room.box.max()));
  }
  yaml += ground_truth.objects.empty() ? "objects: []\n" : "objects:\n";
  for (std::size_t i = 0; i < ground_truth.objects.size(); ++i) {
    const GroundTruthObject& object = ground_truth.objects[i];
    yaml += fmt::format("  - id: {}\n    label: {}\n    name: {}\n    subtype: {}\n    room: {}\n",
                        object.id, object.label, yamlText(object.name), yamlText(object.subtype),
                        yamlText(object.room));
    yaml += fmt::format("    scored: {}\n    visible_fraction: {}\n    mesh: {}\n", object.scored,
                        object.visible_fraction, meshFile(i));
    yaml += fmt::format("    T_world_object: {}\n", poseNumbers(object.T_world_object));
  }
  if (!ground_truth.scene_labels.empty()) yaml += "scene_labels:\n";
  for (std::size_t f = 0; f < ground_truth.scene_labels.size(); ++f) {
    const Label label = ground_truth.scene_labels[f];
    if (f > 0 && label == ground_truth.scene_labels[f - 1]) continue;
    yaml += fmt::format("  - {{first_face: {}, label: {}}}\n", f, label);
  }
  return yaml;
}

Room readRoom(ConfigReader& reader) {
  Room room;
  std::vector<double> low, high;
  for (const char* key : {"name", "min_m", "max_m"}) reader.require(key);
  reader.field("name", room.name);
  reader.field("min_m", low);
  reader.field("max_m", high);
  if (low.size() != 3 || high.size() != 3) {
    reader.fault("min_m", "min_m and max_m take three numbers each");
  } else {
    room.box =
        Aabb(Eigen::Vector3d(low[0], low[1], low[2]), Eigen::Vector3d(high[0], high[1], high[2]));
  }
  return room;
}

/// The label of all faces from one on.
struct LabelRun {
  std::uint64_t first_face = 0;
  Label label = kUnknownLabel;
};

LabelRun readLabelRun(ConfigReader& reader, const std::vector<LabelRun>& before) {
  LabelRun run;
  for (const char* key : {"first_face", "label"}) reader.require(key);
  reader.field("first_face", run.first_face);
  reader.field("label", run.label, {0, 65535});
  if (before.empty() ? run.first_face != 0 : run.first_face <= before.back().first_face) {
    reader.fault("first_face", fmt::format("{}, expected 0 for the first and more for each after",
                                           run.first_face));
  }
  return run;
}

/// @param runs  as readLabelRun() has them
std::vector<Label> labelsOf(const std::vector<LabelRun>& runs, std::size_t num_faces,
                            const fs::path& folder) {
  if (runs.empty()) return {};
  if (runs.back().first_face >= num_faces) {
    throw InputError(fmt::format("{}: scene_labels: first_face {}, but {} has {} faces",
                                 (folder / kObjectsFile).string(), runs.back().first_face,
                                 kSceneFile, num_faces));
  }
  std::vector<Label> labels(num_faces);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t end = r + 1 < runs.size() ? runs[r + 1].first_face : num_faces;
    std::fill(labels.begin() + static_cast<std::ptrdiff_t>(runs[r].first_face),
              labels.begin() + static_cast<std::ptrdiff_t>(end), runs[r].label);
  }
  return labels;
}

GroundTruthObject readObject(ConfigReader& reader, fs::path& mesh, std::set<ObjectId>& ids) {
  GroundTruthObject object;
  std::vector<double> pose;
  for (const char* key : {"id", "label", "mesh", "T_world_object"}) reader.require(key);
  reader.field("id", object.id);
  reader.field("label", object.label, {0, 65535});
  reader.field("name", object.name);
  reader.field("subtype", object.subtype);
  reader.field("room", object.room);
  reader.field("scored", object.scored);
  reader.field("visible_fraction", object.visible_fraction, {0, 1});
  reader.path("mesh", mesh);
  reader.field("T_world_object", pose);
  if (!ids.insert(object.id).second) {
    reader.fault("id", fmt::format("{} is the id of an earlier object", object.id));
  }
  if (pose.size() != 12) {
    reader.fault("T_world_object", "expected 12 numbers, the upper 3 x 4 row by row");
    return object;
  }
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < 12; ++i) {
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = pose[i];
  }
  try {
    object.T_world_object = checkedPose(matrix, object.name);
  } catch (const InputError& error) {
    reader.fault("T_world_object", error.what());
  }
  return object;
}

}  // namespace

void writeGroundTruth(const fs::path& folder, const GroundTruth& ground_truth) {
  writeFileAtomic(folder / kObjectsFile, objectsYaml(ground_truth));
  parallelFor(ground_truth.objects.size(), [&](std::size_t i) {
    const auto& mesh = ground_truth.objects[i].mesh;
    writeMesh(folder / meshFile(i), mesh ? *mesh : Mesh{});
  });
  if (!ground_truth.scene_mesh.vertices.empty()) {
    writeMesh(folder / kSceneFile, ground_truth.scene_mesh);
  }
  writePoses(folder / kTrajectoryFile, ground_truth.trajectory);
}

GroundTruth readGroundTruth(const fs::path& folder) {
  GroundTruth ground_truth;
  std::vector<fs::path> meshes;
  ConfigReader reader(ConfigDocument::fromFile(folder / kObjectsFile));
  std::set<ObjectId> ids;
  for (ConfigReader& room : reader.list("rooms")) ground_truth.rooms.push_back(readRoom(room));
  std::vector<LabelRun> label_runs;
  for (ConfigReader& run : reader.list("scene_labels")) {
    label_runs.push_back(readLabelRun(run, label_runs));
  }
  for (ConfigReader& object : reader.list("objects")) {
    ground_truth.objects.push_back(readObject(object, meshes.emplace_back(), ids));
  }
  if (ground_truth.objects.empty()) {
    reader.fault("objects",
                 "empty ground truth, expected at least one object (without any, leave the folder "
                 "out)");
  }
  reader.finish();
  parallelFor(meshes.size(), [&](std::size_t i) {
    ground_truth.objects[i].mesh = std::make_shared<const Mesh>(readMesh(meshes[i]));
  });
  if (fs::exists(folder / kSceneFile)) ground_truth.scene_mesh = readMesh(folder / kSceneFile);
  ground_truth.scene_labels = labelsOf(label_runs, ground_truth.scene_mesh.faces.size(), folder);
  if (fs::exists(folder / kTrajectoryFile)) {
    ground_truth.trajectory = readPoses(folder / kTrajectoryFile);
  }
  return ground_truth;
}

}  // namespace hydrabench
