// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/candidate_decision.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {
namespace {

constexpr const char* kNotePrefix = "shapes: ";

/// An object while others may still be merged into it.
struct Node {
  Decision::Object object;
  Aabb box;
  Label label = kUnknownLabel;
  std::vector<std::size_t> members;  ///< candidates, the first one first
};

const Mesh& shapeOf(const ShapeCandidate& candidate, bool partial) {
  return partial ? candidate.partial_mesh : candidate.mesh;
}

class Merger {
 public:
  Merger(std::span<const ShapeCandidate> candidates, const DecisionConfig& config)
      : candidates_(candidates), config_(config) {}

  /// Merges with the nearest node that is the same object, then the result with the next, until
  /// none is.
  void add(Node node) {
    while (config_.merge_revisited) {
      const auto partner = nearestSame(node);
      if (!partner) break;
      Node other = std::move(nodes_[*partner]);
      nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(*partner));
      node = merged(std::move(other), std::move(node));
    }
    nodes_.push_back(std::move(node));
  }

  /// In order of their first members.
  std::vector<Node> take() {
    std::sort(nodes_.begin(), nodes_.end(),
              [](const Node& a, const Node& b) { return a.members.front() < b.members.front(); });
    return std::move(nodes_);
  }

 private:
  std::optional<std::size_t> nearestSame(const Node& node) const {
    std::optional<std::size_t> nearest;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Node& other = nodes_[i];
      if (other.label != node.label) continue;
      const Eigen::Vector3d center = node.box.center();
      const Eigen::Vector3d other_center = other.box.center();
      if (!node.box.contains(other_center) && !other.box.contains(center)) continue;
      const double distance_m = (center - other_center).norm();
      if (distance_m < nearest_m) {
        nearest = i;
        nearest_m = distance_m;
      }
    }
    return nearest;
  }

  /// Whether the shape of `a`, an earlier candidate than that of `b`, is the one to keep.
  bool keepsFirst(const Decision::Object& a, const Decision::Object& b) const {
    if (a.partial != b.partial) return b.partial;
    return evidence(a) >= evidence(b);
  }
  double evidence(const Decision::Object& object) const {
    const ShapeCandidate& candidate = candidates_[object.candidate];
    return config_.merge_evidence == "overlap" && !object.partial ? candidate.overlap
                                                                  : candidate.view_volume_m3;
  }

  Node merged(Node a, Node b) const {
    if (b.object.candidate < a.object.candidate) std::swap(a, b);
    Node& kept = keepsFirst(a.object, b.object) ? a : b;
    const Node& gone = &kept == &a ? b : a;
    kept.object.first_observed_ns =
        std::min(a.object.first_observed_ns, b.object.first_observed_ns);
    kept.object.last_observed_ns = std::max(a.object.last_observed_ns, b.object.last_observed_ns);
    kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
    std::sort(kept.members.begin(), kept.members.end());
    return std::move(kept);
  }

  std::span<const ShapeCandidate> candidates_;
  const DecisionConfig& config_;
  std::vector<Node> nodes_;
};

Decision::Verdict verdictOn(const ShapeCandidate& candidate, const RmccConfig& config) {
  if (!candidate.hasEstimate()) return {.reason = "failure: " + candidate.failure};
  const RmccScores scores{candidate.overlap, candidate.coverage, candidate.depth_residual_m};
  const char* rejection = rmccRejection(scores, candidate.box.diagonal().norm(), config);
  return {.accepted = rejection == nullptr, .reason = rejection ? rejection : ""};
}

}  // namespace

