// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/object_table.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/types/error.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLastObjectColumn = "truth_visible_fraction";

template <typename Value>
std::size_t indexIn(std::vector<Value>& values, const Value& value) {
  const auto found = std::find(values.begin(), values.end(), value);
  const auto index = static_cast<std::size_t>(found - values.begin());
  if (found == values.end()) values.push_back(value);
  return index;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) {
    std::vector<std::vector<std::string>> records = readCsvCells(path);
    table_.path = path;
    if (records.empty()) throw InputError(fmt::format("{}: empty", path.string()));
    table_.columns = records.front();
    table_.rows.assign(std::make_move_iterator(records.begin() + 1),
                       std::make_move_iterator(records.end()));
    for (std::size_t c = 0; c < table_.columns.size(); ++c) index_[table_.columns[c]] = c;
  }

  ObjectTable read() {
    const std::size_t first_score = column(kLastObjectColumn) + 1;
    result_.score_names.assign(table_.columns.begin() + static_cast<std::ptrdiff_t>(first_score),
                               table_.columns.end());
    for (row_ = 0; row_ < table_.rows.size(); ++row_) {
      if (table_.rows[row_].size() != table_.columns.size()) {
        throw InputError(fmt::format("{}:{}: {} cells, expected {} as in the header",
                                     table_.path.string(), row_ + 2, table_.rows[row_].size(),
                                     table_.columns.size()));
      }
      if (text("seed") != "pooled") readRow(first_score);
    }
    for (ObjectWorld& world : result_.worlds) {
      for (ObjectWorld::Method& method : world.methods) {
        method.outcomes.resize(result_.settings.size());
      }
    }
    return std::move(result_);
  }

 private:
  std::size_t column(const std::string& name) const {
    const auto found = index_.find(name);
    if (found == index_.end()) {
      throw InputError(fmt::format("{}:1: no column '{}'", table_.path.string(), name));
    }
    return found->second;
  }
  const std::string& text(const std::string& name) const { return table_.rows[row_][column(name)]; }
  std::optional<double> number(const std::string& name) const {
    return table_.number(row_, column(name));
  }

  void readRow(std::size_t first_score) {
    const auto [world_index, is_new_world] =
        worlds_.emplace(std::pair(text("dataset"), text("seed")), result_.worlds.size());
    if (is_new_world) {
      ObjectWorld& fresh = result_.worlds.emplace_back();
      fresh.dataset = text("dataset");
      fresh.seed = text("seed");
    }
    ObjectWorld& world = result_.worlds[world_index->second];
    ObjectWorld::Method& method = methodOf(world, text("method"));
    const std::size_t setting =
        indexIn(result_.settings,
                {text("threshold_kind"), number("threshold").value_or(0), text("matching")});
    if (method.outcomes.size() <= setting) method.outcomes.resize(setting + 1);

    ObjectWorld::Outcome outcome;
    outcome.kind = text("outcome");
    outcome.distance_m = number("center_distance_m");
    const std::string world_key = text("dataset") + "/" + text("seed");
    if (!text("estimate_id").empty()) {
      outcome.estimate = objectOf("estimate_", world_key + "/" + method.name, method.estimates);
    }
    if (!text("truth_id").empty()) {
      outcome.truth = objectOf("truth_", world_key, world.truths);
      ObjectWorld::Object& truth = world.truths[*outcome.truth];
      truth.name = text("truth_name");
      truth.subtype = text("truth_subtype");
      truth.room = text("truth_room");
      truth.visible_fraction = number(kLastObjectColumn);
    }
    if (outcome.kind == "matched" && outcome.estimate && outcome.truth) {
      readPair(first_score, *outcome.estimate, *outcome.truth, world_key, method);
    }
    method.outcomes[setting].push_back(std::move(outcome));
  }

  static ObjectWorld::Method& methodOf(ObjectWorld& world, const std::string& name) {
    for (ObjectWorld::Method& method : world.methods) {
      if (method.name == name) return method;
    }
    world.methods.emplace_back().name = name;
    return world.methods.back();
  }

  std::size_t objectOf(const std::string& side, const std::string& owner,
                       std::vector<ObjectWorld::Object>& objects) {
    const std::string& id = text(side + "id");
    const auto [place, is_new] = objects_.emplace(std::tuple(side, owner, id), objects.size());
    if (is_new) {
      ObjectWorld::Object& object = objects.emplace_back();
      object.id = id;
      object.class_name = text("class");
      object.center = {number(side + "center_x_m").value_or(0),
                       number(side + "center_y_m").value_or(0),
                       number(side + "center_z_m").value_or(0)};
      object.half_diagonal_m = number(side + "half_diagonal_m").value_or(0);
      object.faces = static_cast<std::size_t>(number(side + "faces").value_or(0));
    }
    return place->second;
  }

  void readPair(std::size_t first_score, std::size_t estimate, std::size_t truth,
                const std::string& world_key, ObjectWorld::Method& method) {
    std::vector<std::optional<double>> scores;
    for (std::size_t c = first_score; c < table_.columns.size(); ++c) {
      scores.push_back(table_.number(row_, c));
    }
    const auto [place, is_new] =
        pairs_.emplace(std::tuple(world_key, method.name, estimate, truth), method.pairs.size());
    if (is_new) {
      method.pairs.push_back({estimate, truth, std::move(scores)});
      return;
    }
    // At some settings a pair has no geometry.
    auto& known = method.pairs[place->second].scores;
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!known[i]) known[i] = scores[i];
    }
  }

  CsvTable table_;
  std::map<std::string, std::size_t> index_;
  std::size_t row_ = 0;
  ObjectTable result_;
  std::map<std::pair<std::string, std::string>, std::size_t> worlds_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> objects_;
  std::map<std::tuple<std::string, std::string, std::size_t, std::size_t>, std::size_t> pairs_;
};

