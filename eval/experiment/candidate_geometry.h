// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/pipeline/candidate_decision.h"
#include "eval/evaluation/counting.h"

namespace hydrabench {

/// Centres and extents of candidates, measured once: for whoever decides the same candidates many
/// times.
class CandidateGeometry {
 public:
  explicit CandidateGeometry(std::span<const ShapeCandidate> candidates);

  /// The objects of a decision about these candidates, as far as they count; their ids are indices
  /// into decision.objects.
  std::vector<DetectionObject> estimates(const Decision& decision, const Counting& counting) const;

 private:
  std::vector<DetectionObject> full_;  ///< per candidate
  std::vector<DetectionObject> partial_;
};

}  // namespace hydrabench
