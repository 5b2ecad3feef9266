// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "eval/experiment/provenance.h"

namespace hydrabench {

/// What evaluate writes: any number of methods on one dataset.
struct Result {
  std::string dataset;
  std::string seed;
  LabelSpace label_space;
  std::vector<MethodEvaluation> methods;
  std::string config;  ///< resolved YAML
  Provenance provenance;
};

/// Writes scores.csv, objects.csv, kappa.csv, table.*, config.yaml and provenance.json
/// (docs/metrics.md). The folder appears complete or not at all; `replace` swaps one that is there.
void writeResult(const std::filesystem::path& folder, const Result& result, bool replace);

std::vector<ScoreRow> allScores(const Result& result);
std::string objectsCsv(const Result& result);  ///< a row per estimate and per missed ground-truth
                                               ///< object, threshold and matching
std::string kappaCsv(const Result& result);    ///< the exact steps of the sweep

}  // namespace hydrabench
