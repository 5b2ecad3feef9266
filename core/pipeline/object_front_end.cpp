// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/object_front_end.h"

#include "core/mapping/class_mask.h"

namespace hydrabench {

ObjectFrontEnd::Config::Config() {
  window.tsdf.voxel_size_m = 0.1;
  window.tsdf.truncation_m = 0.2;
  window.archive = "temporal";
  window.window_s = 3;
  window.output_separation_s = 0.4;
  window.track_freespace = true;
}

ObjectFrontEnd::ObjectFrontEnd(const Config& config, const LabelSpace& label_space)
    : config_(config),
      dynamic_labels_(labelsNamed(config.dynamic_classes, label_space)),
      window_(config.window),
      lidar_(config.lidar, label_space, dynamic_labels_),
      motion_detector_(config.motion),
      extractor_(config.candidates, label_space),
      tracker_(config.tracker) {}

FrameCandidates ObjectFrontEnd::process(const Frame& given, StageTimes& times) {
  lidar_.integrate(given, window_, times);
  with_lidar_depth_.reset();
  if (lidar_.replacesDepth() && given.camera.width > 0) {
    with_lidar_depth_ = lidar_.withLidarDepth(given, times);
  }
  const Frame& frame = objectFrame(given);
  if (lidar_.enabled() && frame.depth.empty()) return {};
  SensorView view = sensorView(frame, config_.min_range_m, config_.max_range_m);
  {
    const StageTimes::Scope stage(times, "motion");
    detectMotion(view);
  }
  FrameCandidates candidates;
  {
    const StageTimes::Scope stage(times, "candidates");
    candidates = extractor_.extract(frame, view, &motion_);
  }
  {
    const StageTimes::Scope stage(times, "track");
    tracker_.update(view, candidates);
  }
  if (lidar_.cameraInMap() && !given.depth.empty()) {
    const StageTimes::Scope stage(times, "integrate");
    if (with_lidar_depth_) view = sensorView(given, config_.min_range_m, config_.max_range_m);
    const Image<std::uint8_t> mask = staticMapMask(given);
    view.mask = &mask;
    window_.integrate(view);
  }
  return candidates;
}

bool ObjectFrontEnd::updateMesh(const Frame& frame, StageTimes& times) {
  if (!window_.updateDue(frame.stamp_ns)) return false;
  const StageTimes::Scope stage(times, "mesh");
  window_.update(frame.stamp_ns, frame.T_world_camera.translation());
  return true;
}

void ObjectFrontEnd::detectMotion(const SensorView& view) {
  motion_ = config_.motion.enabled
                ? motion_detector_.detect(view, window_.volume())
                : MotionDetection{Image<std::uint8_t>(view.range.width(), view.range.height()), {}};
}

Image<std::uint8_t> ObjectFrontEnd::staticMapMask(const Frame& frame) const {
  Image<std::uint8_t> mask = motion_.ids;
  if (!frame.labels.empty()) maskClasses(frame.labels, dynamic_labels_, mask);
  return mask;
}

void read(ConfigReader& reader, ObjectFrontEnd::Config& config) {
  reader.field("min_range_m", config.min_range_m, Bounds{0, 1000});
  reader.field("max_range_m", config.max_range_m, Bounds{0.01, 1000});
  if (!(config.min_range_m < config.max_range_m)) {
    reader.fault("max_range_m", "is not above min_range_m; expected a range of distances");
  }
  reader.field("dynamic_classes", config.dynamic_classes);
  auto lidar = reader.section("lidar");
  read(lidar, config.lidar);
  auto window = reader.section("window");
  read(window, config.window);
  requireBandInMesh(window, config.window, config.lidar);
  auto motion = reader.section("motion");
  read(motion, config.motion);
  if (config.motion.enabled && !config.window.track_freespace) {
    reader.fault("motion", "needs free space; expected window.track_freespace: true");
  }
  auto candidates = reader.section("candidates");
  read(candidates, config.candidates);
  auto tracker = reader.section("tracker");
  read(tracker, config.tracker);
}

}  // namespace hydrabench
