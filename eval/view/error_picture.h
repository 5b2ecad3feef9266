// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// A ground-truth object and what each method made of it.
struct ObjectComparison {
  const GroundTruthObject* truth = nullptr;
  std::vector<const Mesh*> estimates;  ///< world frame, one per method; null: not found
};

/// Scored objects that differ: the first of every variant, then the second and so on, at most
/// `count`. Estimates are those that one-to-one matching within `gate_m` gives each object, under
/// whatever number it has in the prediction.
std::vector<ObjectComparison> compareObjects(const GroundTruth& truth,
                                             const std::vector<Prediction>& predictions,
                                             std::size_t count, double gate_m = 0.5);

struct ErrorPictureStyle {
  int tile_px = 230;
  double max_error_m = 0.2;  ///< end of the colour scale; larger errors have its last colour
  std::size_t points = 1500;
};

/// Rows are objects, two pictures per method: the estimate (green) with points of the true surface
/// (black), and the true surface coloured by each point's distance to the estimate, with its mean.
/// The scale stands below.
Image<Rgb> errorPicture(const std::vector<ObjectComparison>& objects,
                        const std::vector<std::string>& methods,
                        const ErrorPictureStyle& style = {});

/// Colours of a scale from 0 to 1 that brighten evenly, so that a print in grey can be read
/// (viridis).
Rgb scaleColor(double x);

}  // namespace hydrabench
