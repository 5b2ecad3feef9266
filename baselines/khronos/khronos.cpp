// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/khronos/khronos.h"

#include <optional>
#include <utility>

#include "core/graph/spark_dsg_json.h"
#include "core/mapping/class_mask.h"

namespace hydrabench {

Khronos::Config::Config() {
  window.tsdf.voxel_size_m = 0.1;
  window.tsdf.truncation_m = 0.2;
  window.archive = "temporal";
  window.window_s = 3;
  window.output_separation_s = 0.4;
  window.track_freespace = true;
}

Khronos::Khronos(const Config& config, const LabelSpace& label_space)
    : config_(config),
      label_space_(label_space),
      dynamic_labels_(labelsNamed(config.dynamic_classes, label_space)),
      window_(config.window),
      motion_detector_(config.motion),
      extractor_(config.candidates, label_space),
      tracker_(config.tracker),
      buffer_(static_cast<std::size_t>(config.buffer_frames)),
      reconstruction_(config.reconstruction),
      objects_(config.min_merge_iou) {}

void Khronos::process(const RgbdFrame& frame) {
  SensorView view = sensorView(frame, config_.min_range_m, config_.max_range_m);
  detectMotion(view);

  FrameCandidates candidates;
  {
    const StageTimes::Scope stage(times_, "candidates");
    candidates = extractor_.extract(frame, view, &motion_);
  }
  {
    const StageTimes::Scope stage(times_, "track");
    tracker_.update(view, candidates);
    bufferFrame(frame, std::move(candidates));
  }
  {
    const StageTimes::Scope stage(times_, "integrate");
    const Image<std::uint8_t> mask = staticMapMask(frame);
    view.mask = &mask;
    window_.integrate(view);
    view.mask = nullptr;
  }
  if (!window_.updateDue(frame.stamp_ns)) return;
  {
    const StageTimes::Scope stage(times_, "mesh");
    window_.update(frame.stamp_ns, frame.T_world_camera.translation());
  }
  const StageTimes::Scope stage(times_, "extract");
  extractObjects(tracker_.takeEnded(frame.stamp_ns));
  buffer_.keepOnly(tracker_.observedStamps());
}

SceneGraph Khronos::finish() {
  extractObjects(tracker_.takeAll());
  buffer_.keepOnly({});
  window_.finish();

  SceneGraph graph;
  graph.label_space = label_space_;
  graph.objects = objects_.nodes();
  graph.scene_mesh = window_.mesh().mesh(&graph.scene_labels);
  return graph;
}

void Khronos::detectMotion(const SensorView& view) {
  const StageTimes::Scope stage(times_, "motion");
  motion_ = config_.motion.enabled
                ? motion_detector_.detect(view, window_.volume())
                : MotionDetection{Image<std::uint8_t>(view.range.width(), view.range.height()), {}};
}

Image<std::uint8_t> Khronos::staticMapMask(const RgbdFrame& frame) const {
  Image<std::uint8_t> mask = motion_.ids;
  if (!frame.labels.empty()) maskClasses(frame.labels, dynamic_labels_, mask);
  return mask;
}

void Khronos::bufferFrame(const RgbdFrame& frame, FrameCandidates&& candidates) {
  if (candidates.candidates.empty()) return;  // no track refers to it
  buffer_.add(bufferedFrame(frame, std::move(candidates.ids)));
}

void Khronos::extractObjects(const std::vector<Track>& ended) {
  std::vector<Track> tracks;
  for (const Track& track : ended) {
    if (!(tracker_.confidence(track) > config_.min_track_confidence)) continue;
    if (track.dynamic) {
      ++num_moving_tracks_;
    } else {
      tracks.push_back(track);
    }
  }
  std::vector<std::optional<Mesh>> meshes =
      reconstruction_.reconstruct(tracks, buffer_, config_.min_range_m, config_.max_range_m);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!meshes[i]) continue;
    ObjectNode node;
    node.id = objectNodeId(next_object_index_++);
    node.label = tracks[i].label;
    node.name = label_space_.nameOf(node.label);
    node.mesh = std::move(*meshes[i]);
    node.box = bounds(node.mesh);
    node.T_world_object.translation() = node.box.center();
    node.first_observed_ns = tracks[i].firstSeenNs();
    node.last_observed_ns = tracks[i].lastSeenNs();
    objects_.add(std::move(node));
  }
}

std::vector<std::string> Khronos::notes() const {
  return {"what moves is tracked and kept out of the map, but is no object of the graph"};
}

void read(ConfigReader& reader, Khronos::Config& config) {
  reader.field("min_range_m", config.min_range_m, Bounds{0, 1000});
  reader.field("max_range_m", config.max_range_m, Bounds{0.01, 1000});
  if (!(config.min_range_m < config.max_range_m)) {
    reader.fault("max_range_m", "is not above min_range_m; expected a range of distances");
  }
  reader.field("dynamic_classes", config.dynamic_classes);
  auto window = reader.section("window");
  read(window, config.window);
  auto motion = reader.section("motion");
  read(motion, config.motion);
  if (config.motion.enabled && !config.window.track_freespace) {
    reader.fault("motion", "needs free space; expected window.track_freespace: true");
  }
  auto candidates = reader.section("candidates");
  read(candidates, config.candidates);
  auto tracker = reader.section("tracker");
  read(tracker, config.tracker);
  reader.field("buffer_frames", config.buffer_frames, Bounds{1, 1e6});
  reader.field("min_track_confidence", config.min_track_confidence, Bounds{0, 1});
  auto reconstruction = reader.section("reconstruction");
  read(reconstruction, config.reconstruction);
  reader.field("min_merge_iou", config.min_merge_iou, Bounds{0, 1});
}

}  // namespace hydrabench
