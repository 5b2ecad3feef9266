// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "eval/datasets/dataset.h"
#include "eval/experiment/job.h"
#include "eval/experiment/method_table.h"
#include "eval/experiment/unit_store.h"

namespace hydrabench {

/// What is to be told while jobs run.
struct JobEvents {
  /// A world is open and about to be mapped by so many methods at once.
  std::function<void(const WorldSpec&, std::size_t frames)> on_world;
  std::function<void()> on_frame;
  std::function<void(const std::string& unit, const std::string& message)> on_failure;
};

/// Does jobs in this process and leaves what they made in the store. Units that are there already
/// are not done again. A unit that fails is recorded and the others go on.
class JobRunner {
 public:
  using MethodReader = std::function<MethodConfig(const std::string& mapping_config)>;
  explicit JobRunner(UnitStore store);
  /// With methods that are in no table.
  JobRunner(UnitStore store, MethodReader read_method);

  void run(const Job& job, const JobEvents& events = {});

 private:
  void map(const WorldSpec& world, std::vector<RunUnit> runs, const JobEvents& events);
  void score(const WorldSpec& world, const std::vector<ScoreUnit>& scores, const JobEvents& events);
  void fail(const Job& unit, const std::string& message, const JobEvents& events) const;
  const Dataset& open(const WorldSpec& world);

  UnitStore store_;
  MethodReader read_method_;
  std::string opened_;  ///< config of dataset_: jobs on the same world follow each other
  std::unique_ptr<Dataset> dataset_;
};

}  // namespace hydrabench
