// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/yardstick.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr std::size_t kRow = 64;
constexpr std::size_t kRows = 4096;  // 2 MB: beyond the first caches, as a map is

}  // namespace

Yardstick::Yardstick() : voxels_(kRow * kRows) {}

double Yardstick::measure() {
  const auto start = std::chrono::steady_clock::now();
  parallelFor(
      kRows,
      [&](std::size_t row) {
        const float y = static_cast<float>(row) * 1e-3f;
        for (std::size_t i = 0; i < kRow; ++i) {
          Voxel& voxel = voxels_[row * kRow + i];
          const float x = static_cast<float>(i) * 1e-2f;
          const float sdf = std::clamp(2.0f - std::sqrt(x * x + y * y + 1.0f), -0.3f, 0.3f);
          const float weight = 1.0f / (1.0f + x * x + y);
          const float total = voxel.weight + weight;
          voxel.distance = (voxel.distance * voxel.weight + sdf * weight) / total;
          voxel.weight = std::min(total, 1e5f);
        }
      },
      64);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace hydrabench
