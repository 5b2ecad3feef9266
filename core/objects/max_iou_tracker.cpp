// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/max_iou_tracker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "core/objects/pixel_groups.h"

namespace hydrabench {
namespace {

/// Of two sorted sets without repetition.
template <typename T, typename Less>
double sortedSetIou(const std::vector<T>& a, const std::vector<T>& b, const Less& less) {
  std::size_t both = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (less(*i, *j)) {
      ++i;
    } else if (less(*j, *i)) {
      ++j;
    } else {
      ++both, ++i, ++j;
    }
  }
  const std::size_t any = a.size() + b.size() - both;
  return any == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(any);
}

/// Pixels that points fall on, ascending, each once; points outside the image have none.
std::vector<std::uint32_t> projected(const std::vector<Eigen::Vector3d>& points,
                                     const SensorView& view) {
  const Transform T_sensor_world = view.T_world_sensor.inverse();
  std::vector<std::uint32_t> pixels;
  for (const Eigen::Vector3d& point : points) {
    const auto pixel = view.camera.project(T_sensor_world * point);
    if (!pixel || !view.camera.sees(*pixel)) continue;
    const int u = static_cast<int>(std::floor(pixel->x() + 0.5));
    const int v = static_cast<int>(std::floor(pixel->y() + 0.5));
    pixels.push_back(static_cast<std::uint32_t>(v * view.camera.width + u));
  }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

/// Associates the candidates of one frame.
class Association {
 public:
  Association(const MaxIouTracker::Config& config, const SensorView& view,
              const FrameCandidates& frame, std::vector<Track>& tracks, std::uint64_t& next_id)
      : config_(config),
        view_(view),
        candidates_(frame.candidates),
        tracks_(tracks),
        next_id_(next_id),
        taken_(candidates_.size(), 0) {}

  void followMovingTracks() {
    for (Track& track : tracks_) {
      if (!track.dynamic) continue;
      std::optional<std::size_t> nearest;
      double nearest_m = config_.max_dynamic_distance_m;
      for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (taken_[i] || !candidates_[i].dynamic) continue;
        const double distance_m =
            (candidates_[i].centroid - track.observations.back().centroid).norm();
        if (distance_m < nearest_m) {
          nearest = i;
          nearest_m = distance_m;
        }
      }
      if (nearest) observe(*nearest, track);
    }
    beginTracks(/*dynamic=*/true);
  }

  void giveClassesToMovingTracks() {
    for (Track& track : tracks_) {
      if (!track.dynamic) continue;
      const auto best = mostOverlapping(track, config_.min_cross_iou, std::nullopt);
      if (!best) continue;
      if (track.label == kUnknownLabel) track.label = candidates_[*best].label;
      if (track.lastSeenNs() == view_.stamp_ns) {
        taken_[*best] = 1;  // part of what was observed already
      } else {
        observe(*best, track);
      }
    }
  }

  void followTracks() {
    for (Track& track : tracks_) {
      if (track.dynamic) continue;
      const auto best = mostOverlapping(track, config_.min_same_label_iou, track.label);
      if (best) observe(*best, track);
    }
    beginTracks(/*dynamic=*/false);
  }

 private:
  /// The candidate, not moving, that overlaps a track most, if more than min_iou; the first of
  /// several.
  std::optional<std::size_t> mostOverlapping(const Track& track, double min_iou,
                                             std::optional<Label> label) const {
    std::vector<std::uint32_t> track_pixels;
    if (config_.track_by == "pixels") track_pixels = projected(track.last_points, view_);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ObjectCandidate& candidate = candidates_[i];
      if (taken_[i] || candidate.dynamic || (label && candidate.label != *label)) continue;
      const double iou = overlap(track, track_pixels, candidate);
      if (iou > min_iou) {
        best = i;
        min_iou = iou;
      }
    }
    return best;
  }

