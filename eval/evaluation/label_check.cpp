// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/label_check.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "metrics/detection.h"

namespace hydrabench {
namespace {

using Verdict = SubmissionFinding::Verdict;
using LabelCounts = std::map<Label, std::size_t>;

LabelCounts countLabels(const Prediction& prediction) {
  LabelCounts counts;
  for (const ObjectNode& node : prediction.graph.objects) ++counts[node.label];
  return counts;
}

/// "5 chair, 7 couch": what can be found.
std::string expectedLabels(const LabelSpace& label_space) {
  std::vector<std::string> names;
  for (const LabelSpace::Entry& entry : label_space.entries) {
    if (entry.is_scored) names.push_back(fmt::format("{} {}", entry.label, entry.name));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The names a file gives to its labels are its own word for it.
std::optional<std::string> otherNumberingByName(const LabelSpace& label_space,
                                                const Prediction& prediction,
                                                const LabelCounts& counts) {
  std::size_t renumbered = 0;
  std::vector<std::string> pairs;
  for (const auto& [label, count] : counts) {
    const LabelSpace::Entry* theirs = prediction.graph.label_space.find(label);
    if (!theirs || theirs->name.empty()) continue;
    const LabelSpace::Entry* meant = label_space.find(theirs->name);
    const LabelSpace::Entry* ours = label_space.find(label);
    if (!meant || (ours && ours->name == theirs->name)) continue;
    renumbered += count;
    pairs.push_back(fmt::format("{} for {} ({} here)", label, theirs->name, meant->label));
  }
  const std::size_t all = prediction.graph.objects.size();
  if (2 * renumbered <= all) return std::nullopt;
  if (pairs.size() > 4) pairs.resize(4);
  return fmt::format(
      "another numbering: {} of {} objects have a label that stands for another class: "
      "{}; write the dataset's labels",
      renumbered, all, fmt::join(pairs, ", "));
}

struct Site {
  Label label = kUnknownLabel;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double gate = 0;
};

/// Labels of objects that stand in one place, whatever they are called: estimate first.
std::map<Label, LabelCounts> coincidences(const LabelSpace& label_space, const GroundTruth& truth,
                                          const Prediction& prediction) {
  std::vector<Site> truths;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space.find(object.label);
    if (!entry || !entry->is_object || object.mesh->vertices.empty()) continue;
    const Aabb box = objectBox(transformed(object.T_world_object, *object.mesh));
    truths.push_back({object.label, box.center(), std::max(0.2, halfDiagonal(box) / 2)});
  }
  std::map<Label, LabelCounts> table;
  for (const ObjectNode& node : prediction.graph.objects) {
    const Aabb box = node.mesh.vertices.empty() ? node.box : objectBox(node.mesh);
    if (box.isEmpty()) continue;
    const auto nearest =
        std::min_element(truths.begin(), truths.end(), [&](const Site& a, const Site& b) {
          return (a.center - box.center()).squaredNorm() < (b.center - box.center()).squaredNorm();
        });
    if (nearest == truths.end()) continue;
    if ((nearest->center - box.center()).norm() < nearest->gate)
      ++table[node.label][nearest->label];
  }
  return table;
}

std::optional<std::string> otherNumberingByPlace(const LabelSpace& label_space,
                                                 const GroundTruth& truth,
                                                 const Prediction& prediction) {
  std::size_t pairs = 0;
  std::size_t own = 0;
  std::set<Label> used;
  std::set<Label> meant;
  std::set<std::int64_t> shifts;
  bool any_unknown = false;
  std::vector<std::string> names;
  for (const auto& [label, truths] : coincidences(label_space, truth, prediction)) {
    std::size_t sum = 0;
    for (const auto& [true_label, count] : truths) sum += count;
    pairs += sum;
    const auto self = truths.find(label);
    if (self != truths.end()) own += self->second;
    if (sum < 3) continue;
    const auto most =
        std::max_element(truths.begin(), truths.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most->first == label || 10 * most->second < 9 * sum) return std::nullopt;
    if (!meant.insert(most->first).second) return std::nullopt;
    used.insert(label);
    shifts.insert(static_cast<std::int64_t>(label) - static_cast<std::int64_t>(most->first));
    any_unknown |= label_space.find(label) == nullptr;
    names.push_back(fmt::format("{} for {} {} ({} of {})", label, most->first,
                                label_space.nameOf(most->first), most->second, sum));
  }
  if (names.size() < 2 || 10 * own > pairs) return std::nullopt;
  // Who calls every armchair a chair and every desk a table takes one thing for another; numbers
  // that are exchanged, shifted or foreign are another list.
  if (used != meant && shifts.size() != 1 && !any_unknown) return std::nullopt;
  return fmt::format(
      "another numbering: objects stand in the right places under exchanged labels: {}; write the "
      "dataset's labels",
      fmt::join(names, ", "));
}

}  // namespace

SubmissionFinding checkLabels(const LabelSpace& label_space, const GroundTruth& truth,
                              const Prediction& prediction) {
  SubmissionFinding finding{"labels", Verdict::kPass, ""};
  const LabelCounts counts = countLabels(prediction);
  std::vector<Label> unknown;
  std::size_t of_unknown = 0;
  for (const auto& [label, count] : counts) {
    if (label_space.find(label)) continue;
    unknown.push_back(label);
    of_unknown += count;
  }
  const std::size_t all = prediction.graph.objects.size();
  std::optional<std::string> numbering = otherNumberingByName(label_space, prediction, counts);
  if (!numbering) numbering = otherNumberingByPlace(label_space, truth, prediction);
  if (unknown.size() > 6) unknown.resize(6);
  if (numbering) {
    finding = {finding.topic, Verdict::kFail, *numbering};
  } else if (all > 0 && of_unknown == all) {
    finding = {finding.topic, Verdict::kFail,
               fmt::format("none of {} objects has a label of this dataset: {}; expected {}", all,
                           fmt::join(unknown, ", "), expectedLabels(label_space))};
  } else if (of_unknown > 0) {
    finding = {finding.topic, Verdict::kWarning,
               fmt::format("{} of {} objects have labels that this dataset does not know: {}; they "
                           "are left out",
                           of_unknown, all, fmt::join(unknown, ", "))};
  }
  return finding;
}

}  // namespace hydrabench
