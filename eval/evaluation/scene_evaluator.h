// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"
#include "eval/evaluation/scene_config.h"
#include "metrics/scene_tally.h"

namespace hydrabench {

/// Scores maps of one world as a whole.
///
/// What counts of the true surface is what was in view: points with a free line of sight from a
/// place on the path within radius_m, whatever sensor looked from there, so that all methods answer
/// for the same surface.
class SceneEvaluator {
 public:
  /// Throws InputError where the ground truth has no scene mesh, no label of its faces, no path, or
  /// none of the classes that are ground.
  SceneEvaluator(const GroundTruth& truth, const LabelSpace& label_space,
                 const SceneScoringConfig& config);
  ~SceneEvaluator();
  SceneEvaluator(SceneEvaluator&&) noexcept;
  SceneEvaluator& operator=(SceneEvaluator&&) noexcept;

  /// One tally per square, in a fixed order; the same squares for every map.
  std::vector<SceneTally> evaluate(const SceneGraph& map) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench
