// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/box.h"
#include "core/mapping/sensor_view.h"
#include "core/objects/object_candidate.h"

namespace hydrabench {

/// One candidate of one frame, as part of a track.
struct Observation {
  std::int64_t stamp_ns = 0;
  std::uint16_t candidate_id = 0;  ///< in the id image of that frame
  Aabb box;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::size_t pixels = 0;
};

/// One object followed through frames.
struct Track {
  std::uint64_t id = 0;
  Label label = kUnknownLabel;
  bool dynamic = false;
  std::vector<Observation> observations;
  std::vector<GlobalVoxel> last_voxels;
  std::vector<Eigen::Vector3f> last_points;  ///< world [m]; only when tracking by pixels

  std::int64_t firstSeenNs() const { return observations.front().stamp_ns; }
  std::int64_t lastSeenNs() const { return observations.back().stamp_ns; }
  const Aabb& lastBox() const { return observations.back().box; }
};

/// Associates candidates with tracks by the overlap with the track's last observation (Khronos'
/// MaxIoUTracker; paper, "Object Tracking").
class MaxIouTracker {
 public:
  struct Config {
    std::string track_by = "voxels";   ///< voxels, pixels or boxes
    double min_same_label_iou = 0.25;  ///< strictly above
    double min_cross_iou = 0.1;        ///< between a moving track and a candidate of a class
    double max_dynamic_distance_m = 1;
    double temporal_window_s = 3;  ///< a track ends when it was not seen for this long
    int min_observations = 15;     ///< confidence reaches 0.5 here
  };
  explicit MaxIouTracker(const Config& config) : config_(config) {}

  /// Frames in order of their stamps.
  void update(const SensorView& view, const FrameCandidates& candidates);
  /// Takes out the tracks that have ended by now, in order of their ids.
  std::vector<Track> takeEnded(std::int64_t stamp_ns);
  /// Takes out all that are left: the end of a run.
  std::vector<Track> takeAll();

  const std::vector<Track>& tracks() const { return tracks_; }
  /// min(observations / (2 min_observations), 1)
  double confidence(const Track& track) const;

 private:
  Config config_;
  std::vector<Track> tracks_;  ///< ascending ids
  std::uint64_t next_id_ = 0;
};

void read(ConfigReader& reader, MaxIouTracker::Config& config);

}  // namespace hydrabench
