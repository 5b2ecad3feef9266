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
  ImageRegion region;              ///< around its pixels
  Aabb box;                        ///< world [m]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::size_t pixels = 0;
};

/// One object followed through frames.
struct Track {
  std::uint64_t id = 0;
  Label label = kUnknownLabel;
  bool dynamic = false;
  std::vector<Observation> observations;
  InstanceId last_instance = kNoInstance;
  std::vector<GlobalVoxel> last_voxels;
  std::vector<Eigen::Vector3d> last_points;  ///< world [m]; only when tracking by pixels

  std::int64_t firstSeenNs() const { return observations.front().stamp_ns; }
  std::int64_t lastSeenNs() const { return observations.back().stamp_ns; }
  const Aabb& lastBox() const { return observations.back().box; }
};

/// Associates candidates with tracks by their overlap with the track's last observation (Khronos'
/// MaxIoUTracker; paper, "A max-IoU tracker then associates clusters across frames").
///
/// Greedy, in the order of the tracks' ids:
///  1. a moving track takes the nearest moving candidate within max_dynamic_distance_m; moving
///     candidates that are left begin tracks;
///  2. a moving track takes the candidate of a class that overlaps it most, above min_cross_iou. It
///     becomes the track's observation, unless step 1 gave one, and in any case its class that of a
///     track without one, and no track of its own;
///  3. a track of a class takes the candidate of that class that overlaps it most, above
///     min_same_label_iou; candidates that are left begin tracks.
///
/// "Cross" is read as Khronos' code has it: a moving thing against a candidate of a class. The
/// paper's table calls the pair "same-label / cross-label", with Khronos' values indoors; read as
/// "a candidate of another class may continue a track" it would let one misclassified frame change
/// what an object is, and 0.1 below 0.25 would make that the easier way. Here a candidate of
/// another class never continues a track of a class.
class MaxIouTracker {
 public:
  struct Config {
    /// What the overlap is counted in. voxels: of the candidates' grid. pixels: the points of the
    /// last observation, projected into the current image. boxes: volumes. instances: 1 where the
    /// instance id is the same, for data whose ids persist from frame to frame.
    std::string track_by = "voxels";
    double min_same_label_iou = 0.25;  ///< strictly above
    double min_cross_iou = 0.1;        ///< strictly above
    double max_dynamic_distance_m = 1;
    double temporal_window_s = 3;  ///< a track ends when it was not seen for longer than this
    int min_observations = 15;     ///< confidence reaches 0.5 here
  };
  explicit MaxIouTracker(const Config& config) : config_(config) {}

  /// Frames in order of their stamps.
  /// @param view  of the frame the candidates are from
  void update(const SensorView& view, const FrameCandidates& candidates);
  /// Takes out the tracks that have ended by now, in order of their ids.
  std::vector<Track> takeEnded(std::int64_t stamp_ns);
  /// Takes out all that are left: the end of a run.
  std::vector<Track> takeAll();

  const std::vector<Track>& tracks() const { return tracks_; }
  /// Stamps of all observations of the tracks there are, ascending, each once.
  std::vector<std::int64_t> observedStamps() const;
  /// min(observations / (2 min_observations), 1)
  double confidence(const Track& track) const;

 private:
  Config config_;
  std::vector<Track> tracks_;  ///< ascending ids
  std::uint64_t next_id_ = 0;
};

/// Intersection over union of two sets of voxels, each sorted by IndexLess and unique; 0 if both
/// are empty.
double voxelSetIou(const std::vector<GlobalVoxel>& a, const std::vector<GlobalVoxel>& b);

void read(ConfigReader& reader, MaxIouTracker::Config& config);

}  // namespace hydrabench
