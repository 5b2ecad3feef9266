// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/world_scene.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/graph/spark_dsg_json.h"
#include "core/parallel/parallel_for.h"
#include "eval/report/html/blob.h"
#include "eval/report/html/display_mesh.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPathPoints = 400;

Json number(double value) { return std::stod(fmt::format("{:.5g}", value)); }

Json vectorOf(const Eigen::Vector3d& v) { return {number(v.x()), number(v.y()), number(v.z())}; }

Json pieceOf(const BlobPool::Piece& piece) { return {piece.offset, piece.size}; }

Json meshOf(const PackedMesh& mesh, std::size_t offset) {
  return {{"at", offset},
          {"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"low", vectorOf(mesh.low)},
          {"size", vectorOf(mesh.size)},
          {"colors", mesh.has_colors},
          {"wide", mesh.wide}};
}

/// Where the camera was, thinned out.
Json pathOf(const std::vector<StampedPose>& poses) {
  Json path = Json::array();
  const std::size_t step = poses.size() / kPathPoints + 1;
  for (std::size_t i = 0; i < poses.size(); i += step) {
    path.push_back(vectorOf(poses[i].T_world_camera.translation()));
  }
  return path;
}

PageData binary(const std::string& id, const std::string& bytes) {
  return {id, PageData::Kind::kBinary, base64(bytes)};
}

Json candidateOf(const ShapeCandidate& candidate, const LabelSpace& label_space) {
  Json json = {{"track", candidate.track},
               {"class", label_space.nameOf(candidate.label)},
               {"observations", candidate.observations},
               {"accepted", candidate.accepted},
               {"reason", candidate.reason},
               {"object", candidate.object ? Json(std::to_string(*candidate.object)) : Json()},
               {"eye", vectorOf(candidate.T_world_camera.translation())}};
  if (candidate.hasEstimate()) {
    json["overlap"] = number(candidate.overlap);
    json["coverage"] = number(candidate.coverage);
    json["depth_residual_m"] =
        candidate.depth_residual_m ? number(*candidate.depth_residual_m) : Json();
  }
  return json;
}

}  // namespace

/// What goes into the blobs, and where it is.
struct WorldScene::Contents {
  std::vector<PackedMesh> shapes;
  std::vector<ShapePair> pairs;  ///< sorted
  std::vector<PairDistances> distances;
  std::vector<ViewCut> cuts;  ///< of the candidates of all methods; empty without pictures
  std::size_t next_cut = 0;
  BlobPool pool;      ///< shapes and distances
  BlobPool pictures;  ///< JPEG and PNG files

  Json shape(std::size_t number) {
    return meshOf(shapes[number], pool.add(shapes[number].bytes).offset);
  }
};

std::size_t WorldScene::Packed::bytes() const {
  std::size_t total = json.size();
  for (const PageData& blob : blobs) total += blob.text.size();
  return total;
}

WorldScene::WorldScene(const ResultWorld& world, const ObjectWorld* objects)
    : dataset_name_(world.dataset), seed_(world.seed), opened_(world.open()), objects_(objects) {
  if (opened_.dataset->hasGroundTruth()) {
    for (const GroundTruthObject& object : opened_.dataset->groundTruth().objects) {
      if (object.scored && !object.mesh->empty()) truths_.push_back(&object);
    }
  }
  for (const GroundTruthObject* truth : truths_) {
    truth_meshes_.push_back(transformed(truth->T_world_object, *truth->mesh));
    truth_meshes_.back().colors.clear();
    truth_boxes_.push_back(bounds(truth_meshes_.back()));
  }
  for (const Mesh& mesh : truth_meshes_) truth_shapes_.push_back(shapes_.add(mesh));
  for (const std::filesystem::path& path : world.predictions) load(path);
}

