// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/hydra_plus_plus.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace hydrabench {
namespace {

/// The track's object as Khronos has it, from the views that were kept.
Mesh partialMesh(const EndedTrack& ended, const HydraPlusPlus::Config& config) {
  std::vector<TrackView> views = ended.views;
  std::sort(views.begin(), views.end(), [](const TrackView& a, const TrackView& b) {
    return a.observation.stamp_ns < b.observation.stamp_ns;
  });
  FrameBuffer frames(views.size());
  Track track = ended.track;
  track.observations.clear();
  for (TrackView& view : views) {
    frames.add(std::move(view.frame));
    track.observations.push_back(view.observation);
  }
  const ObjectReconstruction reconstruction(config.reconstruction);
  std::optional<Mesh> mesh =
      reconstruction
          .reconstruct(std::span(&track, 1), frames, config.min_range_m, config.max_range_m)
          .front();
  if (!mesh) return {};
  roundToFloat(*mesh);
  return std::move(*mesh);
}

}  // namespace

HydraPlusPlus::Config::Config() {
  window.window_s = 10;
  candidates.source = "instances";
  tracker.temporal_window_s = 10;
}

HydraPlusPlus::HydraPlusPlus(const Config& config, const LabelSpace& label_space,
                             std::shared_ptr<const ShapeEstimator> estimator)
    : config_(config),
      label_space_(label_space),
      estimator_(std::move(estimator)),
      front_end_(config, label_space),
      queue_(config.estimation.workers, static_cast<std::size_t>(config.estimation.queue)) {}

void HydraPlusPlus::process(const Frame& frame) {
  const FrameCandidates candidates = front_end_.process(frame, times_);
  keepViews(front_end_.objectFrame(frame), candidates);
  if (!front_end_.updateMesh(frame, times_)) return;
  estimateShapes(front_end_.tracker().takeEnded(frame.stamp_ns));
  collectEstimates(/*all=*/false);
}

SceneGraph HydraPlusPlus::finish() {
  front_end_.requireScans();
  estimateShapes(front_end_.tracker().takeAll());
  front_end_.window().finish();
  collectEstimates(/*all=*/true);

  const Decision decision = decide(candidates_, config_.decision);
  record(decision, candidates_);
  notes_ = {decisionNote(decision),
            fmt::format("no shape asked for: {} tracks seen too briefly, {} moving",
                        num_short_tracks_, num_moving_tracks_)};
  for (std::string& note : front_end_.lidarNotes()) notes_.push_back(std::move(note));
  SceneGraph graph;
  graph.label_space = label_space_;
  graph.objects = objectNodes(candidates_, decision, label_space_);
  graph.scene_mesh = front_end_.window().mesh().mesh(&graph.scene_labels);
  graph.occupied = front_end_.window().takeOccupied();
  graph.occupied_voxel_m = config_.window.tsdf.voxel_size_m;
  return graph;
}

void HydraPlusPlus::keepViews(const Frame& frame, const FrameCandidates& candidates) {
  const StageTimes::Scope stage(times_, "views");
  std::shared_ptr<const BufferedFrame> kept;  // made once, if any track wants it
  const auto keep = [&] {
    if (!kept) {
      kept = bufferedFrame(frame, config_.candidates.source == "instances"
                                      ? instanceMasks(frame, candidates)
                                      : candidates.ids);
    }
    return kept;
  };
  for (const Track& track : front_end_.tracker().tracks()) {
    if (track.dynamic || track.lastSeenNs() != frame.stamp_ns) continue;
    const auto views = views_.try_emplace(track.id, viewsPerTrack()).first;
    const Observation& seen = track.observations.back();
    const ObjectCandidate& candidate = candidates.candidates.at(seen.candidate_id - 1u);
    views->second.add(seen, seenVolume(frame, candidate, config_.best_view_trim), keep);
  }
}

void HydraPlusPlus::estimateShapes(std::vector<Track> ended) {
  const StageTimes::Scope stage(times_, "hand_over");  // waiting for the queue included
  for (Track& track : ended) {
    const auto views = views_.extract(track.id);
    if (track.dynamic || !(front_end_.tracker().confidence(track) > config_.min_track_confidence)) {
      ++(track.dynamic ? num_moving_tracks_ : num_short_tracks_);
      continue;
    }
    auto job =
        std::make_shared<const EndedTrack>(EndedTrack{std::move(track), views.mapped().ordered()});
    queue_.submit([this, job = std::move(job)] { return estimated(*job); });
  }
}

HydraPlusPlus::Estimated HydraPlusPlus::estimated(const EndedTrack& ended) const {
  Estimated result;
  result.candidate = estimateShape(ended, *estimator_, config_.decision.rmcc, result.times);
  if (config_.decision.rejected == "partial_mesh") {
    const StageTimes::Scope stage(result.times, "partial_mesh");
    result.candidate.partial_mesh = partialMesh(ended, config_);
  }
  return result;
}

void HydraPlusPlus::collectEstimates(bool all) {
  while (all ? queue_.size() > 0 : queue_.ready()) {
    Estimated estimated = queue_.take();
    candidates_.push_back(std::move(estimated.candidate));
    for (const StageTimes::Stage& stage : estimated.times.stages()) {
      for (const StageTimes::Sample& sample : stage.samples) times_.add(stage.name, sample);
    }
  }
}

std::size_t HydraPlusPlus::viewsPerTrack() const {
  const int for_estimate = 1 + std::max(0, estimator_->maxOtherViews());
  const bool partial = config_.decision.rejected == "partial_mesh";
  return static_cast<std::size_t>(std::max(for_estimate, partial ? config_.partial_views : 1));
}

std::size_t HydraPlusPlus::numKeptFrames() const {
  std::set<std::int64_t> stamps;
  for (const auto& [track, views] : views_) {
    for (const TrackView& view : views.ordered()) stamps.insert(view.observation.stamp_ns);
  }
  return stamps.size();
}

void read(ConfigReader& reader, HydraPlusPlus::Config& config) {
  read(reader, static_cast<ObjectFrontEnd::Config&>(config));
  reader.field("min_track_confidence", config.min_track_confidence, Bounds{0, 1});
  reader.field("best_view_trim", config.best_view_trim, Bounds{0, 0.49});
  auto estimation = reader.section("estimation");
  estimation.field("workers", config.estimation.workers, Bounds{0, 256});
  estimation.field("queue", config.estimation.queue, Bounds{1, 1e6});
  read(reader, config.decision);
  reader.field("partial_views", config.partial_views, Bounds{1, 1000});
  auto reconstruction = reader.section("reconstruction");
  read(reconstruction, config.reconstruction);
}

}  // namespace hydrabench
