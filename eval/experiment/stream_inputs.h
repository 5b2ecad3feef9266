// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/datasets/dataset.h"
#include "eval/experiment/stream_replay.h"

namespace hydrabench {

/// Where requests come from.
struct StreamSources {
  std::vector<std::filesystem::path> paths;  ///< result folders of run, or prediction folders
  std::filesystem::path dataset;             ///< of the prediction folders
  std::vector<std::string> methods;          ///< to replay; empty: all that estimate shapes
  std::vector<std::string> overrides;        ///< evaluation.KEY=VALUE
  std::optional<double> request_after_s;     ///< instead of how long the run waited for a track
};

struct StreamInputs {
  std::vector<StreamWorld> worlds;  ///< a dataset's together, a world's methods together
  EvaluationConfig evaluation;
  std::string resolved_config;  ///< of the evaluation, YAML
};

/// What counts of a world, without the surfaces that an Evaluator prepares. Throws InputError if
/// nothing does.
Counting countingOf(const Dataset& dataset, const EvaluationConfig& config);

/// Opens the worlds and reads the candidates of their predictions. A result is scored by its own
/// config. Throws InputError: no method with candidates, one world or method twice, a dataset that
/// is needed or has no ground truth, a run that does not say how long it waits.
StreamInputs readStreamInputs(const StreamSources& sources,
                              const std::function<void(const std::string& world)>& on_world);

}  // namespace hydrabench
