// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/io/atomic_file.h"
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

/// A result folder can be replaced by another: it is known by this file.
inline constexpr const char* kResultMarker = "provenance.json";

/// Writes scores.csv, objects.csv, kappa.csv, table.*, config.yaml and provenance.json
/// (docs/metrics.md) and commits the folder. Claim it before the work: what cannot be written
/// should be known first.
void writeResult(AtomicFolder& folder, const Result& result);

std::vector<ScoreRow> allScores(const Result& result);
std::string objectsCsv(const Result& result);  ///< a row per estimate and per missed ground-truth
                                               ///< object, threshold and matching
std::string kappaCsv(const Result& result);    ///< the exact steps of the sweep

}  // namespace hydrabench
