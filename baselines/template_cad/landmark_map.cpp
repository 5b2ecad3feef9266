// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/landmark_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace hydrabench {
namespace {

double commonShare(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
  std::vector<std::int64_t> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return static_cast<double>(common.size()) / static_cast<double>(std::min(a.size(), b.size()));
}

}  // namespace

std::optional<std::size_t> LandmarkMap::landmarkOf(const InstanceTrack& track) const {
  std::optional<std::size_t> nearest;
  double nearest_m = config_.gate_m;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const Landmark& landmark = landmarks_[i];
    if (landmark.label != track.label) continue;
    const double distance = (landmark.center - track.center).norm();
    if (distance >= nearest_m) continue;
    if (commonShare(landmark.stamps_ns, track.stamps_ns) > config_.max_common_share) continue;
    nearest = i;
    nearest_m = distance;
  }
  return nearest;
}

void LandmarkMap::add(InstanceTrack track) {
  const std::int64_t age_ns = track.lastSeenNs() - track.firstSeenNs();
  if (track.stamps_ns.size() < static_cast<std::size_t>(config_.min_observations) ||
      age_ns < std::llround(config_.min_age_s * 1e9)) {
    return;
  }
  const std::optional<std::size_t> known = landmarkOf(track);
  if (!known) {
    landmarks_.push_back(
        {track.label, track.center, track.points.points(), std::move(track.stamps_ns)});
    return;
  }
  Landmark& landmark = landmarks_[*known];
  const auto old_count = static_cast<double>(landmark.stamps_ns.size());
  const auto new_count = static_cast<double>(track.stamps_ns.size());
  landmark.center += new_count / (old_count + new_count) * (track.center - landmark.center);
  const std::vector<Eigen::Vector3d>& points = track.points.points();
  landmark.points.insert(landmark.points.end(), points.begin(), points.end());
  std::vector<std::int64_t> stamps_ns;
  std::set_union(landmark.stamps_ns.begin(), landmark.stamps_ns.end(), track.stamps_ns.begin(),
                 track.stamps_ns.end(), std::back_inserter(stamps_ns));
  landmark.stamps_ns = std::move(stamps_ns);
}

void read(ConfigReader& reader, LandmarkMap::Config& config) {
  reader.field("min_observations", config.min_observations, Bounds{1, 1e6});
  reader.field("min_age_s", config.min_age_s, Bounds{0, 1e6});
  reader.field("gate_m", config.gate_m, Bounds{0, 1000});
  reader.field("max_common_share", config.max_common_share, Bounds{0, 1});
}

}  // namespace hydrabench
