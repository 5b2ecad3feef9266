// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/detection.h"

#include <cassert>

namespace hydrabench {
namespace {

std::optional<double> ratio(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Aabb objectBox(const Mesh& mesh_world) {
  if (mesh_world.empty()) return bounds(mesh_world);
  Aabb box;
  for (const Eigen::Vector3i& face : mesh_world.faces) {
    for (const int vertex : face) box.extend(mesh_world.vertices[static_cast<std::size_t>(vertex)]);
  }
  return box;
}

DetectionObject detectionObject(ObjectId id, Label label, const Mesh& mesh_world) {
  const Aabb box = objectBox(mesh_world);
  assert(!box.isEmpty());
  return {id, label, box.center(), halfDiagonal(box)};
}

double Threshold::gate(const DetectionObject& truth) const {
  return kind == Kind::kTauM ? value : value * truth.half_diagonal;
}

bool Threshold::admits(double distance, const DetectionObject& truth) const {
  if (kind == Kind::kTauM) return distance < value;
  return truth.half_diagonal > 0 && distance / truth.half_diagonal < value;
}

const char* name(Matching matching) {
  return matching == Matching::kExists ? "exists" : "one_to_one";
}

const char* name(Threshold::Kind threshold_kind) {
  return threshold_kind == Threshold::Kind::kTauM ? "tau_m" : "kappa";
}

DetectionCounts& DetectionCounts::operator+=(const DetectionCounts& other) {
  estimates += other.estimates;
  matched_estimates += other.matched_estimates;
  truths += other.truths;
  found_truths += other.found_truths;
  return *this;
}

std::optional<double> precision(const DetectionCounts& counts) {
  return ratio(counts.matched_estimates, counts.estimates);
}

std::optional<double> recall(const DetectionCounts& counts) {
  return ratio(counts.found_truths, counts.truths);
}

std::optional<double> f1(const DetectionCounts& counts) {
  const std::optional<double> p = precision(counts);
  const std::optional<double> r = recall(counts);
  if (!p && !r) return std::nullopt;
  if (!p || !r || *p + *r == 0) return 0.0;
  return 2 * *p * *r / (*p + *r);
}

}  // namespace hydrabench