void WorldScene::load(const std::filesystem::path& path) {
  Method& method = methods_.emplace_back();
  method.prediction = readPrediction(path);
  if (!method.prediction.candidates.empty()) method.rmcc = readDecisionOf(path).rmcc;
  SceneGraph& graph = method.prediction.graph;
  for (ObjectNode& node : graph.objects) {
    node.mesh.colors.clear();  // objects are drawn in the colour of what is asked about them
    method.shapes.push_back(node.mesh.empty() ? std::nullopt
                                              : std::optional(shapes_.add(node.mesh)));
  }
  if (graph.scene_mesh.empty()) return;
  const auto known = std::find_if(scenes_.begin(), scenes_.end(), [&](const Mesh* scene) {
    return scene->vertices == graph.scene_mesh.vertices && scene->faces == graph.scene_mesh.faces;
  });
  method.scene = static_cast<std::size_t>(known - scenes_.begin());
  if (known == scenes_.end()) scenes_.push_back(&graph.scene_mesh);
}

std::vector<WorldScene::Match> WorldScene::matchesOf(const Method& method) const {
  std::vector<Match> matches;
  if (!objects_) return matches;
  std::map<std::string, std::size_t> object_of, truth_of;
  const std::vector<ObjectNode>& nodes = method.prediction.graph.objects;
  for (std::size_t i = 0; i < nodes.size(); ++i) object_of[std::to_string(nodes[i].id)] = i;
  for (std::size_t i = 0; i < truths_.size(); ++i) truth_of[std::to_string(truths_[i]->id)] = i;
  for (const ObjectWorld::Method& scored : objects_->methods) {
    if (scored.name != method.prediction.method) continue;
    for (const ObjectWorld::Pair& pair : scored.pairs) {
      const auto object = object_of.find(scored.estimates[pair.estimate].id);
      const auto truth = truth_of.find(objects_->truths[pair.truth].id);
      // Scores of another run of the method name objects that are not here.
      if (object == object_of.end() || truth == truth_of.end()) continue;
      const auto shape = method.shapes[object->second];
      if (!shape) continue;
      matches.push_back({object->second, truth->second, {*shape, truth_shapes_[truth->second]}});
    }
  }
  return matches;
}

std::optional<std::size_t> WorldScene::nearestTruth(const ShapeCandidate& candidate) const {
  if (!candidate.hasEstimate()) return std::nullopt;
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t t = 0; t < truths_.size(); ++t) {
    if (truths_[t]->label != candidate.label) continue;
    const Aabb& box = truth_boxes_[t];
    const double distance = (box.center() - candidate.box.center()).norm();
    // Further away it is about something else.
    if (distance > 2 * halfDiagonal(box) || (nearest && distance >= least)) continue;
    nearest = t;
    least = distance;
  }
  return nearest;
}

double WorldScene::framePeriod() const {
  const std::vector<StampedPose>& poses = opened_.dataset->groundTruth().trajectory;
  if (poses.size() < 2) return 0;
  return static_cast<double>(poses.back().stamp_ns - poses.front().stamp_ns) * 1e-9 /
         static_cast<double>(poses.size() - 1);
}

