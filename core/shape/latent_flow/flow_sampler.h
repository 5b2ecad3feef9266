// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <torch/torch.h>

namespace hydrabench {

// Flow matching (Lipman et al., ICLR 2023) along straight lines (rectified flow, Liu et al., ICLR
// 2023): x_t = (1 - t) x_0 + t x_1, from noise x_0 to data x_1, whose velocity is x_1 - x_0. A
// network learns the mean velocity at (x_t, t); following it from noise draws from the data.

/// Velocity at x [B, ...] and time t in [0, 1], of x's shape.
using Velocity = std::function<torch::Tensor(const torch::Tensor& x, double t)>;

/// Follows the velocity from t = 0 to 1 in `steps` >= 1 equal steps (Euler).
torch::Tensor followFlow(const Velocity& velocity, torch::Tensor x, int steps);

/// Classifier-free guidance (Ho and Salimans 2022): v_without + weight (v_with - v_without). Weight
/// 1 is the velocity with the condition, 0 the one without; above 1 the condition counts for more
/// than it says.
torch::Tensor guidedVelocity(const torch::Tensor& with, const torch::Tensor& without,
                             double weight);

/// Standard normal numbers: a function of the seed, whatever libtorch's own generator is at.
torch::Tensor normalNoise(const std::vector<std::int64_t>& shape, std::uint64_t seed);

}  // namespace hydrabench
