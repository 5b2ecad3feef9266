// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/sweep_data.h"

#include <algorithm>
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
    if (const auto sweep = readSweepCsv(scores)) json = gridOf(*sweep);
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
