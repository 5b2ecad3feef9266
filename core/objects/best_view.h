// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/objects/frame_buffer.h"
#include "core/objects/max_iou_tracker.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// An observation of a track with the frame it was made in.
struct TrackView {
  std::shared_ptr<const BufferedFrame> frame;
  Observation observation;
  double volume_m3 = 0;  ///< how fully the object is seen, see seenVolume()
};

/// The paper's measure of how fully an object is seen (eq. 2): the volume of the axis-aligned box
/// around its points in the world [m^3].
///
/// A mask that reaches past the object's edge has points of what is behind, and a few of them make
/// the box many times too large; then the largest box is that of the worst mask. Beyond the paper,
/// such points can be cut off.
/// @param trim  share of the points to cut off at either end of each axis; 0: the box as it is.
///              Above, it is taken from some 2000 of the pixels.
double seenVolume(const Frame& frame, const ObjectCandidate& candidate, double trim);

/// The best views of a track, kept while it grows, so that a long track needs no more memory than a
/// short one.
///
/// The observations so far are cut into spans of equal length, at most max_views of them; of each
/// span the view with the largest box volume is kept, the earliest of equals. So the largest of all
/// is always there, and the others are spread over the track. With one observation too many, spans
/// double in length.
class BestViews {
 public:
  explicit BestViews(std::size_t max_views) : max_views_(max_views) {}  ///< at least 1

  /// Adds the next observation of the track.
  /// @param volume_m3  see TrackView
  /// @param frame  makes the frame to keep; called only where the view is kept
  void add(const Observation& observation, double volume_m3,
           const std::function<std::shared_ptr<const BufferedFrame>()>& frame);
  /// The best view first, then the others by descending volume, the earlier of equals first. Empty
  /// before the first add().
  std::vector<TrackView> ordered() const;

 private:
  std::size_t max_views_;
  std::size_t num_added_ = 0;
  std::size_t span_ = 1;          ///< observations per view
  std::vector<TrackView> views_;  ///< of the spans, in order of time
};

/// Ids of a frame's candidates with the pixels added that belong to their instances but measured no
/// depth: a candidate has measured pixels only, the mask of the paper is that of the instance.
/// @param candidates  taken from the frame's instances; moving ones stay as they are
Image<std::uint16_t> instanceMasks(const Frame& frame, const FrameCandidates& candidates);

/// What a shape estimator gets of a view: the frame's images and the object's pixels as a mask.
ShapeObservation shapeObservation(const TrackView& view, Label label);

}  // namespace hydrabench
