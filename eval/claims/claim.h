// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "metrics/detection.h"

namespace hydrabench {

/// Something that can be read off a result: one method against others, or against the clock.
struct Predicate {
  enum class Type {
    kScore,     ///< a detection score, or a pair score averaged over what was found, at one tau_m
    kKappa,     ///< a detection score at every size-relative threshold up to kappa_max
    kTrend,     ///< a pair score grows with how far an object's size is from that of its class
    kRealTime,  ///< all processing fits into the time that the recording took at at_hz
    kScene,     ///< a score of the whole scene, from scores.csv
  };
  Type type = Type::kScore;
  std::string metric;             ///< as in scores.csv; empty for kRealTime
  std::string method;             ///< whose
  std::vector<std::string> than;  ///< other methods; for kTrend optional: the trend is larger
  bool strictly = true;  ///< better_than (by more than the margin); else no_worse_than (by more)
  double margin = 0;     ///< in the unit of the metric
  double tau_m = 0.2;
  double kappa_max = 1;
  Matching matching = Matching::kExists;
  double at_hz = 10;
  bool lower_is_better = false;  ///< kScene only; the other metrics know it of themselves
  bool keeps = true;             ///< kRealTime: whether it is said to keep up or not to
};

/// A sentence of a paper as predicates; it holds where all of them do.
struct Claim {
  std::string name;
  std::string says;
  std::string source;   ///< where it is made
  std::string dataset;  ///< of which it is made; empty: any that has the methods
  std::vector<Predicate> needs;
};

/// The paper's claims, seen from the top of a clone of hydrabench.
inline constexpr const char* kDefaultClaims = "configs/claims.yaml";

/// Reads a list of claims (configs/claims.yaml shows every key). Throws InputError naming file,
/// line, key and what was expected.
std::vector<Claim> readClaims(const std::filesystem::path& path);

}  // namespace hydrabench
