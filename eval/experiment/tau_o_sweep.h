// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/pipeline/candidate_decision.h"
#include "eval/evaluation/counting.h"
#include "eval/evaluation/evaluation_config.h"
#include "eval/report/plot.h"
#include "metrics/bootstrap.h"

namespace hydrabench {

/// What the threshold of the consistency check does: every candidate of a run is decided anew, by
/// the pipeline's own rule, for every tau_O; nothing is mapped again. The result is a step
/// function, kept exactly: it changes where tau_O reaches the overlap of a candidate.
struct TauOStep {
  double tau_o = 0;  ///< holds from here, this value included, up to the next step
  std::size_t objects = 0;
  struct At {
    Threshold threshold;
    Matching matching = Matching::kExists;
    DetectionCounts counts;
    DetectionIntervals ci95;
  };
  std::vector<At> scores;  ///< per threshold of the config and matching, worlds together
};

/// The candidates of one world and what they are scored against.
struct TauOWorld {
  std::vector<ShapeCandidate> candidates;
  Counting counting;
};

/// Steps from 0 to 1.
/// @param decision  as the method was run; its check is taken as `published`, its threshold swept
std::vector<TauOStep> sweepTauO(const std::vector<TauOWorld>& worlds,
                                const DecisionConfig& decision, const EvaluationConfig& config);

std::string tauOCsv(const std::vector<TauOStep>& steps);
/// P, R and F1 over tau_O, a panel for each threshold, for one matching.
/// @param used  the threshold of the run
Plot tauOPlot(const std::vector<TauOStep>& steps, Matching matching, double used);
/// The best F1 per threshold and matching, over which tau_O, and what the threshold in use gives.
std::string tauOMarkdown(const std::vector<TauOStep>& steps, double used);

}  // namespace hydrabench
