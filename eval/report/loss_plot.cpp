// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/loss_plot.h"

#include <algorithm>
#include <cmath>

#include "core/types/error.h"
#include "eval/evaluation/csv.h"
#include "eval/report/plot.h"
#include "eval/training/loss_file.h"

namespace hydrabench {
namespace {

constexpr std::size_t kMostPoints = 80;  ///< of a curve; more is noise in print

struct Panel {
  const char* title;
  const char* phase;
  const char* column;
  const char* y_label;
};
constexpr Panel kPanels[] = {
    {"Decoder alone", "decoder", "sdf_l1", "mean error"},
    {"Object coordinates", "network", "nocs_error", "mean error"},
    {"Shape from a view", "network", "sdf_l1", "mean error"},
    {"Pose by the network", "network", "direct", "loss"},
    {"Shapes to latents and back", "autoencoder", "sdf_l1", "mean error"},
    {"Flow of poses", "pose", "flow", "squared error"},
    {"Flow of shapes", "shape", "flow", "squared error"},
};

/// A column over thousands of steps, where it has numbers.
PlotCurve curve(const CsvTable& table, const std::string& phase, const std::string& column) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), column);
  PlotCurve result;
  if (at == table.columns.end()) return result;
  const auto index = static_cast<std::size_t>(at - table.columns.begin());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][0] != phase) continue;
    const auto value = table.number(row, index);
    if (value) result.points.emplace_back(table.number(row, 1).value_or(0) / 1000, *value);
  }
  return result;
}

/// Means of runs of points, so many that a curve remains.
void smooth(PlotCurve& curve) {
  const std::size_t run = (curve.points.size() + kMostPoints - 1) / kMostPoints;
  std::vector<Eigen::Vector2d> means;
  for (std::size_t begin = 0; begin < curve.points.size(); begin += run) {
    const std::size_t end = std::min(begin + run, curve.points.size());
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = begin; i < end; ++i) sum += curve.points[i];
    means.push_back(sum / static_cast<double>(end - begin));
  }
  curve.points = means;
}

/// From 0 to what all but the first tenth of the points keep below.
Eigen::Vector2d rangeOfValues(const std::vector<PlotCurve>& curves) {
  double most = 0;
  for (const PlotCurve& curve : curves) {
    for (std::size_t i = curve.points.size() / 10; i < curve.points.size(); ++i) {
      most = std::max(most, curve.points[i].y());
    }
  }
  return {0, most > 0 ? 1.1 * most : 1};
}

}  // namespace

std::string drawLosses(const std::filesystem::path& loss_csv) {
  CsvTable table;
  try {
    table = readCsv(loss_csv, lossColumns());
  } catch (const InputError& error) {
    return error.what();
  }
  Plot plot;
  for (const Panel& panel : kPanels) {
    PlotPanel drawn;
    drawn.title = panel.title;
    drawn.x_label = "thousand steps";
    drawn.y_label = panel.y_label;
    drawn.curves = {curve(table, panel.phase, panel.column),
                    curve(table, panel.phase, std::string("val_") + panel.column)};
    if (drawn.curves[0].points.size() < 2) continue;
    smooth(drawn.curves[0]);
    drawn.curves[0].label = "training, mean of neighbouring steps";
    drawn.curves[1].label = "held-out worlds, averaged weights";
    if (std::string(panel.phase) == "decoder") drawn.curves[1].points.clear();
    drawn.x_range = {0, drawn.curves[0].points.back().x()};
    drawn.y_range = rangeOfValues(drawn.curves);
    plot.panels.push_back(std::move(drawn));
  }
  if (plot.panels.empty()) return loss_csv.string() + ": too few lines for a plot";
  return drawPlot(plot, loss_csv.parent_path(), "loss");
}

}  // namespace hydrabench