Json number(const std::optional<double>& value) {
  return value ? Json(std::stod(fmt::format("{:.4g}", *value))) : Json(nullptr);
}

Json index(const std::optional<std::size_t>& value) { return value ? Json(*value) : Json(nullptr); }

Json objectsOf(const std::vector<ObjectWorld::Object>& objects, bool truths) {
  Json list = Json::array();
  for (const ObjectWorld::Object& object : objects) {
    Json json = {{"id", object.id}, {"class", object.class_name}};
    if (truths) {
      json["name"] = object.name;
      json["subtype"] = object.subtype;
      json["room"] = object.room;
      json["visible"] = number(object.visible_fraction);
    } else {
      json["name"] = shortId(object.id);
    }
    json["center"] = {number(object.center.x()), number(object.center.y()),
                      number(object.center.z())};
    json["half_diagonal"] = number(object.half_diagonal_m);
    json["faces"] = object.faces;
    list.push_back(std::move(json));
  }
  return list;
}

Json methodOf(const ObjectWorld::Method& method) {
  Json pairs = Json::array();
  for (const ObjectWorld::Pair& pair : method.pairs) {
    Json scores = Json::array();
    for (const auto& score : pair.scores) scores.push_back(number(score));
    pairs.push_back({{"e", pair.estimate}, {"t", pair.truth}, {"scores", std::move(scores)}});
  }
  Json outcomes = Json::array();
  for (const auto& setting : method.outcomes) {
    Json list = Json::array();
    for (const ObjectWorld::Outcome& outcome : setting) {
      Json row = Json::array();
      row.push_back(outcome.kind);
      row.push_back(index(outcome.estimate));
      row.push_back(index(outcome.truth));
      row.push_back(number(outcome.distance_m));
      list.push_back(std::move(row));
    }
    outcomes.push_back(std::move(list));
  }
  return {{"method", method.name},
          {"estimates", objectsOf(method.estimates, false)},
          {"pairs", std::move(pairs)},
          {"outcomes", std::move(outcomes)}};
}

}  // namespace

ObjectTable readObjectTable(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};
  return Reader(path).read();
}

std::string objectsJson(const ObjectTable& table) {
  Json json = {{"score_names", table.score_names}, {"settings", Json::array()}};
  for (const ObjectWorld::Setting& setting : table.settings) {
    json["settings"].push_back({{"kind", setting.threshold_kind},
                                {"value", setting.threshold},
                                {"matching", setting.matching}});
  }
  json["worlds"] = Json::array();
  for (const ObjectWorld& world : table.worlds) {
    Json methods = Json::array();
    for (const ObjectWorld::Method& method : world.methods) methods.push_back(methodOf(method));
    json["worlds"].push_back({{"dataset", world.dataset},
                              {"seed", world.seed},
                              {"truths", objectsOf(world.truths, true)},
                              {"methods", std::move(methods)}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string shortId(const std::string& id) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), value);
  if (error != std::errc() || end != id.data() + id.size() || value >> 56 != 'O') return id;
  return fmt::format("O{}", value & ((std::uint64_t{1} << 56) - 1));
}

}  // namespace hydrabench
