// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluation/evaluation_config.h"

namespace hydrabench {

/// A dataset as it is mapped: with one seed, down to the last key.
struct WorldSpec {
  std::string dataset;  ///< its name in tables
  std::uint64_t seed = 0;
  std::string config;          ///< resolved YAML
  std::size_t max_frames = 0;  ///< 0: all
};

/// One world mapped by one method: the smallest piece of work. What it leaves stands in the store
/// under its hash, which covers everything that can change it: program, world, config, weights.
struct RunUnit {
  std::string hash;
  std::vector<std::string> methods;  ///< names of those that share it; at least one
  std::string mapping_config;        ///< MethodConfig::mapping_config
};

/// One run decided and scored.
struct ScoreUnit {
  std::string hash;
  std::string run;  ///< hash of the RunUnit
  std::string method;
  /// YAML of the DecisionConfig, in which methods that share a run differ; empty: the objects are
  /// those of the run.
  std::string decision;
  EvaluationConfig evaluation;  ///< as pairScoring() leaves it
};

/// What of the config the scores of pairs depend on; the rest, which rescore() can change
/// afterwards, at fixed values.
EvaluationConfig pairScoring(EvaluationConfig config);

/// Work on one world, done in one go: each frame is made once for all methods.
struct Job {
  WorldSpec world;
  std::vector<RunUnit> runs;
  std::vector<ScoreUnit> scores;  ///< of these runs or of others that are done

  /// "office, seed 3: hydra, khronos"
  std::string label() const;
};

std::string jobJson(const Job& job);
/// @param name  where it is from. Throws InputError naming it.
Job jobFromJson(const std::string& text, const std::string& name);
/// Also out of a failure that the store keeps. Throws InputError naming the file, also for a job of
/// another build: its hashes would not be true.
Job readJob(const std::filesystem::path& path);

}  // namespace hydrabench
