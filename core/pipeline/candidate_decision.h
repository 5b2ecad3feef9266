// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/graph/scene_graph.h"
#include "core/graph/shape_candidate.h"
#include "core/objects/rmcc.h"

namespace hydrabench {

/// Which candidates become objects, and which of them are the same object.
///
/// Merging follows Hydra's backend, into which the paper puts its objects: two nodes of a class are
/// one object where the box of either contains the centre of the other's. Hydra and Khronos unite
/// the meshes of merged nodes, which suits pieces of a surface; two full shapes of one object would
/// stand inside each other, so the one with more evidence stays as it is.
struct DecisionConfig {
  RmccConfig rmcc;
  /// What a rejected track, or one without estimate, leaves. drop: nothing (paper). partial_mesh:
  /// what was seen of it, as in Khronos, where anything was reconstructed.
  std::string rejected = "drop";
  bool merge_revisited = true;
  /// Which of two merged shapes stays. view_volume: the one estimated from the view with the larger
  /// box, which is the view the paper would pick had it been one track. overlap: the one with the
  /// larger O. Of equals the earlier. A shape always wins against what was seen only.
  std::string merge_evidence = "view_volume";
  friend bool operator==(const DecisionConfig&, const DecisionConfig&) = default;
};
/// Reads the keys rmcc, rejected, merge_revisited, merge_evidence.
void read(ConfigReader& reader, DecisionConfig& config);

/// What becomes of candidates. Indices are into the list they were decided from.
struct Decision {
  struct Verdict {
    bool accepted = false;
    std::string reason;  ///< of a rejection: overlap, coverage, depth_residual; "failure: ..."
    std::ptrdiff_t object = -1;  ///< index into objects; -1: none
  };
  struct Object {
    std::size_t candidate = 0;           ///< whose shape it has
    bool partial = false;                ///< what was seen instead of the estimate
    std::int64_t first_observed_ns = 0;  ///< of all that were merged
    std::int64_t last_observed_ns = 0;
  };
  std::vector<Verdict> verdicts;  ///< one per candidate
  std::vector<Object> objects;    ///< in order of the first candidate of each
};

/// A function of the candidates' records alone: what the pipeline decides at the end of a run, and
/// what a sweep decides anew. Candidates are gone through in the order given.
Decision decide(std::span<const ShapeCandidate> candidates, const DecisionConfig& config);

/// Nodes of the objects, numbered from 0.
std::vector<ObjectNode> objectNodes(std::span<const ShapeCandidate> candidates,
                                    const Decision& decision, const LabelSpace& label_space);

/// Writes the verdicts into the candidates they are about.
void record(const Decision& decision, std::span<ShapeCandidate> candidates);

/// How many candidates came to what, for the reader of a table.
std::string decisionNote(const Decision& decision);

/// Decides the candidates of a finished prediction anew, as if it had been mapped with `config`:
/// its objects, the verdicts on its candidates and the note about them are replaced. What of the
/// config had a part in making the candidates (rmcc.mask, rmcc.points, rejected) must be as it was.
void redecide(Prediction& prediction, const DecisionConfig& config);

/// The keys of a method's config that redecide() can change afterwards.
std::vector<std::string> decisionKeys();

}  // namespace hydrabench
