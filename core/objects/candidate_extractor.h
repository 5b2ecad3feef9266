// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/config/config_reader.h"
#include "core/mapping/motion_detector.h"
#include "core/mapping/sensor_view.h"
#include "core/objects/object_candidate.h"
#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Finds object candidates in a frame (Khronos' ConnectedSemantics and InstanceForwarding;
/// paper, "Object Extraction").
class CandidateExtractor {
 public:
  struct Config {
    /// connected_semantics: pixels of one object class whose points touch on a grid of grid_size_m.
    /// instances: the instance image as it is given.
    std::string source = "connected_semantics";
    double grid_size_m = 0.1;
    int min_pixels = 50;
    int max_pixels = 0;        ///< 0: no limit
    double max_range_m = 5;    ///< farther points are passed over
    double min_volume_m3 = 0;  ///< of the candidate's box
    double max_volume_m3 = 0;  ///< 0: no limit
    double tracking_voxel_m = 0.2;
  };
  /// Candidates of the classes that are objects in the label space.
  CandidateExtractor(const Config& config, const LabelSpace& label_space);

  /// @param view    of the same frame
  /// @param motion  moving things, which come first in the list; may be null
  FrameCandidates extract(const RgbdFrame& frame, const SensorView& view,
                          const MotionDetection* motion = nullptr) const;

 private:
  Config config_;
  LabelSpace label_space_;
};

void read(ConfigReader& reader, CandidateExtractor::Config& config);

}  // namespace hydrabench
