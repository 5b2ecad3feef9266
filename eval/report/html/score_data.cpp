// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/score_data.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "eval/evaluation/csv.h"
#include "eval/report/html/csv_json.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  return value ? Json(std::stod(fmt::format("{:.6g}", *value))) : Json(nullptr);
}

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json jsonOf(const ComparisonTable& table, const std::string& class_name) {
  Json json = {{"class", class_name}, {"title", table.title}, {"notes", table.notes}};
  for (const TableColumn& column : table.columns) {
    json["columns"].push_back({{"metric", column.metric},
                               {"title", column.title},
                               {"higher_is_better", column.higher_is_better},
                               {"decimals", column.decimals},
                               {"ranked", column.ranked}});
  }
  json["blocks"] = Json::array();
  for (const TableBlock& block : table.blocks) {
    Json rows = Json::array();
    for (const TableRow& row : block.rows) {
      Json cells = Json::array();
      for (const TableCell& cell : row.cells) {
        cells.push_back(
            {number(cell.value), number(cell.ci95_low), number(cell.ci95_high), cell.rank});
      }
      rows.push_back({{"method", row.method}, {"label", row.label}, {"cells", std::move(cells)}});
    }
    json["blocks"].push_back({{"dataset", block.dataset},
                              {"threshold", block.threshold},
                              {"matching", block.matching},
                              {"rows", std::move(rows)}});
  }
  json["csv"] = renderCsv(table);
  json["tex"] = renderLatex(table);
  return json;
}

}  // namespace

std::string tableJson(const ComparisonTable& table, const std::string& class_name) {
  return text(jsonOf(table, class_name));
}

std::string tablesJson(const std::vector<ScoreRow>& rows, const std::vector<std::string>& notes) {
  std::vector<std::string> classes = {kAllMicro, kAllMacro};
  for (const ScoreRow& row : rows) {
    if (row.class_name.empty() || row.threshold_kind != "tau_m") continue;
    if (std::find(classes.begin(), classes.end(), row.class_name) == classes.end()) {
      classes.push_back(row.class_name);
    }
  }
  Json tables = Json::array();
  for (const std::string& class_name : classes) {
    const ComparisonTable table = comparisonTable(rows, class_name, notes);
    if (!table.blocks.empty()) tables.push_back(jsonOf(table, class_name));
  }
  return text(tables);
}

std::string methodsJson(const std::vector<std::string>& methods) {
  Json json = Json::array();
  for (const std::string& method : methods) {
    json.push_back(
        {{"name", method}, {"label", methodLabel(method)}, {"bound", isUpperBound(method)}});
  }
  return text(json);
}

std::string kappaJson(const std::filesystem::path& result) {
  const std::filesystem::path steps = result / "kappa.csv";
  if (!std::filesystem::exists(steps)) return "null";
  std::set<std::string> pooled;
  csvJson(steps, [&](const CsvRecord& record) {
    if (record.at("seed") == kPooledSeed) pooled.insert(record.at("dataset"));
    return false;
  });
  const auto stands = [&](const CsvRecord& record) {
    const auto class_name = record.find("class");
    return (class_name == record.end() || class_name->second == kAllMicro) &&
           (record.at("seed") == kPooledSeed || !pooled.contains(record.at("dataset")));
  };
  return "{\"steps\":" + csvJson(steps, stands) +
         ",\"intervals\":" + csvJson(result / "kappa_intervals.csv", stands) + "}";
}

std::string plotJson(const Plot& plot) {
  Json panels = Json::array();
  for (const PlotPanel& panel : plot.panels) {
    Json curves = Json::array();
    for (const PlotCurve& curve : panel.curves) {
      Json points = Json::array();
      for (const Eigen::Vector2d& point : curve.points) {
        points.push_back({number(point.x()), number(point.y())});
      }
      Json band = Json::array();
      for (const PlotCurve::Band& at : curve.band) {
        band.push_back({number(at.x), number(at.low), number(at.high)});
      }
      curves.push_back(
          {{"label", curve.label}, {"points", std::move(points)}, {"band", std::move(band)}});
    }
    panels.push_back({{"title", panel.title},
                      {"x_label", panel.x_label},
                      {"y_label", panel.y_label},
                      {"x_range", {panel.x_range.x(), panel.x_range.y()}},
                      {"curves", std::move(curves)}});
  }
  return text(panels);
}

}  // namespace hydrabench
