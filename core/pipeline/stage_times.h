// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace hydrabench {

/// How long each stage of a method took, call by call, in order of first appearance.
class StageTimes {
 public:
  struct Sample {
    double wall_ms = 0;
    double cpu_ms = 0;  ///< of the whole process: methods run one after the other
  };
  struct Stage {
    std::string name;
    std::vector<Sample> samples;
  };

  /// Measures from construction to destruction.
  class Scope {
   public:
    Scope(StageTimes& times, const char* stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    StageTimes& times_;
    const char* stage_;
    std::chrono::steady_clock::time_point wall_start_;
    std::clock_t cpu_start_;
  };

  void add(const std::string& stage, const Sample& sample);
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  std::vector<Stage> stages_;
};

}  // namespace hydrabench
