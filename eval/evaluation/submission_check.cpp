// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/submission_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/geometry/median.h"
#include "core/geometry/mesh_topology.h"
#include "eval/evaluation/label_check.h"
#include "eval/evaluation/placement_search.h"
#include "metrics/detection.h"

namespace hydrabench {
namespace {

using Verdict = SubmissionFinding::Verdict;

bool isFinite(const ObjectNode& node) {
  if (node.mesh.vertices.empty()) {
    return node.box.isEmpty() || (node.box.min().allFinite() && node.box.max().allFinite());
  }
  return std::all_of(node.mesh.vertices.begin(), node.mesh.vertices.end(),
                     [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); });
}

SubmissionFinding checkFinite(const Prediction& prediction) {
  SubmissionFinding finding{"finite numbers", Verdict::kPass, ""};
  for (const ObjectNode& node : prediction.graph.objects) {
    if (isFinite(node)) continue;
    finding.verdict = Verdict::kFail;
    finding.message =
        fmt::format("object {} '{}': a coordinate is not a finite number; leave such objects out",
                    node.id, node.name);
    break;
  }
  return finding;
}

std::optional<PlacedObject> placedObject(const ObjectNode& node) {
  const Aabb box = node.mesh.vertices.empty() ? node.box : objectBox(node.mesh);
  if (box.isEmpty()) return std::nullopt;
  return PlacedObject{node.label, box.center(), halfDiagonal(box)};
}

double spread(const std::vector<PlacedObject>& objects) {
  std::vector<Eigen::Vector3d> centers;
  for (const PlacedObject& object : objects) centers.push_back(object.center);
  const Eigen::Vector3d middle = median(centers);
  std::vector<double> distances;
  for (const PlacedObject& object : objects) distances.push_back((object.center - middle).norm());
  return median(std::move(distances));
}

/// What objects of this size would be right in, and the factor to metres.
struct Unit {
  const char* name;
  double metres;
};
Unit unitOf(double times_too_large) {
  for (const Unit& unit :
       {Unit{"millimetres", 0.001}, Unit{"centimetres", 0.01}, Unit{"kilometres", 1000.0}}) {
    const double rest = times_too_large * unit.metres;
    if (rest > 1.0 / 3 && rest < 3) return unit;
  }
  return {"another unit", 1 / times_too_large};
}

/// Sizes do not ask who matches whom: they tell even where a method found nothing.
std::optional<std::string> unitBySizes(const std::vector<PlacedObject>& estimates,
                                       const std::vector<PlacedObject>& truths) {
  std::map<Label, std::vector<double>> sizes;
  for (const PlacedObject& object : truths) sizes[object.label].push_back(object.half_diagonal);
  std::vector<double> ratios;
  for (const PlacedObject& object : estimates) {
    const auto of_class = sizes.find(object.label);
    if (object.half_diagonal <= 0 || of_class == sizes.end()) continue;
    const double size = median(of_class->second);
    if (size > 0) ratios.push_back(object.half_diagonal / size);
  }
  if (ratios.size() < 3) return std::nullopt;
  const double size_ratio = median(ratios);
  const double extreme = std::max(size_ratio, 1 / size_ratio);
  const double truth_spread = spread(truths);
  const double spread_ratio = truth_spread > 0 ? spread(estimates) / truth_spread : 0;
  const bool same =
      spread_ratio > 0 && size_ratio / spread_ratio < 2.5 && spread_ratio / size_ratio < 2.5;
  if (!(extreme > 400 || (extreme > 40 && same))) return std::nullopt;
  const Unit unit = unitOf(size_ratio);
  // Few objects of a poor method spread by chance: positions are in the unit that is nearer.
  const bool everything = spread_ratio > 0 && std::log(spread_ratio) / std::log(size_ratio) > 0.5;
  return fmt::format(
      "{} in {}: the median object is {:.3g} times the size of its class (of {}), the objects "
      "spread over {:.3g} times the space; multiply {} by {:.3g}",
      everything ? "positions and meshes" : "meshes", unit.name, size_ratio, ratios.size(),
      spread_ratio, everything ? "everything" : "the mesh points about the centre of their box",
      unit.metres);
}

/// "(x, z, -y)": what the axes of the world are in those of the prediction.
std::string axesText(const Eigen::Matrix3d& axes) {
  std::vector<std::string> names;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      if (axes(row, column) != 0) {
        names.push_back(fmt::format("{}{}", axes(row, column) < 0 ? "-" : "", "xyz"[column]));
      }
    }
  }
  return fmt::format("({})", fmt::join(names, ", "));
}

std::string axesMistake(const Eigen::Matrix3d& axes) {
  std::string what = axes.determinant() < 0 ? "mirrored" : "turned";
  if (axes(2, 0) != 0) what += axes(2, 0) > 0 ? ", x points up" : ", x points down";
  if (axes(2, 1) != 0) what += axes(2, 1) > 0 ? ", y points up" : ", y points down";
  if (axes(2, 2) < 0) what += ", upside down";
  return what;
}

