// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "eval/experiment/single_view_study.h"
#include "eval/experiment/timing.h"
#include "eval/report/plot.h"

namespace hydrabench {

/// How long an estimator takes for an object, by stage.
struct LatencyRow {
  std::string dataset;
  std::string estimator;
  std::string stage;  ///< "total", or as the estimator names it
  std::size_t objects = 0;
  TimingRow times;   ///< of the calls that gave a shape; n = 0 without any
  std::string note;  ///< of "total": how many calls gave none, and why
};

/// Per dataset and estimator, in order of appearance: the total, then the stages by name. Worlds of
/// a dataset together.
std::vector<LatencyRow> latencyRows(const std::vector<SingleViewRow>& rows);

std::string latencyCsv(const std::vector<LatencyRow>& rows);
std::string latencyMarkdown(const std::vector<LatencyRow>& rows);
/// A violin for each estimator, a panel for each dataset: time per object, logarithmic.
Plot latencyPlot(const std::vector<SingleViewRow>& rows);

}  // namespace hydrabench
