// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/score_row.h"
#include "eval/report/comparison_table.h"
#include "eval/report/plot.h"

namespace hydrabench {

/// The scores of one experiment at many settings.
struct SweepScores {
  struct Axis {
    std::string name;   ///< "voxel_size_m"
    std::string title;  ///< "voxel size [m]"
  };
  struct Point {
    std::vector<std::string> values;  ///< per axis
    std::vector<ScoreRow> rows;
  };
  std::vector<Axis> axes;  ///< at least one
  std::vector<Point> points;
};

/// scores.csv with a column per axis in front.
std::string sweepCsv(const SweepScores& sweep);
/// The way back; the titles of the axes are their names. nullopt where the file is the scores.csv
/// of no sweep. Throws InputError naming file and line.
std::optional<SweepScores> readSweepCsv(const std::filesystem::path& path);

/// The comparison table with a row for every method and point.
ComparisonTable sweepTable(const SweepScores& sweep);

/// F1 at every threshold and the mean box IoU over the first axis, a curve for every method and, if
/// there are more axes, for every combination of their values. Values that are no numbers stand in
/// their order at 1, 2, 3, ...
Plot sweepPlot(const SweepScores& sweep, const std::string& dataset, const std::string& matching);

/// Names of the datasets that have scores, in order of appearance.
std::vector<std::string> sweepDatasets(const SweepScores& sweep);

}  // namespace hydrabench