std::string misplacementText(const Misplacement& found) {
  const Placement& placement = found.placement;
  std::vector<std::string> mistakes;
  std::vector<std::string> remedies;
  if (placement.unit_m != 1) {
    mistakes.push_back("in " + std::string(unitOf(1 / placement.unit_m).name));
    remedies.push_back(fmt::format("multiply positions and meshes by {:g}", placement.unit_m));
  }
  if (placement.frame == Placement::Frame::kWorld && !placement.axes.isIdentity()) {
    mistakes.push_back(axesMistake(placement.axes));
    remedies.push_back(fmt::format("replace (x, y, z) by {}", axesText(placement.axes)));
  }
  if (placement.moved) {
    mistakes.push_back("about another origin");
    remedies.push_back(fmt::format("add ({:.2f}, {:.2f}, {:.2f}) m", placement.offset.x(),
                                   placement.offset.y(), placement.offset.z()));
  }
  if (placement.frame == Placement::Frame::kFirstCamera) {
    mistakes.push_back(placement.axes.isIdentity()
                           ? "in the frame of the first camera"
                           : "in the frame of the first camera with x forward and z up");
    remedies.push_back("apply the pose of frame 0");
  }
  if (placement.frame == Placement::Frame::kFirstHeading) {
    mistakes.push_back("in a level frame at the start of the sequence");
    remedies.push_back("apply place and heading of frame 0");
  }
  if (placement.doubled_positions) {
    mistakes.push_back("at twice the distance from the origin");
    remedies.push_back("give mesh points relative to the centre of their box");
  }
  return fmt::format(
      "{}: {} of {} objects agree with the ground truth after the change, {} without; {}",
      fmt::join(mistakes, " and "), found.matches, found.possible, found.matches_as_is,
      fmt::join(remedies, ", then "));
}

SubmissionFinding checkPlacement(const LabelSpace& label_space, const GroundTruth& truth,
                                 const Prediction& prediction) {
  std::vector<PlacedObject> estimates;
  for (const ObjectNode& node : prediction.graph.objects) {
    if (const auto placed = placedObject(node)) estimates.push_back(*placed);
  }
  std::vector<PlacedObject> truths;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space.find(object.label);
    if (!entry || !entry->is_object || object.mesh->vertices.empty()) continue;
    const Aabb box = objectBox(transformed(object.T_world_object, *object.mesh));
    truths.push_back({object.label, box.center(), halfDiagonal(box)});
  }
  SubmissionFinding finding{kPlacementTopic, Verdict::kPass, ""};
  std::optional<Transform> start;
  if (!truth.trajectory.empty()) start = truth.trajectory.front().T_world_camera;
  if (const auto found = findMisplacement(estimates, truths, start)) {
    finding.message = misplacementText(*found);
  } else if (!truths.empty()) {
    finding.message = unitBySizes(estimates, truths).value_or("");
  }
  if (!finding.message.empty()) finding.verdict = Verdict::kFail;
  return finding;
}

SubmissionFinding checkDuplicates(const Prediction& prediction) {
  std::map<Label, std::vector<std::pair<Aabb, const ObjectNode*>>> by_label;
  std::size_t twice = 0;
  std::string example;
  for (const ObjectNode& node : prediction.graph.objects) {
    const Aabb box = node.mesh.vertices.empty() ? node.box : objectBox(node.mesh);
    if (box.isEmpty()) continue;
    auto& earlier = by_label[node.label];
    const auto same = std::find_if(earlier.begin(), earlier.end(), [&](const auto& other) {
      return boxIou(other.first, box) > 0.9;
    });
    if (same != earlier.end() && twice++ == 0) {
      example = fmt::format("{} '{}' and {} '{}'", same->second->id, same->second->name, node.id,
                            node.name);
    }
    earlier.emplace_back(box, &node);
  }
  if (twice == 0) return {"each object once", Verdict::kPass, ""};
  return {"each object once", Verdict::kWarning,
          fmt::format("{} of {} objects stand where another of their class stands (box IoU above "
                      "0.9), e.g. {}; one_to_one counts them as wrong",
                      twice, prediction.graph.objects.size(), example)};
}

SubmissionFinding checkWinding(const Prediction& prediction) {
  std::size_t inverted = 0;
  std::string example;
  for (const ObjectNode& node : prediction.graph.objects) {
    // Whether it is closed takes longer to see than the sign of its volume, which an open mesh has
    // by chance.
    if (node.mesh.empty() || signedVolume(node.mesh) >= 0) continue;
    if (!analyzeTopology(node.mesh).watertight()) continue;
    if (inverted++ == 0) example = fmt::format("{} '{}'", node.id, node.name);
  }
  if (inverted == 0) return {"closed meshes look outwards", Verdict::kPass, ""};
  return {"closed meshes look outwards", Verdict::kWarning,
          fmt::format("{} of {} objects are closed meshes turned inside out, e.g. {}; scored as if "
                      "turned back, but reverse the order of the indices of every face",
                      inverted, prediction.graph.objects.size(), example)};
}

}  // namespace

std::vector<SubmissionFinding> checkSubmission(const LabelSpace& label_space,
                                               const GroundTruth& truth,
                                               const Prediction& prediction) {
  std::vector<SubmissionFinding> findings = {checkFinite(prediction)};
  if (findings.back().verdict == Verdict::kFail) return findings;
  findings.push_back(checkLabels(label_space, truth, prediction));
  // Where classes are not what they are called, who matches whom means nothing.
  if (findings.back().verdict != Verdict::kFail) {
    findings.push_back(checkPlacement(label_space, truth, prediction));
  }
  findings.push_back(checkDuplicates(prediction));
  findings.push_back(checkWinding(prediction));
  return findings;
}

}  // namespace hydrabench
