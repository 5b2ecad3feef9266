// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/config/config_reader.h"
#include "core/objects/best_view.h"
#include "core/objects/object_reconstruction.h"
#include "core/parallel/work_queue.h"
#include "core/pipeline/candidate_decision.h"
#include "core/pipeline/mapping_system.h"
#include "core/pipeline/object_front_end.h"
#include "core/pipeline/shape_estimation.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// Hydra++ of the paper: a track that has ended is shown, in the view in which its object is seen
/// best, to a shape estimator; the shape must agree with the mask it was estimated from (RMCC);
/// what passes is an object of the scene graph.
///
///     frame -> motion, candidates, tracks, active window (ObjectFrontEnd)
///           -> best views of every track (BestViews)
///     track ended -> ShapeEstimator -> RMCC scores -> ShapeCandidate (WorkQueue)
///     end of run  -> decide(): RMCC verdicts, merging -> objects
///
/// What the paper leaves open, and how it is filled here:
///  - An object needs as many observations as in Khronos, whose tracker this is.
///  - Objects seen again later are merged by the rule of Hydra's backend, see candidate_decision.h.
///    What was decided is carried out once, at the end of the run, in the order of the tracks.
///  - The active window ends 10 s after a place was last seen, when the tracks do: the paper's one
///    "temporal window" for both.
///  - Moving things are tracked, but no shape is estimated for them.
///  - Of a track only its best views are kept (BestViews); the best of all is always among them.
///  - Limits of pixels and box volume of a candidate are not published: 50 pixels as in Khronos, no
///    limit of volume.
/// And as in Khronos here: poses are given and fixed, there are no loop closures, places or rooms.
/// With a lidar (LidarInput) the map is made from its sweeps, with a wider band behind the ground.
///
/// Estimates are made off the mapping thread. Their results are taken in the order of the tracks,
/// and each is a function of its track alone: timing and numbers of threads change nothing.
class HydraPlusPlus : public MappingSystem {
 public:
  /// As indoors in the paper's list of parameters.
  struct Config : ObjectFrontEnd::Config {
    Config();
    double min_track_confidence = 0.5;  ///< strictly above, or the track is no object
    /// See seenVolume(); 0: the box of all points (paper).
    double best_view_trim = 0;
    struct Estimation {
      int workers = 1;  ///< threads; 0: the mapping thread itself, and mapping waits
      int queue = 16;   ///< tracks that may wait for one; then mapping waits
    } estimation;
    DecisionConfig decision;
    /// For rejected: partial_mesh: from how many views of a track, and how.
    int partial_views = 8;
    ObjectReconstruction::Config reconstruction;
  };
  HydraPlusPlus(const Config& config, const LabelSpace& label_space,
                std::shared_ptr<const ShapeEstimator> estimator);

  /// Throws InputError where the frame lacks the image that the candidates are taken from, and what
  /// the estimator threw for an earlier frame.
  void process(const Frame& frame) override;
  SceneGraph finish() override;
  const StageTimes& stageTimes() const override { return times_; }
  /// How many tracks came to what; after finish().
  std::vector<std::string> notes() const override { return notes_; }
  std::vector<ShapeCandidate> takeCandidates() override { return std::move(candidates_); }

  std::size_t numKeptFrames() const;  ///< that views of open tracks refer to

 private:
  struct Estimated {
    ShapeCandidate candidate;
    StageTimes times;
  };
  void keepViews(const Frame& frame, const FrameCandidates& candidates);
  void estimateShapes(std::vector<Track> ended);
  Estimated estimated(const EndedTrack& ended) const;  ///< on a worker's thread
  void collectEstimates(bool all);
  std::size_t viewsPerTrack() const;

  Config config_;
  LabelSpace label_space_;
  std::shared_ptr<const ShapeEstimator> estimator_;
  ObjectFrontEnd front_end_;
  std::map<std::uint64_t, BestViews> views_;  ///< by track
  std::vector<ShapeCandidate> candidates_;    ///< in order of their tracks' ends
  std::size_t num_moving_tracks_ = 0;
  std::size_t num_short_tracks_ = 0;
  StageTimes times_;
  std::vector<std::string> notes_;
  WorkQueue<Estimated> queue_;  ///< last: its threads end before what they read goes
};

void read(ConfigReader& reader, HydraPlusPlus::Config& config);

}  // namespace hydrabench
