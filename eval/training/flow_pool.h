// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/shape/latent_flow/pose_tokens.h"
#include "core/shape/latent_flow/view_grid.h"
#include "core/types/random.h"
#include "eval/training/latent_flow_training_config.h"
#include "eval/training/training_pool.h"

namespace hydrabench {

/// A view and the pose to be found in it.
struct PoseSample {
  PointInput input;
  PoseTokens pose;
};

/// A view in one of the frames that its object may be estimated in, and which latent shape belongs
/// there.
struct LatentSample {
  ViewGrid view;
  std::size_t latent = 0;  ///< row: number of the shape in FlowPool::shapes() * grids + grid
};

/// Distances of one shape in one of its frames.
struct FieldSample {
  const ShapeGrid* grid = nullptr;
  std::vector<Eigen::Vector3f> points;  ///< in the grid's frame
  std::vector<float> distances;         ///< in its units
};

/// The rooms and streets of one split in memory, and what is drawn from them.
class FlowPool {
 public:
  /// Makes the worlds or reads them from `cache`, one at a time; `progress` may end it with false.
  FlowPool(const LatentFlowTrainingConfig& config, InstanceSplit split,
           const std::filesystem::path& cache,
           const std::function<bool(int world, int worlds)>& progress);
  bool complete() const { return complete_; }

  const std::vector<TrainingPool::Shape>& shapes() const { return shapes_; }
  int grids() const { return grids_; }

  PoseSample drawPose(bool augment, Random random) const;
  LatentSample drawLatent(bool augment, Random random) const;
  FieldSample drawField(int points, Random random) const;

 private:
  /// Index into shapes(): class by weight, then any of its shapes.
  std::size_t drawShape(Random& random) const;

  LatentFlowTrainingConfig config_;
  TrainingPool rooms_;
  TrainingPool streets_;
  std::vector<TrainingPool::Shape> shapes_;
  std::map<std::string, std::vector<std::size_t>> by_class_;  ///< with a weight above 0
  double total_weight_ = 0;
  int grids_ = 0;
  bool complete_ = false;
};

}  // namespace hydrabench
