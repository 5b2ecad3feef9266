// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hydrabench {

/// Is a result as good as an earlier one? Every method that both have is compared on the worlds
/// that both have: F1 and the means over all ground truth by paired bootstrap over objects, time
/// per frame by paired bootstrap over stretches of 25 frames, or the instructions of a frame where
/// both results have those.
struct ResultComparison {
  enum class Verdict {
    kSame,          ///< sure to be no worse than the noise floor allows, and not sure to be better
    kBetter,        ///< sure to be better
    kWorse,         ///< sure to be worse, by more than the noise floor
    kInconclusive,  ///< could be worse by more than the noise floor; too little data to say
  };
  struct Line {
    std::string dataset;
    std::string method;
    std::string metric;  ///< "f1 (0.2 m)", "time per frame [ms]"
    double before = 0;
    double after = 0;
    double low = 0;  ///< 95 % interval of after less before
    double high = 0;
    Verdict verdict = Verdict::kSame;
    bool relative = false;  ///< low and high are of after / before - 1
  };
  std::vector<Line> lines;
  std::vector<std::string> notes;  ///< what could not be compared, and why

  /// The gravest of all lines.
  Verdict verdict() const;
};
const char* name(ResultComparison::Verdict verdict);

/// What is no difference.
struct NoiseFloor {
  double score = 0.005;       ///< F1 and IoU
  double distance_m = 0.001;  ///< chamfer_l1
  /// Of the time or the instructions per frame, in both directions: a change of so much does not
  /// pass as the same, and is told as soon as it is sure to be more than half of it.
  double time_share = 0.05;
  bool compare_times = true;  ///< and instructions; times of different machines never are
  int resamples = 2000;
};

/// Throws InputError where nothing can be compared: no result, other ground truth, no common
/// method.
ResultComparison compareResults(const std::filesystem::path& before,
                                const std::filesystem::path& after, const NoiseFloor& floor);

std::string comparisonMarkdown(const ResultComparison& comparison);
std::string comparisonJUnit(const ResultComparison& comparison);  ///< a test case per line

}  // namespace hydrabench
