// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/instance_tracker.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "core/geometry/assignment.h"

namespace hydrabench {
namespace {

/// Pairs (row, column) of least total cost where every row and column may also stay alone. To leave
/// a pair alone costs `gate`, so a pair farther apart than that never pays.
Assignment assignWithinGate(const Eigen::MatrixXd& distance, double gate) {
  const Eigen::Index rows = distance.rows();
  const Eigen::Index columns = distance.cols();
  // Every row gets a column of its own to stay alone in, and every column a row.
  const double forbidden = 2 * gate * static_cast<double>(rows + columns + 1);
  Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(rows + columns, columns + rows, forbidden);
  cost.topLeftCorner(rows, columns) = (distance.array() > gate).select(forbidden, distance);
  cost.topRightCorner(rows, rows).diagonal().setConstant(0.5 * gate);
  cost.bottomLeftCorner(columns, columns).diagonal().setConstant(0.5 * gate);
  cost.bottomRightCorner(columns, rows).setZero();
  Assignment pairs;
  for (const auto& [row, column] : assignMinCost(cost)) {
    if (row < static_cast<std::size_t>(rows) && column < static_cast<std::size_t>(columns)) {
      pairs.emplace_back(row, column);
    }
  }
  return pairs;
}

}  // namespace

void ThinnedPoints::add(std::span<const Eigen::Vector3d> points) {
  for (const Eigen::Vector3d& point : points) {
    if (seen_++ % stride_ != 0) continue;
    points_.push_back(point);
    if (points_.size() <= capacity_) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points_.size(); i += 2) points_[kept++] = points_[i];
    points_.resize(kept);
    stride_ *= 2;
  }
}

std::vector<InstanceTrack> InstanceTracker::update(
    std::int64_t stamp_ns, const std::vector<InstanceMeasurement>& measurements) {
  const std::int64_t lost_before_ns = stamp_ns - std::llround(config_.lost_after_s * 1e9);
  std::vector<InstanceTrack> ended;
  std::vector<InstanceTrack> alive;
  for (InstanceTrack& track : tracks_) {
    (track.lastSeenNs() < lost_before_ns ? ended : alive).push_back(std::move(track));
  }
  tracks_ = std::move(alive);
  for (const auto& [label, gate_m] : gates_m_) updateClass(stamp_ns, label, gate_m, measurements);
  return ended;
}

void InstanceTracker::updateClass(std::int64_t stamp_ns, Label label, double gate_m,
                                  const std::vector<InstanceMeasurement>& measurements) {
  std::vector<const InstanceMeasurement*> seen;
  for (const InstanceMeasurement& measurement : measurements) {
    if (measurement.label == label) seen.push_back(&measurement);
  }
  if (seen.empty()) return;
  std::vector<std::size_t> known;  // tracks of the class
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (tracks_[i].label == label) known.push_back(i);
  }
  Eigen::MatrixXd distance(static_cast<Eigen::Index>(seen.size()),
                           static_cast<Eigen::Index>(known.size()));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = 0; j < known.size(); ++j) {
      distance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (seen[i]->center - tracks_[known[j]].center).norm();
    }
  }
  std::vector<InstanceTrack*> track_of(seen.size(), nullptr);
  for (const auto& [i, j] : assignWithinGate(distance, gate_m)) track_of[i] = &tracks_[known[j]];

  std::vector<InstanceTrack> begun;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (track_of[i]) {
      track_of[i]->center += config_.centroid_update * (seen[i]->center - track_of[i]->center);
      track_of[i]->points.add(seen[i]->points);
      track_of[i]->stamps_ns.push_back(stamp_ns);
    } else {
      InstanceTrack& track = begun.emplace_back();
      track.label = label;
      track.center = seen[i]->center;
      track.points = ThinnedPoints(static_cast<std::size_t>(config_.max_points));
      track.points.add(seen[i]->points);
      track.stamps_ns = {stamp_ns};
    }
  }
  std::move(begun.begin(), begun.end(), std::back_inserter(tracks_));
}

std::vector<InstanceTrack> InstanceTracker::takeAll() { return std::exchange(tracks_, {}); }

void read(ConfigReader& reader, InstanceTracker::Config& config) {
  reader.field("centroid_update", config.centroid_update, Bounds{0, 1});
  reader.field("max_points", config.max_points, Bounds{10, 1e8});
  reader.field("lost_after_s", config.lost_after_s, Bounds{0, 1e6});
}

}  // namespace hydrabench
