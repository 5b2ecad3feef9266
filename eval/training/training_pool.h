// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/shape/crisp/point_input.h"
#include "core/types/random.h"
#include "eval/training/training_world.h"

namespace hydrabench {

/// One view with everything the losses need. Object coordinates as in TrainingShape; objects
/// without a front face the camera.
struct TrainingSample {
  static constexpr int kPoses = 2;  ///< yaws under which the object looks the same

  PointInput input;
  std::string class_name;
  std::int64_t shape =
      0;  ///< number of the shape in all training worlds, -1 where its own yaw is lost
  bool augmented = false;  ///< stretched
  double half_extent_m = 0;
  Eigen::Vector3d center_level = Eigen::Vector3d::Zero();  ///< [m]
  std::vector<float> nocs[kPoses];                         ///< PointInput::kObjectPoints x 3
  std::vector<float> weights;                ///< per object point; 0 where it is not on the object
  std::array<float, 6> direct[kPoses] = {};  ///< as PointNetwork's direct output
  std::vector<float> points;                 ///< n x 3
  std::vector<float> distances;              ///< n
};

/// Training worlds in memory, made or read from the cache when they are asked for.
class TrainingPool {
 public:
  TrainingPool(const TrainingWorldConfig& config, InstanceSplit split, std::filesystem::path cache);
  /// Makes worlds [begin, end) available and drops all others.
  void load(std::uint64_t begin, std::uint64_t end);

  struct Shape {
    std::int64_t number = 0;  ///< world * kShapesPerWorld + index
    const TrainingShape* shape = nullptr;
    std::vector<const TrainingView*> views;
  };
  static constexpr std::int64_t kShapesPerWorld = 1000;
  /// Of the worlds there are, that have views.
  const std::map<std::string, std::vector<Shape>>& shapesByClass() const { return by_class_; }

  /// A random view: class by weight, then shape, then view.
  /// @param sdf_points  distances to draw
  TrainingSample draw(const std::map<std::string, double>& class_weights, int sdf_points,
                      bool augment, Random random) const;

 private:
  TrainingWorldConfig config_;
  InstanceSplit split_;
  std::filesystem::path cache_;
  std::map<std::uint64_t, std::shared_ptr<const TrainingWorld>> worlds_;
  std::map<std::string, std::vector<Shape>> by_class_;
};

/// The sample of one view.
TrainingSample makeTrainingSample(const TrainingShape& shape, const TrainingView& view,
                                  int sdf_points, double stretch, Random random);

/// Makes the world or reads it from the cache.
TrainingWorld cachedTrainingWorld(const TrainingWorldConfig& config, InstanceSplit split,
                                  std::uint64_t index, const std::filesystem::path& cache);

}  // namespace hydrabench
