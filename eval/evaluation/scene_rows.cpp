// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/scene_rows.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "metrics/bootstrap.h"

namespace hydrabench {
namespace {

struct Metric {
  std::string name;
  const char* unit;
  std::function<std::optional<double>(const SceneTally&)> value;
};

std::vector<Metric> metrics(const SceneTally& all) {
  std::vector<Metric> list = {
      {"ground_completeness", "", [](const SceneTally& t) { return groundCompleteness(t); }},
      {"ground_hole_area_m2", "m^2", groundHoleArea},
      {"ground_boundary_m", "m", [](const SceneTally& t) { return t.boundary_m; }},
      {"ground_rms", "m", groundRms},
      {"scene_accuracy", "m", sceneAccuracy},
      {"scene_completeness", "m", sceneCompleteness}};
  double from_m = 0;
  for (std::size_t i = 0; i < SceneTally::kBandEnds_m.size(); ++i) {
    const double to_m = SceneTally::kBandEnds_m[i];
    list.push_back(
        {fmt::format("ground_completeness_{:g}_{:g}m", from_m, to_m), "",
         [i](const SceneTally& t) { return groundCompleteness(t, static_cast<int>(i)); }});
    from_m = to_m;
  }
  for (std::size_t i = 0; i < SceneTally::kWithin_m.size(); ++i) {
    list.push_back({fmt::format("scene_f_score_{:g}cm", 100 * SceneTally::kWithin_m[i]), "",
                    [i](const SceneTally& t) { return sceneFScore(t, i); }});
  }
  list.push_back({"filled_volume", "m^3", [](const SceneTally& t) {
                    double sum = 0;
                    for (const auto& [nearby, volume] : t.filled_m3) sum += volume;
                    return sum;
                  }});
  for (const auto& [nearby, volume] : all.filled_m3) {
    list.push_back({"filled_volume_" + nearby, "m^3", [nearby](const SceneTally& t) {
                      const auto found = t.filled_m3.find(nearby);
                      return found == t.filled_m3.end() ? 0 : found->second;
                    }});
  }
  return list;
}

}  // namespace

std::vector<ScoreRow> sceneRows(const ScoreContext& context,
                                const std::vector<SceneTally>& tallies) {
  if (tallies.empty()) return {};
  const SceneTally all = total(tallies);
  std::vector<ScoreRow> rows;
  for (const Metric& metric : metrics(all)) {
    ScoreRow row{context.dataset,
                 context.seed,
                 context.method,
                 kSceneClass,
                 "",
                 {},
                 "",
                 metric.name,
                 metric.value(all),
                 metric.unit,
                 {},
                 {},
                 tallies.size()};
    if (row.value && context.config.bootstrap_resamples > 0) {
      const std::vector<std::size_t> sizes = {tallies.size()};
      const auto interval = bootstrapStatistic(
          sizes,
          [&](std::span<const std::size_t> drawn) {
            SceneTally sum;
            for (const std::size_t i : drawn) sum += tallies[i];
            return metric.value(sum);
          },
          context.config.bootstrapConfig());
      if (interval) {
        row.ci95_low = interval->interval.low;
        row.ci95_high = interval->interval.high;
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace hydrabench
