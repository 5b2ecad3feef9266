// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/sweep_data.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "eval/evaluation/score_row.h"
#include "eval/report/html/blob.h"
#include "eval/report/html/csv_json.h"
#include "eval/report/html/score_data.h"
#include "eval/report/sweep_report.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& prefix,
                              const std::string& extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension &&
        entry.path().filename().string().starts_with(prefix)) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The titles of the axes, which stand in config.yaml as `sweep` writes it: above the experiment.
void readTitles(const fs::path& config, SweepScores& sweep) {
  constexpr std::string_view kName = "  - name: ";
  constexpr std::string_view kTitle = "    title: ";
  if (!fs::exists(config)) return;
  std::istringstream lines(readFile(config));
  std::string axis;
  for (std::string line; std::getline(lines, line) && line != "experiment:";) {
    if (line.starts_with(kName)) axis = line.substr(kName.size());
    if (!line.starts_with(kTitle)) continue;
    std::string title = line.substr(kTitle.size());
    if (title.size() > 1 && title.front() == '"') title = title.substr(1, title.size() - 2);
    for (SweepScores::Axis& known : sweep.axes) {
      if (known.name == axis && !title.empty()) known.title = title;
    }
  }
}

Json gridOf(const SweepScores& sweep) {
  Json json;
  json["table"] = Json::parse(tableJson(sweepTable(sweep), kAllMicro));
  json["plots"] = Json::array();
  for (const std::string& dataset : sweepDatasets(sweep)) {
    for (const char* matching : {kMatchingExists, kMatchingOneToOne}) {
      json["plots"].push_back(
          {{"dataset", dataset},
           {"matching", matching},
           {"panels", Json::parse(plotJson(sweepPlot(sweep, dataset, matching)))}});
    }
  }
  return json;
}

}  // namespace

std::string sweepJson(const fs::path& result) {
  const fs::path scores = result / "scores.csv";
  Json json;
  if (fs::exists(scores)) {
    if (auto sweep = readSweepCsv(scores)) {
      readTitles(result / "config.yaml", *sweep);
      json = gridOf(*sweep);
    }
  } else {
    for (const fs::path& file : filesIn(result, "tau_o_", ".csv")) {
      json["tables"].push_back(
          {{"name", file.stem().string()}, {"table", Json::parse(csvJson(file))}});
    }
    for (const fs::path& file : filesIn(result / "plots", "tau_o_", ".svg")) {
      json["pictures"].push_back({{"name", file.stem().string()}, {"svg", base64(readFile(file))}});
    }
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hydrabench
