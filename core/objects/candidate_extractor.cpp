// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/candidate_extractor.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/mapping/frame_check.h"
#include "core/objects/pixel_groups.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

/// Place in an ascending list, from 1; 0 where it is missing.
template <typename T>
std::size_t placeIn(const std::vector<T>& sorted, T value) {
  const auto it = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (it == sorted.end() || *it != value) return 0;
  return static_cast<std::size_t>(it - sorted.begin()) + 1;
}

}  // namespace

CandidateExtractor::CandidateExtractor(const Config& config, const LabelSpace& label_space)
    : config_(config) {
  for (const LabelSpace::Entry& entry : label_space.entries) {
    if (entry.is_object) object_labels_.push_back(entry.label);
  }
  std::sort(object_labels_.begin(), object_labels_.end());
  if (config_.source == "connected_semantics" && object_labels_.size() > kMaxConnectedKinds) {
    throw InputError(
        fmt::format("candidates.source: connected_semantics takes at most {} classes of objects; "
                    "the label space has {}",
                    kMaxConnectedKinds, object_labels_.size()));
  }
}

void CandidateExtractor::requireImage(const Frame& frame) const {
  const bool by_instance = config_.source == "instances";
  if (!(by_instance ? frame.instances : frame.labels).empty()) return;
  throw InputError(fmt::format(
      "the frame at {} ns has no {} image; expected one, or candidates.source: {}", frame.stamp_ns,
      by_instance ? "instance" : "label", by_instance ? "connected_semantics" : "instances"));
}

std::vector<ObjectCandidate> CandidateExtractor::labelled(const Frame& frame,
                                                          const SensorView& view,
                                                          const MotionDetection* motion) const {
  const bool by_instance = config_.source == "instances";
  const Image<std::int32_t>& values = by_instance ? frame.instances : frame.labels;
  std::vector<InstanceId> instances;  // of objects, ascending
  if (by_instance) {
    for (const auto& [id, label] : frame.instance_labels) {
      if (id != kNoInstance && placeIn(object_labels_, label) != 0) instances.push_back(id);
    }
  }
  const std::vector<std::int32_t>& kinds = by_instance ? instances : object_labels_;
  const PixelSelection selection{.values = values,
                                 .view = view,
                                 .max_range_m = config_.max_range_m,
                                 .moving = motion && !motion->ids.empty() ? &motion->ids : nullptr,
                                 .kind = [&](std::int32_t value) { return placeIn(kinds, value); }};
  std::vector<PixelGroup> groups = by_instance ? groupsByKind(selection, kinds.size())
                                               : connectedGroups(selection, config_.grid_size_m);

  std::vector<ObjectCandidate> candidates;
  for (PixelGroup& group : groups) {
    const std::size_t count = group.pixels.size();
    if (count < static_cast<std::size_t>(config_.min_pixels)) continue;
    if (config_.max_pixels > 0 && count > static_cast<std::size_t>(config_.max_pixels)) continue;
    const std::int32_t value = kinds[group.kind - 1];
    ObjectCandidate& candidate = candidates.emplace_back();
    candidate.label = by_instance ? frame.instance_labels.at(value) : value;
    if (by_instance) candidate.instance = value;
    candidate.pixels = std::move(group.pixels);
  }
  return candidates;
}

void CandidateExtractor::measure(const PixelPoints& points, int width,
                                 ObjectCandidate& candidate) const {
  const double per_voxel = 1 / config_.tracking_voxel_m;
  ImageRegion& region = candidate.region;
  region = {width, std::numeric_limits<int>::max(), 0, 0};
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t pixel : candidate.pixels) {
    const Eigen::Vector3d point = points(pixel);
    const int u = static_cast<int>(pixel) % width;
    const int v = static_cast<int>(pixel) / width;
    region = {std::min(region.u_begin, u), std::min(region.v_begin, v),
              std::max(region.u_end, u + 1), std::max(region.v_end, v + 1)};
    sum += point;
    candidate.box.extend(point);
    const GlobalVoxel voxel = floored(point * per_voxel);
    // Neighbouring pixels mostly share a voxel; what is left is sorted out below.
    if (candidate.voxels.empty() || candidate.voxels.back() != voxel) {
      candidate.voxels.push_back(voxel);
    }
  }
  candidate.centroid = sum / static_cast<double>(candidate.pixels.size());
  std::sort(candidate.voxels.begin(), candidate.voxels.end(), IndexLess());
  candidate.voxels.erase(std::unique(candidate.voxels.begin(), candidate.voxels.end()),
                         candidate.voxels.end());
}

bool CandidateExtractor::withinVolume(const ObjectCandidate& candidate) const {
  if (candidate.dynamic) return true;
  const double volume = candidate.box.volume();
  return volume >= config_.min_volume_m3 &&
         (config_.max_volume_m3 <= 0 || volume <= config_.max_volume_m3);
}

FrameCandidates CandidateExtractor::extract(const Frame& frame, const SensorView& view,
                                            const MotionDetection* motion) const {
  requireImage(frame);
  requireInsideGrid(frame.stamp_ns, frame.T_world_camera.translation(),
                    std::min(config_.grid_size_m, config_.tracking_voxel_m));
  std::vector<ObjectCandidate> candidates;
  if (motion) {
    for (const MotionDetection::Cluster& cluster : motion->clusters) {
      if (cluster.pixels.empty()) continue;
      ObjectCandidate& candidate = candidates.emplace_back();
      candidate.dynamic = true;
      candidate.pixels = cluster.pixels;
    }
  }
  std::vector<ObjectCandidate> others = labelled(frame, view, motion);
  std::move(others.begin(), others.end(), std::back_inserter(candidates));
  const PixelPoints points(view);
  parallelFor(candidates.size(),
              [&](std::size_t i) { measure(points, view.range.width(), candidates[i]); });

  FrameCandidates result{Image<std::uint16_t>(view.range.width(), view.range.height()), {}};
  for (ObjectCandidate& candidate : candidates) {
    if (!withinVolume(candidate)) continue;
    if (result.candidates.size() == std::numeric_limits<std::uint16_t>::max()) break;
    candidate.id = static_cast<std::uint16_t>(result.candidates.size() + 1);
    for (const std::uint32_t pixel : candidate.pixels) result.ids.data()[pixel] = candidate.id;
    result.candidates.push_back(std::move(candidate));
  }
  return result;
}

void read(ConfigReader& reader, CandidateExtractor::Config& config) {
  reader.choice("source", config.source, {"connected_semantics", "instances"});
  reader.field("grid_size_m", config.grid_size_m, Bounds{0.01, 10});
  reader.field("min_pixels", config.min_pixels, Bounds{1, 1e9});
  reader.field("max_pixels", config.max_pixels, Bounds{0, 1e9});
  reader.field("max_range_m", config.max_range_m, Bounds{0.01, 1000});
  reader.field("min_volume_m3", config.min_volume_m3, Bounds{0, 1e9});
  reader.field("max_volume_m3", config.max_volume_m3, Bounds{0, 1e9});
  reader.field("tracking_voxel_m", config.tracking_voxel_m, Bounds{0.001, 100});
}

}  // namespace hydrabench
