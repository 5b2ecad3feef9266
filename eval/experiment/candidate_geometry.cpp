// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/candidate_geometry.h"

namespace hydrabench {
namespace {

DetectionObject detection(const ShapeCandidate& candidate, const Mesh& mesh) {
  if (mesh.empty()) return {0, candidate.label, {}, 0};
  return detectionObject(0, candidate.label, mesh);
}

}  // namespace

CandidateGeometry::CandidateGeometry(std::span<const ShapeCandidate> candidates) {
  for (const ShapeCandidate& candidate : candidates) {
    full_.push_back(detection(candidate, candidate.mesh));
    partial_.push_back(detection(candidate, candidate.partial_mesh));
  }
}

std::vector<DetectionObject> CandidateGeometry::estimates(const Decision& decision,
                                                          const Counting& counting) const {
  std::vector<DetectionObject> estimates;
  for (std::size_t i = 0; i < decision.objects.size(); ++i) {
    const Decision::Object& object = decision.objects[i];
    DetectionObject estimate = (object.partial ? partial_ : full_)[object.candidate];
    estimate.id = i;
    if (counting.includes(estimate)) estimates.push_back(estimate);
  }
  return estimates;
}

}  // namespace hydrabench
