// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/graph/shape_candidate.h"
#include "core/objects/best_view.h"
#include "core/objects/max_iou_tracker.h"
#include "core/objects/rmcc.h"
#include "core/pipeline/stage_times.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// A track that has ended, with the views that were kept of it, the best one first.
struct EndedTrack {
  Track track;
  std::vector<TrackView> views;  ///< at least one
};

/// Shows the best views of a track to an estimator and scores what it says. A function of the track
/// alone: what is drawn at random depends on the track's id. Stages: estimate, the estimator's own
/// as estimate.NAME, rmcc.
///
/// No estimate comes of one whose mesh is empty or not finite or whose scale is not above zero; its
/// failure is then "unusable estimate".
ShapeCandidate estimateShape(const EndedTrack& ended, const ShapeEstimator& estimator,
                             const RmccConfig& rmcc, StageTimes& times);

}  // namespace hydrabench
