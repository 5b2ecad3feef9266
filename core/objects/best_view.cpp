// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/best_view.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace hydrabench {

double seenVolume(const Frame& frame, const ObjectCandidate& candidate, double trim) {
  if (trim <= 0) return candidate.box.volume();
  constexpr std::size_t kPoints = 2000;
  const std::size_t step = candidate.pixels.size() / kPoints + 1;
  std::vector<double> along[3];
  for (std::size_t i = 0; i < candidate.pixels.size(); i += step) {
    const int u = static_cast<int>(candidate.pixels[i]) % frame.camera.width;
    const int v = static_cast<int>(candidate.pixels[i]) / frame.camera.width;
    const Eigen::Vector3d point =
        frame.T_world_camera * frame.camera.backproject(u, v, double{frame.depth(u, v)});
    for (int axis = 0; axis < 3; ++axis) along[axis].push_back(point[axis]);
  }
  double volume_m3 = 1;
  for (std::vector<double>& values : along) {
    const auto cut = static_cast<std::ptrdiff_t>(trim * static_cast<double>(values.size()));
    const auto low = values.begin() + cut;
    const auto high = values.end() - 1 - cut;
    if (low >= high) return 0;
    std::nth_element(values.begin(), low, values.end());
    std::nth_element(low + 1, high, values.end());
    volume_m3 *= *high - *low;
  }
  return volume_m3;
}

void BestViews::add(const Observation& observation, double volume_m3,
                    const std::function<std::shared_ptr<const BufferedFrame>()>& frame) {
  assert(max_views_ >= 1);
  if (num_added_ == max_views_ * span_) {
    // Neighbours become one span; of a pair the better view stays.
    std::vector<TrackView> merged;
    for (std::size_t i = 0; i < views_.size(); i += 2) {
      const bool second = i + 1 < views_.size() && views_[i + 1].volume_m3 > views_[i].volume_m3;
      merged.push_back(std::move(views_[second ? i + 1 : i]));
    }
    views_ = std::move(merged);
    span_ *= 2;
  }
  const std::size_t span = num_added_++ / span_;
  if (span == views_.size()) {
    views_.push_back({frame(), observation, volume_m3});
  } else if (volume_m3 > views_[span].volume_m3) {
    views_[span] = {frame(), observation, volume_m3};
  }
}

std::vector<TrackView> BestViews::ordered() const {
  std::vector<TrackView> views = views_;
  std::stable_sort(views.begin(), views.end(), [](const TrackView& a, const TrackView& b) {
    return a.volume_m3 > b.volume_m3;
  });
  return views;
}

Image<std::uint16_t> instanceMasks(const Frame& frame, const FrameCandidates& candidates) {
  std::map<InstanceId, std::uint16_t> id_of;
  for (const ObjectCandidate& candidate : candidates.candidates) {
    if (candidate.dynamic) continue;
    id_of[frame.instances.data()[candidate.pixels.front()]] = candidate.id;
  }
  Image<std::uint16_t> ids = candidates.ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const InstanceId instance = frame.instances.data()[i];
    if (ids.data()[i] != 0 || instance == kNoInstance || frame.depth.data()[i] > 0) continue;
    const auto found = id_of.find(instance);
    if (found != id_of.end()) ids.data()[i] = found->second;
  }
  return ids;
}

ShapeObservation shapeObservation(const TrackView& view, Label label) {
  const Frame& frame = view.frame->frame;
  ShapeObservation observation;
  observation.stamp_ns = frame.stamp_ns;
  observation.camera = frame.camera;
  observation.T_world_camera = frame.T_world_camera;
  observation.color = frame.color;
  observation.depth = frame.depth;
  observation.label = label;
  observation.mask = Image<std::uint8_t>(frame.camera.width, frame.camera.height);
  const Image<std::uint16_t>& ids = view.frame->ids;
  std::transform(ids.begin(), ids.end(), observation.mask.begin(), [&](std::uint16_t id) {
    return static_cast<std::uint8_t>(id == view.observation.candidate_id);
  });
  return observation;
}

}  // namespace hydrabench