  double overlap(const Track& track, const std::vector<std::uint32_t>& track_pixels,
                 const ObjectCandidate& candidate) const {
    if (config_.track_by == "instances") {
      const bool same = candidate.instance == track.last_instance;
      return same && candidate.instance != kNoInstance ? 1.0 : 0.0;
    }
    if (config_.track_by == "boxes") return boxIou(track.lastBox(), candidate.box);
    if (config_.track_by == "pixels") {
      return sortedSetIou(track_pixels, candidate.pixels, std::less<>());
    }
    return voxelSetIou(track.last_voxels, candidate.voxels);
  }

  void observe(std::size_t i, Track& track) {
    const ObjectCandidate& candidate = candidates_[i];
    taken_[i] = 1;
    track.observations.push_back({.stamp_ns = view_.stamp_ns,
                                  .candidate_id = candidate.id,
                                  .region = candidate.region,
                                  .box = candidate.box,
                                  .centroid = candidate.centroid,
                                  .pixels = candidate.pixels.size()});
    track.last_instance = candidate.instance;
    track.last_voxels = candidate.voxels;
    if (config_.track_by != "pixels") return;
    const PixelPoints points(view_);
    track.last_points.clear();
    for (const std::uint32_t pixel : candidate.pixels) {
      track.last_points.push_back(points(pixel));
    }
  }

  void beginTracks(bool dynamic) {
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (taken_[i] || candidates_[i].dynamic != dynamic) continue;
      Track& track = tracks_.emplace_back();
      track.id = next_id_++;
      track.label = candidates_[i].label;
      track.dynamic = dynamic;
      observe(i, track);
    }
  }

  const MaxIouTracker::Config& config_;
  const SensorView& view_;
  const std::vector<ObjectCandidate>& candidates_;
  std::vector<Track>& tracks_;
  std::uint64_t& next_id_;
  std::vector<char> taken_;
};

}  // namespace

double voxelSetIou(const std::vector<GlobalVoxel>& a, const std::vector<GlobalVoxel>& b) {
  return sortedSetIou(a, b, IndexLess());
}

void MaxIouTracker::update(const SensorView& view, const FrameCandidates& candidates) {
  Association association(config_, view, candidates, tracks_, next_id_);
  association.followMovingTracks();
  association.giveClassesToMovingTracks();
  association.followTracks();
}

std::vector<Track> MaxIouTracker::takeEnded(std::int64_t stamp_ns) {
  const auto window_ns = static_cast<std::int64_t>(std::llround(config_.temporal_window_s * 1e9));
  const auto first_ended = std::stable_partition(
      tracks_.begin(), tracks_.end(),
      [&](const Track& track) { return track.lastSeenNs() >= stamp_ns - window_ns; });
  std::vector<Track> ended(std::make_move_iterator(first_ended),
                           std::make_move_iterator(tracks_.end()));
  tracks_.erase(first_ended, tracks_.end());
  return ended;
}

std::vector<Track> MaxIouTracker::takeAll() { return std::exchange(tracks_, {}); }

std::vector<std::int64_t> MaxIouTracker::observedStamps() const {
  std::vector<std::int64_t> stamps;
  for (const Track& track : tracks_) {
    for (const Observation& observation : track.observations) {
      stamps.push_back(observation.stamp_ns);
    }
  }
  std::sort(stamps.begin(), stamps.end());
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  return stamps;
}

double MaxIouTracker::confidence(const Track& track) const {
  return std::min(
      1.0, static_cast<double>(track.observations.size()) / (2.0 * config_.min_observations));
}

void read(ConfigReader& reader, MaxIouTracker::Config& config) {
  reader.choice("track_by", config.track_by, {"voxels", "pixels", "boxes", "instances"});
  reader.field("min_same_label_iou", config.min_same_label_iou, Bounds{0, 1});
  reader.field("min_cross_iou", config.min_cross_iou, Bounds{0, 1});
  reader.field("max_dynamic_distance_m", config.max_dynamic_distance_m, Bounds{0, 1000});
  reader.field("temporal_window_s", config.temporal_window_s, Bounds{0, 1e6});
  reader.field("min_observations", config.min_observations, Bounds{1, 1e6});
}

}  // namespace hydrabench
