// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/flow_sampler.h"

#include <utility>

#include "core/types/random.h"

namespace hydrabench {

torch::Tensor followFlow(const Velocity& velocity, torch::Tensor x, int steps) {
  for (int i = 0; i < steps; ++i) x = x + velocity(x, static_cast<double>(i) / steps) / steps;
  return x;
}

torch::Tensor guidedVelocity(const torch::Tensor& with, const torch::Tensor& without,
                             double weight) {
  return without + weight * (with - without);
}

torch::Tensor normalNoise(const std::vector<std::int64_t>& shape, std::uint64_t seed) {
  torch::Tensor noise = torch::empty(shape);
  Random random(seed);
  float* out = noise.data_ptr<float>();
  for (std::int64_t i = 0; i < noise.numel(); ++i) out[i] = static_cast<float>(random.normal());
  return noise;
}

}  // namespace hydrabench