WorldScene::Packed WorldScene::pack(const std::string& prefix, const SceneDetail& detail) const {
  Contents contents;
  contents.shapes = packShapes(shapes_, detail.object_faces);
  for (const Method& method : methods_) {
    for (const Match& match : matchesOf(method)) contents.pairs.push_back(match.shapes);
  }
  std::sort(contents.pairs.begin(), contents.pairs.end());
  contents.pairs.erase(std::unique(contents.pairs.begin(), contents.pairs.end()),
                       contents.pairs.end());
  contents.distances = pairDistances(shapes_, contents.shapes, contents.pairs);
  if (detail.picture_px > 0) contents.cuts = cutsOf(detail.picture_px);

  Json json = {{"dataset", dataset_name_}, {"seed", seed_}, {"prefix", prefix}};
  json["path"] = pathOf(opened_.dataset->groundTruth().trajectory);
  json["truths"] = Json::array();
  for (std::size_t t = 0; t < truths_.size(); ++t) {
    json["truths"].push_back({{"id", std::to_string(truths_[t]->id)},
                              {"name", truths_[t]->name},
                              {"class", opened_.dataset->labelSpace().nameOf(truths_[t]->label)},
                              {"mesh", contents.shape(truth_shapes_[t])}});
  }
  json["methods"] = Json::array();
  for (const Method& method : methods_) {
    json["methods"].push_back(
        {{"method", method.prediction.method},
         {"scene", method.scene && detail.scene_faces > 0 ? Json(*method.scene) : Json()},
         {"objects", objectsOf(method, contents)},
         {"matches", matchesOf(method, contents)},
         {"candidates", candidatesOf(method, contents)}});
  }

  Packed result;
  json["scenes"] = Json::array();
  std::vector<PackedMesh> scenes(detail.scene_faces > 0 ? scenes_.size() : 0);
  parallelFor(scenes.size(), [&](std::size_t i) {
    scenes[i] = packMesh(coarseMesh(*scenes_[i], detail.scene_faces));
  });
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    json["scenes"].push_back(meshOf(scenes[i], 0));
    result.blobs.push_back(
        binary(fmt::format("{}-scene-{}.gz", prefix, i), gzipped(scenes[i].bytes)));
  }
  result.blobs.push_back(binary(prefix + "-shapes.gz", gzipped(contents.pool.bytes())));
  result.blobs.push_back(binary(prefix + "-views", contents.pictures.bytes()));
  result.json = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return result;
}

std::vector<ViewCut> WorldScene::cutsOf(int size_px) const {
  std::vector<CandidateView> views;
  for (const Method& method : methods_) {
    for (const ShapeCandidate& candidate : method.prediction.candidates) {
      views.push_back({&candidate, &method.rmcc});
    }
  }
  return viewCuts(*opened_.dataset, views, size_px);
}

nlohmann::ordered_json WorldScene::objectsOf(const Method& method, Contents& contents) {
  const SceneGraph& graph = method.prediction.graph;
  Json objects = Json::array();
  for (std::size_t i = 0; i < graph.objects.size(); ++i) {
    const ObjectNode& node = graph.objects[i];
    const std::string id = std::to_string(node.id);
    objects.push_back({{"id", id},
                       {"name", shortId(id)},
                       {"class", graph.label_space.nameOf(node.label)},
                       {"box", {vectorOf(node.box.min()), vectorOf(node.box.max())}},
                       {"mesh", method.shapes[i] ? contents.shape(*method.shapes[i]) : Json()}});
  }
  return objects;
}

nlohmann::ordered_json WorldScene::matchesOf(const Method& method, Contents& contents) const {
  Json matches = Json::array();
  for (const Match& match : matchesOf(method)) {
    const auto pair = std::lower_bound(contents.pairs.begin(), contents.pairs.end(), match.shapes);
    const PairDistances& apart =
        contents.distances[static_cast<std::size_t>(pair - contents.pairs.begin())];
    matches.push_back({{"object", match.object},
                       {"truth", match.truth},
                       {"on_estimate", contents.pool.add(apart.on_estimate).offset},
                       {"on_truth", contents.pool.add(apart.on_truth).offset}});
  }
  return matches;
}

nlohmann::ordered_json WorldScene::candidatesOf(const Method& method, Contents& contents) const {
  Json candidates = Json::array();
  for (const ShapeCandidate& candidate : method.prediction.candidates) {
    Json row = candidateOf(candidate, method.prediction.graph.label_space);
    const auto near = nearestTruth(candidate);
    row["near"] = near ? Json(*near) : Json();
    if (!contents.cuts.empty()) {
      const ViewCut& cut = contents.cuts[contents.next_cut++];
      row["color"] = pieceOf(contents.pictures.add(cut.color));
      row["parts"] = pieceOf(contents.pictures.add(cut.parts));
    }
    candidates.push_back(std::move(row));
  }
  return candidates;
}

}  // namespace hydrabench
