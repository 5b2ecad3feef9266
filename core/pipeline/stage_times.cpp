// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/stage_times.h"

#include <algorithm>

namespace hydrabench {

StageTimes::Scope::Scope(StageTimes& times, const char* stage)
    : times_(times),
      stage_(stage),
      wall_start_(std::chrono::steady_clock::now()),
      cpu_start_(std::clock()) {}

StageTimes::Scope::~Scope() {
  const std::chrono::duration<double, std::milli> wall =
      std::chrono::steady_clock::now() - wall_start_;
  const double cpu_s = static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC;
  times_.add(stage_, {wall.count(), 1e3 * cpu_s});
}

void StageTimes::add(const std::string& stage, const Sample& sample) {
  const auto it = std::find_if(stages_.begin(), stages_.end(),
                               [&](const Stage& known) { return known.name == stage; });
  Stage& entry = it != stages_.end() ? *it : stages_.emplace_back(Stage{stage, {}});
  entry.samples.push_back(sample);
}

}  // namespace hydrabench
