// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/distance_loss.h"

namespace hydrabench {

torch::Tensor distanceLoss(const torch::Tensor& predicted, const torch::Tensor& target,
                           double clamp, const torch::Tensor& quantile) {
  const torch::Tensor clamped = target.clamp(-clamp, clamp);
  const torch::Tensor weight = 0.5 + 0.5 * (clamped.abs() < 0.1).to(torch::kFloat32);
  const torch::Tensor excess = predicted.to(torch::kFloat32) - clamped;
  // Twice the pinball loss: as large as the absolute error at the median.
  const torch::Tensor loss = torch::max(2 * (1 - quantile) * excess, -2 * quantile * excess);
  return (weight * loss).mean();
}

}  // namespace hydrabench
