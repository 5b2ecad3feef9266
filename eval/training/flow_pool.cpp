// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/flow_pool.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;

/// The frame `inner`, given in units of `outer`, as one of the level frame.
LocalFrame composed(const LocalFrame& outer, const LocalFrame& inner) {
  LocalFrame frame;
  frame.center = outer.toLevel(inner.center);
  frame.bearing = outer.bearing + inner.bearing;
  frame.scale = outer.scale * inner.scale;
  return frame;
}

LocalFrame objectFrame(const TrainingShape& shape, const TrainingView& view, double stretch) {
  LocalFrame frame;
  frame.center = stretch * view.center.cast<double>();
  frame.bearing = view.yaw;
  frame.scale = stretch * shape.half_extent_m;
  return frame;
}

ObjectPoints stretched(ObjectPoints points, double stretch) {
  for (Eigen::Vector3f& p : points.object) p *= static_cast<float>(stretch);
  for (Eigen::Vector3f& p : points.context) p *= static_cast<float>(stretch);
  return points;
}

double drawStretch(bool augment, Random& random) {
  return augment && random.chance(0.5) ? random.uniform(0.85, 1.2) : 1;
}

const TrainingView& anyView(const TrainingPool::Shape& shape, Random& random) {
  return *shape.views[random.index(static_cast<std::uint32_t>(shape.views.size()))];
}

}  // namespace

FlowPool::FlowPool(const LatentFlowTrainingConfig& config, InstanceSplit split,
                   const std::filesystem::path& cache,
                   const std::function<bool(int world, int worlds)>& progress)
    : config_(config),
      rooms_(config.rooms.worlds, split, cache / "rooms"),
      streets_(config.streets.worlds, split, cache / "streets") {
  const bool training = split == InstanceSplit::kTraining;
  const int rooms = training ? config.rooms.count : config.rooms.validation;
  const int streets = training ? config.streets.count : config.streets.validation;
  for (int i = 0; i < rooms; ++i) {
    if (!progress(i, rooms + streets)) return;
    rooms_.load(0, static_cast<std::uint64_t>(i + 1));
  }
  for (int i = 0; i < streets; ++i) {
    if (!progress(rooms + i, rooms + streets)) return;
    streets_.load(0, static_cast<std::uint64_t>(i + 1));
  }
  for (const TrainingPool* pool : {&rooms_, &streets_}) {
    for (const auto& [name, shapes] : pool->shapesByClass()) {
      const auto weight = config.class_weights.find(name);
      if (weight == config.class_weights.end() || weight->second == 0) continue;
      if (by_class_[name].empty()) total_weight_ += weight->second;
      for (const TrainingPool::Shape& shape : shapes) {
        by_class_[name].push_back(shapes_.size());
        shapes_.push_back(shape);
      }
    }
  }
  if (shapes_.empty()) {
    throw InputError(
        "class_weights: no view of any class in the training worlds, expected some: "
        "more worlds, more frames, or a weight above 0");
  }
  grids_ = static_cast<int>(shapes_.front().shape->grids.size());
  for (const TrainingPool::Shape& shape : shapes_) {
    grids_ = std::min(grids_, static_cast<int>(shape.shape->grids.size()));
  }
  complete_ = true;
}

std::size_t FlowPool::drawShape(Random& random) const {
  double rest = random.uniform(0, total_weight_);
  auto chosen = by_class_.begin();
  while (std::next(chosen) != by_class_.end() && rest >= config_.class_weights.at(chosen->first)) {
    rest -= config_.class_weights.at(chosen->first);
    ++chosen;
  }
  return chosen->second[random.index(static_cast<std::uint32_t>(chosen->second.size()))];
}

PoseSample FlowPool::drawPose(bool augment, Random random) const {
  const TrainingPool::Shape& shape = shapes_[drawShape(random)];
  const TrainingView& view = anyView(shape, random);
  const double stretch = drawStretch(augment, random);
  LocalFrame frame = objectFrame(*shape.shape, view, stretch);
  const int symmetry = shape.shape->yaw_symmetry;
  if (symmetry == 0) {  // faces the camera
    frame.bearing = std::atan2(frame.center.y(), frame.center.x()) + kPi;
  } else {  // any of the yaws under which it looks the same
    frame.bearing += 2 * kPi * random.index(static_cast<std::uint32_t>(symmetry)) / symmetry;
  }
  PoseSample sample;
  sample.input = *makePointInput(stretched(view.points, stretch), random.bits());
  sample.pose = toPoseTokens(frame, sample.input.frame);
  return sample;
}

LatentSample FlowPool::drawLatent(bool augment, Random random) const {
  const std::size_t index = drawShape(random);
  const TrainingPool::Shape& shape = shapes_[index];
  const TrainingView& view = anyView(shape, random);
  const double stretch = drawStretch(augment, random);
  const std::size_t grid = random.index(static_cast<std::uint32_t>(grids_));
  LatentSample sample;
  sample.view = makeViewGrid(
      stretched(view.points, stretch),
      composed(objectFrame(*shape.shape, view, stretch), shape.shape->grids[grid].frame));
  sample.latent = index * static_cast<std::size_t>(grids_) + grid;
  return sample;
}

FieldSample FlowPool::drawField(int points, Random random) const {
  const TrainingShape& shape = *shapes_[drawShape(random)].shape;
  FieldSample sample;
  sample.grid = &shape.grids[random.index(static_cast<std::uint32_t>(grids_))];
  const LocalFrame& frame = sample.grid->frame;
  for (int tries = 0; tries < 20 * points; ++tries) {
    if (static_cast<int>(sample.points.size()) == points) break;
    const std::size_t i = random.index(static_cast<std::uint32_t>(shape.points.size()));
    const Eigen::Vector3d p = frame.toLocal(shape.points[i].cast<double>());
    if (p.cwiseAbs().maxCoeff() > kGridHalfSide) continue;
    sample.points.push_back(p.cast<float>());
    sample.distances.push_back(shape.distances[i] / static_cast<float>(frame.scale));
  }
  while (static_cast<int>(sample.points.size()) < points) {  // hardly any lies in the cube
    sample.points.push_back(Eigen::Vector3f::Constant(static_cast<float>(kGridHalfSide)));
    sample.distances.push_back(static_cast<float>(kTruncation));
  }
  return sample;
}

}  // namespace hydrabench
