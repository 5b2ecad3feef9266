// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

inline constexpr const char* kPlacementTopic = "unit, axes and origin";

/// One thing that a prediction was looked through for.
struct SubmissionFinding {
  enum class Verdict {
    kPass,
    kWarning,  ///< odd, but a method may do so: it is scored
    kFail,     ///< a mistake of the whole prediction: its scores would say nothing of the method
  };
  std::string topic;  ///< what was looked at: "finite numbers", "unit, axes and origin", ...
  Verdict verdict = Verdict::kPass;
  std::string message;  ///< what was found, the evidence in numbers, the remedy; empty for kPass
};

/// Looks through a prediction for mistakes in how it was written down, before it is scored. One
/// finding per topic, in this order:
///
///  - finite numbers: a vertex or box that is not finite fails. The rest is skipped then.
///  - labels: fails where not one object has a label that the dataset knows; where names in the
///    prediction's own label space say that most objects carry another numbering; or where objects
///    stand in the right places and their labels are exchanged consistently (at least two classes
///    of 3 pairs or more, each at least 90 % under one other label, at most 10 % under their own;
///    the numbers exchanged among themselves, all shifted by the same, or unknown to the dataset).
///    Other labels than the dataset's are a warning. A method that confuses classes is not
///    consistent, one that knows a single class has no second one: neither is accused.
///  - unit, axes and origin: fails by the rule of placement_search.h, or by sizes alone: at least 3
///    sized objects whose median size, in terms of their class's, is 400 times too large or
///    small (no method mistakes a chair for a kilometre; fragments are not a thousandth), or off
///    by 40 while the objects' spread in space is off by the same within a factor of 2.5.
///  - each object once: pairs of a class with box IoU above 0.9 are a warning.
///  - closed meshes look outwards: others are a warning. Open meshes are not judged.
std::vector<SubmissionFinding> checkSubmission(const LabelSpace& label_space,
                                               const GroundTruth& truth,
                                               const Prediction& prediction);

}  // namespace hydrabench
