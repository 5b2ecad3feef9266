// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/evaluation_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vectorFrom(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json toJson(const DetectionObject& object) {
  return {{"id", object.id},
          {"label", object.label},
          {"center_m", toJson(object.center)},
          {"half_diagonal_m", object.half_diagonal}};
}
DetectionObject detectionFrom(const Json& json) {
  return {json.at("id").get<ObjectId>(), json.at("label").get<Label>(),
          vectorFrom(json.at("center_m")), json.at("half_diagonal_m").get<double>()};
}

Json toJson(const ScoredObject& object) {
  Json json = toJson(object.detection);
  json["class"] = object.class_name;
  json["name"] = object.name;
  json["subtype"] = object.subtype;
  json["room"] = object.room;
  if (object.visible_fraction) json["visible_fraction"] = *object.visible_fraction;
  json["box_m"] = {toJson(object.box.min()), toJson(object.box.max())};
  json["faces"] = object.faces;
  json["has_surface"] = object.has_surface;
  json["watertight"] = object.watertight;
  json["signed_volume_m3"] = object.signed_volume_m3;
  return json;
}
ScoredObject objectFrom(const Json& json) {
  ScoredObject object;
  object.detection = detectionFrom(json);
  json.at("class").get_to(object.class_name);
  json.at("name").get_to(object.name);
  json.at("subtype").get_to(object.subtype);
  json.at("room").get_to(object.room);
  if (json.contains("visible_fraction")) {
    object.visible_fraction = json.at("visible_fraction").get<double>();
  }
  object.box = Aabb(vectorFrom(json.at("box_m").at(0)), vectorFrom(json.at("box_m").at(1)));
  json.at("faces").get_to(object.faces);
  json.at("has_surface").get_to(object.has_surface);
  json.at("watertight").get_to(object.watertight);
  json.at("signed_volume_m3").get_to(object.signed_volume_m3);
  return object;
}

Json toJson(const LabelSpace::Entry& entry) {
  return {{"label", entry.label},
          {"name", entry.name},
          {"color", {entry.color.r, entry.color.g, entry.color.b}},
          {"is_object", entry.is_object},
          {"is_scored", entry.is_scored}};
}
LabelSpace::Entry entryFrom(const Json& json) {
  LabelSpace::Entry entry;
  json.at("label").get_to(entry.label);
  json.at("name").get_to(entry.name);
  json.at("color").at(0).get_to(entry.color.r);
  json.at("color").at(1).get_to(entry.color.g);
  json.at("color").at(2).get_to(entry.color.b);
  json.at("is_object").get_to(entry.is_object);
  json.at("is_scored").get_to(entry.is_scored);
  return entry;
}

Json toJson(const MatchedPair& pair, const PairScores& scores) {
  Json json = {{"estimate", pair.estimate}, {"truth", pair.truth}};
  for (const PairScoreColumn& column : pairScoreColumns()) {
    if (const auto& value = scores.*column.value) json[std::string(column.name)] = *value;
  }
  return json;
}

Json toJson(const SceneTally& tally) {
  return {{"ground_m2", tally.ground_m2},
          {"covered_ground_m2", tally.covered_ground_m2},
          {"truth_points", tally.truth_points},
          {"truth_distance_m", tally.truth_distance_m},
          {"truth_within", tally.truth_within},
          {"estimate_points", tally.estimate_points},
          {"estimate_distance_m", tally.estimate_distance_m},
          {"estimate_within", tally.estimate_within},
          {"ground_points", tally.ground_points},
          {"ground_square_error_m2", tally.ground_square_error_m2},
          {"boundary_m", tally.boundary_m},
          {"filled_m3", tally.filled_m3}};
}
SceneTally tallyFrom(const Json& json) {
  SceneTally tally;
  json.at("ground_m2").get_to(tally.ground_m2);
  json.at("covered_ground_m2").get_to(tally.covered_ground_m2);
  json.at("truth_points").get_to(tally.truth_points);
  json.at("truth_distance_m").get_to(tally.truth_distance_m);
  json.at("truth_within").get_to(tally.truth_within);
  json.at("estimate_points").get_to(tally.estimate_points);
  json.at("estimate_distance_m").get_to(tally.estimate_distance_m);
  json.at("estimate_within").get_to(tally.estimate_within);
  json.at("ground_points").get_to(tally.ground_points);
  json.at("ground_square_error_m2").get_to(tally.ground_square_error_m2);
  json.at("boundary_m").get_to(tally.boundary_m);
  json.at("filled_m3").get_to(tally.filled_m3);
  return tally;
}

template <typename Item>
Json listOf(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(toJson(item));
  return list;
}

MethodEvaluation evaluationFrom(const Json& json) {
  MethodEvaluation evaluation;
  json.at("dataset").get_to(evaluation.dataset);
  json.at("seed").get_to(evaluation.seed);
  json.at("method").get_to(evaluation.method);
  for (const Json& entry : json.at("label_space")) {
    evaluation.label_space.entries.push_back(entryFrom(entry));
  }
  for (const Json& object : json.at("estimates"))
    evaluation.estimates.push_back(objectFrom(object));
  for (const Json& object : json.at("truths")) evaluation.truths.push_back(objectFrom(object));
  for (const Json& object : json.at("ignored")) evaluation.ignored.push_back(detectionFrom(object));
  for (const Json& pair : json.at("pairs")) {
    PairScores scores;
    for (const PairScoreColumn& column : pairScoreColumns()) {
      const std::string name(column.name);
      if (pair.contains(name)) scores.*column.value = pair.at(name).get<double>();
    }
    evaluation.pair_scores.emplace(
        MatchedPair{pair.at("estimate").get<std::size_t>(), pair.at("truth").get<std::size_t>()},
        scores);
  }
  for (const Json& tally : json.at("scene")) evaluation.scene.push_back(tallyFrom(tally));
  json.at("notes").get_to(evaluation.notes);
  json.at("unscored_estimates").get_to(evaluation.unscored_estimates);
  json.at("estimates_without_mesh").get_to(evaluation.estimates_without_mesh);
  return evaluation;
}

}  // namespace

std::string evaluationJson(const MethodEvaluation& evaluation) {
  Json pairs = Json::array();
  for (const auto& [pair, scores] : evaluation.pair_scores) pairs.push_back(toJson(pair, scores));
  const Json json = {{"dataset", evaluation.dataset},
                     {"seed", evaluation.seed},
                     {"method", evaluation.method},
                     {"label_space", listOf(evaluation.label_space.entries)},
                     {"estimates", listOf(evaluation.estimates)},
                     {"truths", listOf(evaluation.truths)},
                     {"ignored", listOf(evaluation.ignored)},
                     {"pairs", pairs},
                     {"scene", listOf(evaluation.scene)},
                     {"notes", evaluation.notes},
                     {"unscored_estimates", evaluation.unscored_estimates},
                     {"estimates_without_mesh", evaluation.estimates_without_mesh}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

MethodEvaluation readEvaluation(const std::filesystem::path& path) {
  try {
    return evaluationFrom(Json::parse(readFile(path)));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not an evaluation: {}", path.string(), error.what()));
  }
}

}  // namespace hydrabench
