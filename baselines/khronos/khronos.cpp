// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/khronos/khronos.h"

#include <optional>
#include <utility>

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {

Khronos::Khronos(const Config& config, const LabelSpace& label_space)
    : config_(config),
      label_space_(label_space),
      front_end_(config, label_space),
      buffer_(static_cast<std::size_t>(config.buffer_frames)),
      reconstruction_(config.reconstruction),
      objects_(config.min_merge_iou) {}

void Khronos::process(const Frame& frame) {
  FrameCandidates candidates = front_end_.process(frame, times_);
  bufferFrame(front_end_.objectFrame(frame), std::move(candidates));
  if (!front_end_.updateMesh(frame, times_)) return;
  const StageTimes::Scope stage(times_, "extract");
  extractObjects(front_end_.tracker().takeEnded(frame.stamp_ns));
  buffer_.keepOnly(front_end_.tracker().observedStamps());
}

SceneGraph Khronos::finish() {
  front_end_.requireScans();
  extractObjects(front_end_.tracker().takeAll());
  buffer_.keepOnly({});
  front_end_.window().finish();

  SceneGraph graph;
  graph.label_space = label_space_;
  graph.objects = objects_.nodes();
  graph.scene_mesh = window().mesh().mesh(&graph.scene_labels);
  graph.occupied = front_end_.window().takeOccupied();
  graph.occupied_voxel_m = config_.window.tsdf.voxel_size_m;
  return graph;
}

void Khronos::bufferFrame(const Frame& frame, FrameCandidates&& candidates) {
  if (candidates.candidates.empty()) return;  // no track refers to it
  buffer_.add(bufferedFrame(frame, std::move(candidates.ids)));
}

void Khronos::extractObjects(const std::vector<Track>& ended) {
  std::vector<Track> tracks;
  for (const Track& track : ended) {
    if (!(front_end_.tracker().confidence(track) > config_.min_track_confidence)) continue;
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
  std::vector<std::string> notes = front_end_.lidarNotes();
  notes.insert(notes.begin(),
               "what moves is tracked and kept out of the map, but is no object of the graph");
  return notes;
}

void read(ConfigReader& reader, Khronos::Config& config) {
  read(reader, static_cast<ObjectFrontEnd::Config&>(config));
  reader.field("buffer_frames", config.buffer_frames, Bounds{1, 1e6});
  reader.field("min_track_confidence", config.min_track_confidence, Bounds{0, 1});
  auto reconstruction = reader.section("reconstruction");
  read(reconstruction, config.reconstruction);
  reader.field("min_merge_iou", config.min_merge_iou, Bounds{0, 1});
}

}  // namespace hydrabench
