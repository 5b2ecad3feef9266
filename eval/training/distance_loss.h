// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <torch/torch.h>

namespace hydrabench {

/// Weighted L1 between predicted and clamped true distances: what lies far from the surface counts
/// half. The prediction is not clamped: its gradient would vanish.
/// @param quantile  of the true distance that is learned, one or [B, 1]: 0.5 its median. Below
///                  half, a prediction that is too large costs more than one too small
torch::Tensor distanceLoss(const torch::Tensor& predicted, const torch::Tensor& target,
                           double clamp, const torch::Tensor& quantile = torch::tensor(0.5f));

}  // namespace hydrabench
