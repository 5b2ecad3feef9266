// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/claim.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/config_reader.h"
#include "core/config/plain_name.h"
#include "metrics/bootstrap.h"
#include "metrics/pair_scores.h"

namespace hydrabench {
namespace {

struct NamedType {
  const char* name;
  Predicate::Type type;
};
constexpr NamedType kTypes[] = {{"score", Predicate::Type::kScore},
                                {"kappa", Predicate::Type::kKappa},
                                {"trend", Predicate::Type::kTrend},
                                {"real_time", Predicate::Type::kRealTime},
                                {"scene", Predicate::Type::kScene}};

std::vector<std::string> detectionMetrics() {
  std::vector<std::string> names;
  for (const NamedDetectionScore& score : kDetectionScores) names.emplace_back(score.name);
  return names;
}

std::vector<std::string> pairMetrics() {
  std::vector<std::string> names;
  for (const PairScoreColumn& column : pairScoreColumns()) {
    if (column.direction != ScoreDirection::kReference) names.emplace_back(column.name);
  }
  return names;
}

void readMetric(ConfigReader& reader, Predicate& predicate) {
  reader.require("metric");
  std::vector<std::string> known;
  if (predicate.type != Predicate::Type::kTrend) known = detectionMetrics();
  if (predicate.type != Predicate::Type::kKappa) {
    const std::vector<std::string> more = pairMetrics();
    known.insert(known.end(), more.begin(), more.end());
  }
  if (predicate.type == Predicate::Type::kScene) {
    reader.field("metric", predicate.metric);
    reader.field("lower_is_better", predicate.lower_is_better);
  } else if (reader.has("metric")) {
    reader.choice("metric", predicate.metric, known);
  }
}

void readRelation(ConfigReader& reader, Predicate& predicate) {
  if (predicate.type == Predicate::Type::kTrend) {
    reader.field("more_than", predicate.than);
    return;
  }
  std::vector<std::string> better, no_worse;
  reader.field("better_than", better);
  reader.field("no_worse_than", no_worse);
  if (better.empty() == no_worse.empty()) {
    reader.fault("better_than", "expected either better_than or no_worse_than: a list of methods");
  }
  predicate.strictly = no_worse.empty();
  predicate.than = predicate.strictly ? better : no_worse;
  reader.field("margin", predicate.margin, {0, 1e9});
}

void readMatching(ConfigReader& reader, Predicate& predicate) {
  std::string matching = name(predicate.matching);
  reader.choice("matching", matching, {name(Matching::kExists), name(Matching::kOneToOne)});
  predicate.matching =
      matching == name(Matching::kExists) ? Matching::kExists : Matching::kOneToOne;
}

Predicate readPredicate(ConfigReader& reader) {
  Predicate predicate;
  std::string type = "score";
  std::vector<std::string> types;
  for (const NamedType& known : kTypes) types.emplace_back(known.name);
  reader.choice("type", type, types);
  predicate.type = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const auto& t) {
                     return type == t.name;
                   })->type;
  reader.require("method");
  reader.field("method", predicate.method);
  if (predicate.type == Predicate::Type::kRealTime) {
    reader.field("at_hz", predicate.at_hz, {1e-3, 1e6});
    reader.field("keeps", predicate.keeps);
    return predicate;
  }
  readMetric(reader, predicate);
  readRelation(reader, predicate);
  const std::vector<std::string> detection = detectionMetrics();
  const bool is_detection =
      std::find(detection.begin(), detection.end(), predicate.metric) != detection.end();
  if (predicate.type == Predicate::Type::kScore || predicate.type == Predicate::Type::kTrend) {
    reader.field("tau_m", predicate.tau_m, {1e-6, 1e6});
  }
  if (predicate.type == Predicate::Type::kKappa) {
    reader.field("kappa_max", predicate.kappa_max, {1e-3, 1e3});
  }
  // What a pair scored is only known of the pairs that one_to_one makes.
  if (is_detection && predicate.type != Predicate::Type::kScene) {
    readMatching(reader, predicate);
  } else {
    predicate.matching = Matching::kOneToOne;
  }
  return predicate;
}

}  // namespace

std::vector<Claim> readClaims(const std::filesystem::path& path) {
  ConfigReader reader(ConfigDocument::fromFile(path));
  std::vector<Claim> claims;
  std::set<std::string> names;
  reader.require("claims");
  for (ConfigReader& item : reader.list("claims")) {
    Claim claim;
    item.require("name");
    item.field("name", claim.name);
    if (item.has("name") && !isPlainName(claim.name)) {
      item.fault("name", fmt::format("'{}', {}", claim.name, kPlainNameExpected));
    } else if (!names.insert(claim.name).second) {
      item.fault("name", fmt::format("'{}' occurs twice", claim.name));
    }
    item.require("says");
    item.field("says", claim.says);
    item.field("source", claim.source);
    item.field("dataset", claim.dataset);
    item.require("needs");
    for (ConfigReader& need : item.list("needs")) claim.needs.push_back(readPredicate(need));
    if (item.has("needs") && claim.needs.empty()) {
      item.fault("needs", "empty, expected at least one predicate");
    }
    claims.push_back(std::move(claim));
  }
  reader.finish();
  return claims;
}

}  // namespace hydrabench
