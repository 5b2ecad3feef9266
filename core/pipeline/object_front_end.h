// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/lidar/lidar_input.h"
#include "core/mapping/active_window.h"
#include "core/mapping/motion_detector.h"
#include "core/objects/candidate_extractor.h"
#include "core/objects/max_iou_tracker.h"
#include "core/pipeline/stage_times.h"

namespace hydrabench {

/// What Khronos does with every frame, and Hydra++ after it: moving things are found where space
/// was free; candidates of objects are found and tracked by overlap; the rest goes into the active
/// window. What becomes of the tracks is the method's affair.
class ObjectFrontEnd {
 public:
  /// As Khronos on uHumans2.
  struct Config {
    Config();
    double min_range_m = 0.1;  ///< of the sensor
    double max_range_m = 5;
    /// Names of classes that move: kept out of the static map whether they move or not.
    std::vector<std::string> dynamic_classes = {"human"};
    LidarInput::Config lidar;  ///< of the hybrid mode; off
    ActiveWindow::Config window;
    MotionDetector::Config motion;
    CandidateExtractor::Config candidates;
    MaxIouTracker::Config tracker;
  };
  ObjectFrontEnd(const Config& config, const LabelSpace& label_space);

  /// Stages: those of LidarInput, motion, candidates, track, integrate. Throws InputError where the
  /// frame lacks the image that the candidates are taken from; with a lidar, a frame without depth
  /// has no candidates.
  /// @return  the candidates of the frame, observed by the tracker's tracks
  FrameCandidates process(const Frame& frame, StageTimes& times);
  /// If it is time to, updates the mesh of the window (stage mesh) and returns true: Khronos ends
  /// tracks then.
  bool updateMesh(const Frame& frame, StageTimes& times);
  /// The last frame as its candidates were found in it: the one given, or one with the depth of the
  /// lidar, see LidarInput.
  const Frame& objectFrame(const Frame& frame) const {
    return with_lidar_depth_ ? *with_lidar_depth_ : frame;
  }
  /// Throws InputError where the lidar is on and there was none.
  void requireScans() const { lidar_.requireScans(); }
  std::vector<std::string> lidarNotes() const { return lidar_.notes(); }

  MaxIouTracker& tracker() { return tracker_; }
  const MaxIouTracker& tracker() const { return tracker_; }
  ActiveWindow& window() { return window_; }
  const ActiveWindow& window() const { return window_; }

 private:
  void detectMotion(const SensorView& view);
  Image<std::uint8_t> staticMapMask(const Frame& frame) const;

  Config config_;
  std::vector<Label> dynamic_labels_;
  ActiveWindow window_;
  LidarInput lidar_;
  std::optional<Frame> with_lidar_depth_;
  MotionDetector motion_detector_;
  CandidateExtractor extractor_;
  MaxIouTracker tracker_;
  MotionDetection motion_;  ///< of the last frame
};

/// Reads the keys of the struct; not in a section of their own.
void read(ConfigReader& reader, ObjectFrontEnd::Config& config);

}  // namespace hydrabench
