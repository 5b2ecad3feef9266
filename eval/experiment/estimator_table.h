// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/shape/shape_estimator.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// Makes an estimator for a run on a dataset. Oracles look at its ground truth; the others get
/// their config and nothing of it.
using EstimatorStart = std::function<std::shared_ptr<const ShapeEstimator>(const Dataset&)>;

/// Reads the section `estimator` of a method; its `type` picks the estimator from one table.
EstimatorStart readEstimator(ConfigReader& section);

/// Types of the table, in its order; the first is the default.
std::vector<std::string> estimatorTypes();

}  // namespace hydrabench
