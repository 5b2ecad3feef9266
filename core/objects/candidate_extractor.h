// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/motion_detector.h"
#include "core/mapping/sensor_view.h"
#include "core/objects/object_candidate.h"
#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

class PixelPoints;

/// Finds object candidates in a frame (Khronos' ConnectedSemantics and InstanceForwarding; the
/// paper's object candidates, "filtered by sensing range, pixel count, and 3D bounding-box
/// volume").
///
/// Pixels without a measurement within the limits of the view never count. Khronos tests the range
/// against its upper limit only, so pixels without depth would form a candidate at the camera.
class CandidateExtractor {
 public:
  struct Config {
    /// connected_semantics: pixels of one object class whose points touch on a grid of grid_size_m
    /// (26 neighbours). instances: the instance image as it is given; the class of an instance is
    /// that of the frame's instance_labels, and an instance without one is no candidate.
    std::string source = "connected_semantics";
    double grid_size_m = 0.1;
    int min_pixels = 50;
    int max_pixels = 0;        ///< 0: no limit
    double max_range_m = 5;    ///< farther points are passed over
    double min_volume_m3 = 0;  ///< of the candidate's box
    double max_volume_m3 = 0;  ///< 0: no limit
    double tracking_voxel_m = 0.2;
  };
  /// Candidates of the classes that are objects in the label space. Throws InputError where
  /// connected_semantics cannot tell so many classes apart.
  CandidateExtractor(const Config& config, const LabelSpace& label_space);

  /// Candidates are numbered from 1: moving ones in the order of their clusters, then the others by
  /// their first pixel in row order. The limits above are for the others; a motion detector has its
  /// own. Throws InputError where the frame does not have the image of the source.
  /// @param view    of the same frame
  /// @param motion  moving things, whose pixels no other candidate gets; may be null
  FrameCandidates extract(const Frame& frame, const SensorView& view,
                          const MotionDetection* motion = nullptr) const;

 private:
  void requireImage(const Frame& frame) const;
  std::vector<ObjectCandidate> labelled(const Frame& frame, const SensorView& view,
                                        const MotionDetection* motion) const;
  void measure(const PixelPoints& points, int width, ObjectCandidate& candidate) const;
  bool withinVolume(const ObjectCandidate& candidate) const;

  Config config_;
  std::vector<Label> object_labels_;  ///< ascending
};

void read(ConfigReader& reader, CandidateExtractor::Config& config);

}  // namespace hydrabench