Decision decide(std::span<const ShapeCandidate> candidates, const DecisionConfig& config) {
  Decision decision;
  Merger merger(candidates, config);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const ShapeCandidate& candidate = candidates[i];
    const Decision::Verdict& verdict =
        decision.verdicts.emplace_back(verdictOn(candidate, config.rmcc));
    const bool partial = !verdict.accepted;
    if (partial && (config.rejected != "partial_mesh" || candidate.partial_mesh.empty())) continue;
    merger.add({.object = {.candidate = i,
                           .partial = partial,
                           .first_observed_ns = candidate.first_observed_ns,
                           .last_observed_ns = candidate.last_observed_ns},
                .box = partial ? bounds(candidate.partial_mesh) : candidate.box,
                .label = candidate.label,
                .members = {i}});
  }
  for (const Node& node : merger.take()) {
    for (const std::size_t member : node.members) {
      decision.verdicts[member].object = static_cast<std::ptrdiff_t>(decision.objects.size());
    }
    decision.objects.push_back(node.object);
  }
  return decision;
}

std::vector<ObjectNode> objectNodes(std::span<const ShapeCandidate> candidates,
                                    const Decision& decision, const LabelSpace& label_space) {
  std::vector<ObjectNode> nodes;
  for (const Decision::Object& object : decision.objects) {
    const ShapeCandidate& candidate = candidates[object.candidate];
    ObjectNode& node = nodes.emplace_back();
    node.id = objectNodeId(nodes.size() - 1);
    node.label = candidate.label;
    node.name = label_space.nameOf(candidate.label);
    node.mesh = shapeOf(candidate, object.partial);
    node.box = bounds(node.mesh);
    if (object.partial) {
      node.T_world_object.translation() = node.box.center();
    } else {
      node.T_world_object = candidate.T_world_object;
      node.scale = candidate.scale;
    }
    node.first_observed_ns = object.first_observed_ns;
    node.last_observed_ns = object.last_observed_ns;
  }
  return nodes;
}

void record(const Decision& decision, std::span<ShapeCandidate> candidates) {
  assert(decision.verdicts.size() == candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Decision::Verdict& verdict = decision.verdicts[i];
    candidates[i].accepted = verdict.accepted;
    candidates[i].reason = verdict.reason;
    candidates[i].object.reset();
    if (verdict.object >= 0) {
      candidates[i].object = objectNodeId(static_cast<std::uint64_t>(verdict.object));
    }
  }
}

std::string decisionNote(const Decision& decision) {
  std::map<std::string, std::size_t> rejected;  // by reason
  std::size_t num_accepted = 0;
  for (const Decision::Verdict& verdict : decision.verdicts) {
    verdict.accepted ? ++num_accepted : ++rejected[verdict.reason];
  }
  std::vector<std::string> reasons;
  for (const auto& [reason, count] : rejected)
    reasons.push_back(fmt::format("{} {}", count, reason));
  return fmt::format("{}{} of {} accepted, in {} objects; rejected: {}", kNotePrefix, num_accepted,
                     decision.verdicts.size(), decision.objects.size(),
                     reasons.empty() ? "none" : fmt::to_string(fmt::join(reasons, ", ")));
}

void redecide(Prediction& prediction, const DecisionConfig& config) {
  const Decision decision = decide(prediction.candidates, config);
  record(decision, prediction.candidates);
  prediction.graph.objects =
      objectNodes(prediction.candidates, decision, prediction.graph.label_space);
  for (std::string& note : prediction.notes) {
    if (note.starts_with(kNotePrefix)) note = decisionNote(decision);
  }
}

std::vector<std::string> decisionKeys() {
  return {"rmcc.check",
          "rmcc.min_overlap",
          "rmcc.min_coverage",
          "rmcc.max_depth_residual_m",
          "rmcc.max_depth_residual_share",
          "merge_revisited",
          "merge_evidence"};
}

void read(ConfigReader& reader, DecisionConfig& config) {
  auto rmcc = reader.section("rmcc");
  read(rmcc, config.rmcc);
  reader.choice("rejected", config.rejected, {"drop", "partial_mesh"});
  reader.field("merge_revisited", config.merge_revisited);
  reader.choice("merge_evidence", config.merge_evidence, {"view_volume", "overlap"});
}

}  // namespace hydrabench
