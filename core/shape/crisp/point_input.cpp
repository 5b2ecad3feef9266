// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/point_input.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kMinPoints = 5;
constexpr double kMinScale_m = 0.03;
constexpr float kFarthest = 4;  // local units: what lies farther away says only that it is far

/// Value below which `share` of the values lie.
float quantile(std::vector<float> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::vector<float> coordinate(const std::vector<Vector3f>& points, int axis) {
  std::vector<float> values;
  values.reserve(points.size());
  for (const Vector3f& p : points) values.push_back(p[axis]);
  return values;
}

LocalFrame frameOf(const std::vector<Vector3f>& points) {
  LocalFrame frame;
  for (int axis = 0; axis < 3; ++axis) {
    frame.center[axis] = quantile(coordinate(points, axis), 0.5);
  }
  frame.bearing = std::atan2(frame.center.y(), frame.center.x());
  std::vector<Vector3f> turned;
  turned.reserve(points.size());
  for (const Vector3f& p : points) turned.push_back(frame.toLocal(p.cast<double>()).cast<float>());
  double extent = kMinScale_m;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float> values = coordinate(turned, axis);
    extent = std::max<double>(extent, quantile(values, 0.95) - quantile(values, 0.05));
  }
  frame.scale = extent;
  return frame;
}

/// Indices into `available` drawn without repeats as far as they go round.
std::vector<std::uint32_t> draw(std::size_t available, std::size_t count, Random random) {
  std::vector<std::uint32_t> order(available);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = 0; i < std::min(count, available); ++i) {
    std::swap(order[i], order[i + random.index(static_cast<std::uint32_t>(available - i))]);
  }
  std::vector<std::uint32_t> drawn(count);
  for (std::size_t i = 0; i < count; ++i) drawn[i] = order[i % available];
  return drawn;
}

/// Points far from each other, beginning with the first; repeats once all are taken.
std::vector<std::size_t> farthestPoints(const Vector3f* points, std::size_t size,
                                        std::size_t count) {
  std::vector<float> distance(size, std::numeric_limits<float>::infinity());
  std::vector<std::size_t> chosen = {0};
  while (chosen.size() < count) {
    const Vector3f& last = points[chosen.back()];
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < size; ++i) {
      distance[i] = std::min(distance[i], (points[i] - last).squaredNorm());
      if (distance[i] > distance[farthest]) farthest = i;
    }
    chosen.push_back(farthest);
  }
  return chosen;
}

/// The `count` nearest of `size` points to a place, nearest first; ties by index.
std::vector<std::pair<float, std::size_t>> nearest(const Vector3f* points, std::size_t size,
                                                   const Vector3f& place, std::size_t count) {
  std::vector<std::pair<float, std::size_t>> all(size);
  for (std::size_t i = 0; i < size; ++i) all[i] = {(points[i] - place).squaredNorm(), i};
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(count, size));
  std::partial_sort(all.begin(), end, all.end());
  all.erase(end, all.end());
  return all;
}

void appendPatches(const std::vector<Vector3f>& points, std::size_t begin, std::size_t size,
                   std::size_t tokens, std::vector<Vector3f>& centers, PointInput& input) {
  for (const std::size_t chosen : farthestPoints(&points[begin], size, tokens)) {
    const Vector3f center = points[begin + chosen];
    centers.push_back(center);
    for (const auto& [_, i] : nearest(&points[begin], size, center, PointInput::kPatch)) {
      input.patches.push_back(static_cast<std::int64_t>(begin + i));
    }
  }
}

void linkTokens(const std::vector<Vector3f>& points, const std::vector<Vector3f>& centers,
                PointInput& input) {
  for (std::size_t i = 0; i < PointInput::kObjectPoints; ++i) {
    const auto found =
        nearest(centers.data(), PointInput::kObjectTokens, points[i], PointInput::kNear);
    float total = 0;
    for (const auto& [squared, _] : found) total += 1 / (squared + 1e-4f);
    for (const auto& [squared, token] : found) {
      input.near.push_back(static_cast<std::int64_t>(token));
      input.near_weights.push_back(1 / (squared + 1e-4f) / total);
    }
  }
}

}  // namespace

Eigen::Vector3d LocalFrame::toLocal(const Eigen::Vector3d& p_level) const {
  const Eigen::Vector3d d = (p_level - center) / scale;
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  return {c * d.x() + s * d.y(), -s * d.x() + c * d.y(), d.z()};
}

Eigen::Vector3d LocalFrame::toLevel(const Eigen::Vector3d& p_local) const {
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  return center + scale * Eigen::Vector3d(c * p_local.x() - s * p_local.y(),
                                          s * p_local.x() + c * p_local.y(), p_local.z());
}

std::optional<PointInput> makePointInput(const ObjectPoints& points, std::uint64_t seed) {
  if (points.object.size() < kMinPoints) return std::nullopt;
  PointInput input;
  input.frame = frameOf(points.object);
  const Random random(seed);
  input.source = draw(points.object.size(), PointInput::kObjectPoints, random.fork(1));
  const bool has_context = !points.context.empty();
  const std::vector<Vector3f>& surroundings = has_context ? points.context : points.object;
  const auto context = draw(surroundings.size(), PointInput::kContextPoints, random.fork(2));

  std::vector<float> heights = coordinate(points.object, 2);
  for (const Vector3f& p : points.context) heights.push_back(p.z());
  const float floor = quantile(std::move(heights), 0.02);

  std::vector<Vector3f> local;
  local.reserve(PointInput::kPoints);
  const auto add = [&](const Vector3f& p, float on_object) {
    Vector3f q = input.frame.toLocal(p.cast<double>()).cast<float>();
    q = q.cwiseMax(-kFarthest).cwiseMin(kFarthest);
    local.push_back(q);
    input.points.insert(input.points.end(), {q.x(), q.y(), q.z(), p.z() - floor, on_object});
  };
  for (const std::uint32_t i : input.source) add(points.object[i], 1);
  for (const std::uint32_t i : context) add(surroundings[i], has_context ? 0 : 1);

  std::vector<Vector3f> centers;
  appendPatches(local, 0, PointInput::kObjectPoints, PointInput::kObjectTokens, centers, input);
  appendPatches(local, PointInput::kObjectPoints, PointInput::kContextPoints,
                PointInput::kContextTokens, centers, input);
  linkTokens(local, centers, input);
  input.globals = {static_cast<float>(std::log(input.frame.scale)),
                   static_cast<float>(input.frame.center.z()) - floor,
                   -floor,
                   static_cast<float>(input.frame.center.norm()),
                   static_cast<float>(std::log(points.object.size())),
                   points.cut[0],
                   points.cut[1],
                   points.cut[2],
                   points.cut[3],
                   has_context ? 0.0f : 1.0f};
  return input;
}

}  // namespace hydrabench
