// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_pool.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kOnObject = 1.35f;  // object coordinates beyond this are no part of it

Eigen::Vector3d turned(const Eigen::Vector3d& p, double yaw) {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

}  // namespace

TrainingSample makeTrainingSample(const TrainingShape& shape, const TrainingView& view,
                                  int sdf_points, double stretch, Random random) {
  TrainingSample sample;
  ObjectPoints points = view.points;
  for (Eigen::Vector3f& p : points.object) p *= static_cast<float>(stretch);
  for (Eigen::Vector3f& p : points.context) p *= static_cast<float>(stretch);
  sample.input = *makePointInput(points, random.bits());
  sample.class_name = shape.class_name;
  sample.augmented = stretch != 1;
  sample.half_extent_m = stretch * shape.half_extent_m;
  sample.center_level = stretch * view.center.cast<double>();
  const LocalFrame& frame = sample.input.frame;

  // What the network is to call the object's yaw: facing the camera where there is no front, else
  // either of the yaws under which it looks the same.
  const double facing = std::atan2(sample.center_level.y(), sample.center_level.x()) + kPi;
  std::array<double, TrainingSample::kPoses> yaws = {view.yaw, view.yaw};
  if (shape.yaw_symmetry == 0) yaws = {facing, facing};
  if (shape.yaw_symmetry == 2) yaws[1] += kPi;
  for (int k = 0; k < TrainingSample::kPoses; ++k) {
    const Eigen::Vector3d center = frame.toLocal(sample.center_level);
    const double yaw = yaws[static_cast<std::size_t>(k)];
    sample.direct[k] = {static_cast<float>(center.x()),
                        static_cast<float>(center.y()),
                        static_cast<float>(center.z()),
                        static_cast<float>(std::log(sample.half_extent_m / frame.scale)),
                        static_cast<float>(std::cos(yaw - frame.bearing)),
                        static_cast<float>(std::sin(yaw - frame.bearing))};
    for (std::size_t i = 0; i < sample.input.source.size(); ++i) {
      const std::uint32_t source = sample.input.source[i];
      const Eigen::Vector3f nocs =
          (turned(points.object[source].cast<double>() - sample.center_level, -yaw) /
           sample.half_extent_m)
              .cast<float>();
      sample.nocs[k].insert(sample.nocs[k].end(), {nocs.x(), nocs.y(), nocs.z()});
      if (k == 0) {
        const bool on = view.on_object[source] && nocs.cwiseAbs().maxCoeff() < kOnObject;
        sample.weights.push_back(on ? 1 : 0);
      }
    }
  }
  const double turn = shape.yaw_symmetry == 0 ? view.yaw - facing : 0;
  for (int i = 0; i < sdf_points; ++i) {
    const std::size_t chosen = random.index(static_cast<std::uint32_t>(shape.points.size()));
    const Eigen::Vector3d p = turned(shape.points[chosen].cast<double>(), turn);
    for (int axis = 0; axis < 3; ++axis) sample.points.push_back(static_cast<float>(p[axis]));
    sample.distances.push_back(shape.distances[chosen]);
  }
  return sample;
}

TrainingWorld cachedTrainingWorld(const TrainingWorldConfig& config, InstanceSplit split,
                                  std::uint64_t index, const std::filesystem::path& cache) {
  const std::filesystem::path file =
      cache /
      fmt::format("{}_{:06}.world", split == InstanceSplit::kTraining ? "train" : "val", index);
  std::optional<TrainingWorld> cached = readTrainingWorld(file, config);
  if (cached) return *std::move(cached);
  // A world that was just made must not differ from one that is read again.
  writeTrainingWorld(file, config, makeTrainingWorld(config, split, index));
  return readTrainingWorld(file, config).value();
}

TrainingPool::TrainingPool(const TrainingWorldConfig& config, InstanceSplit split,
                           std::filesystem::path cache)
    : config_(config), split_(split), cache_(std::move(cache)) {}

void TrainingPool::load(std::uint64_t begin, std::uint64_t end) {
  std::erase_if(worlds_, [&](const auto& item) { return item.first < begin || item.first >= end; });
  for (std::uint64_t index = begin; index < end; ++index) {
    if (worlds_.count(index)) continue;
    worlds_[index] =
        std::make_shared<const TrainingWorld>(cachedTrainingWorld(config_, split_, index, cache_));
  }
  by_class_.clear();
  for (const auto& [index, world] : worlds_) {
    std::vector<Shape> shapes(world->shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      shapes[i].number =
          static_cast<std::int64_t>(index) * kShapesPerWorld + static_cast<std::int64_t>(i);
      shapes[i].shape = &world->shapes[i];
    }
    for (const TrainingView& view : world->views) shapes[view.shape].views.push_back(&view);
    for (Shape& shape : shapes) {
      if (!shape.views.empty()) by_class_[shape.shape->class_name].push_back(std::move(shape));
    }
  }
}

TrainingSample TrainingPool::draw(const std::map<std::string, double>& class_weights,
                                  int sdf_points, bool augment, Random random) const {
  double total = 0;
  for (const auto& [name, weight] : class_weights) total += weight;
  double rest = random.uniform(0, total);
  auto chosen = class_weights.begin();
  while (rest >= chosen->second && std::next(chosen) != class_weights.end()) {
    rest -= chosen->second;
    ++chosen;
  }
  const auto found = by_class_.find(chosen->first);
  if (found == by_class_.end()) {
    throw InputError(
        fmt::format("no view of class '{}' in {} training worlds, expected some: more worlds, more "
                    "frames, or a weight of 0",
                    chosen->first, worlds_.size()));
  }
  const std::vector<Shape>& shapes = found->second;
  const Shape& shape = shapes[random.index(static_cast<std::uint32_t>(shapes.size()))];
  const TrainingView& view =
      *shape.views[random.index(static_cast<std::uint32_t>(shape.views.size()))];
  const double stretch = augment && random.chance(0.5) ? random.uniform(0.85, 1.2) : 1;
  TrainingSample sample =
      makeTrainingSample(*shape.shape, view, sdf_points, stretch, random.fork(1));
  sample.shape = shape.shape->yaw_symmetry == 0 ? -1 : shape.number;
  return sample;
}

}  // namespace hydrabench
