// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include <Eigen/Core>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "core/types/ids.h"

namespace hydrabench {

/// What detection knows of an object. Ids are unique within a set (of estimates, of truths).
struct DetectionObject {
  ObjectId id = 0;
  Label label = kUnknownLabel;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of the AABB of the world mesh [m]
  double half_diagonal = 0;                          ///< d_diag, of the same box [m]
  /// Objects of different worlds never meet: several scenes or seeds are scored together by giving
  /// each its own number. Ids are unique within a world.
  std::uint32_t world = 0;
};

/// Box around the vertices that faces use; around all vertices if there are no faces. Stray
/// vertices belong to no surface.
Aabb objectBox(const Mesh& mesh_world);
/// The one way from a mesh to its centre and extent, for estimates of every method and for ground
/// truth. Needs a vertex.
DetectionObject detectionObject(ObjectId id, Label label, const Mesh& mesh_world);

/// How close is close enough. Always strict: an object exactly at the threshold is not matched.
struct Threshold {
  enum class Kind {
    kTauM,   ///< value is tau_d [m], the same for every object
    kKappa,  ///< tau_d(g) = value * d_diag(g): no unit, scales with the ground-truth object
  };
  Kind kind = Kind::kTauM;
  double value = 0;

  static Threshold tau(double meters) { return {Kind::kTauM, meters}; }
  static Threshold kappa(double factor) { return {Kind::kKappa, factor}; }

  /// Radius around the centre of `truth` [m]. To decide, ask admits().
  double gate(const DetectionObject& truth) const;
  /// True where an estimate at `distance` [m] from the centre of `truth` matches. The kappa form
  /// compares distance / d_diag with kappa, so that a sweep and a single threshold round alike. A
  /// truth without extent is never matched under kappa.
  bool admits(double distance, const DetectionObject& truth) const;

  friend bool operator==(const Threshold&, const Threshold&) = default;
};

/// Which question the counts answer; always printed with the score.
enum class Matching {
  kExists,    ///< the paper's: an object counts if any same-label partner is inside the gate
  kOneToOne,  ///< partners are exclusive
};
const char* name(Matching matching);               ///< "exists" or "one_to_one"
const char* name(Threshold::Kind threshold_kind);  ///< "tau_m" or "kappa"

/// Counts that add up over classes, scenes and seeds; scores are derived from them once, after
/// pooling. Estimates and truths are counted apart: under `exists` several estimates may share one
/// truth, so recall must not take its numerator from the estimates.
struct DetectionCounts {
  std::size_t estimates = 0;
  std::size_t matched_estimates = 0;
  std::size_t truths = 0;
  std::size_t found_truths = 0;

  DetectionCounts& operator+=(const DetectionCounts& other);
  friend auto operator<=>(const DetectionCounts&, const DetectionCounts&) = default;
};
using CountsByClass = std::map<Label, DetectionCounts>;

/// matched_estimates / estimates. No unit, [0, 1], higher is better. No estimates: undefined.
std::optional<double> precision(const DetectionCounts& counts);
/// found_truths / truths. No unit, [0, 1], higher is better. No truths: undefined.
std::optional<double> recall(const DetectionCounts& counts);
/// Harmonic mean 2 P R / (P + R). No unit, [0, 1], higher is better. P = R = 0: 0. Only one set
/// empty: 0, because everything in the other one is wrong (an empty prediction scores 0 and is not
/// excused as undefined). Both empty: undefined.
std::optional<double> f1(const DetectionCounts& counts);

/// A score of the three above.
using DetectionScore = std::optional<double> (*)(const DetectionCounts&);

}  // namespace hydrabench
