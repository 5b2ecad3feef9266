// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/depth_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/noise_field.h"

namespace hydrabench {
namespace {

constexpr std::size_t kRowsPerTask = 16;
constexpr float kEdgeStep =
    0.05f;  // a jump of more than this share of the depth is an edge, not a slope
constexpr std::uint64_t kAxialStream = 1;
constexpr std::uint64_t kFieldStream = 2;
constexpr std::uint64_t kPlaceStream = 3;

/// True where a pixel within `radius` along the row or column lies on another surface.
bool besideEdge(const Image<float>& depth, int u, int v, int radius) {
  const float z = depth(u, v);
  for (int step = 1; step <= radius; ++step) {
    const std::pair<int, int> neighbours[] = {
        {u - step, v}, {u + step, v}, {u, v - step}, {u, v + step}};
    for (const auto& [x, y] : neighbours) {
      if (!depth.contains(x, y)) continue;
      const float other = depth(x, y);
      if (std::abs(other - z) > kEdgeStep * std::max(z, other)) return true;
    }
  }
  return false;
}

}  // namespace

DepthNoiseConfig DepthNoiseConfig::off() {
  DepthNoiseConfig config;
  config.axial_constant_m = config.axial_quadratic = config.lateral_px = 0;
  config.disparity_step_px = config.quantum_m = 0;
  config.edge_dropout = config.random_dropout = 0;
  config.grazing_start_deg = 90;
  return config;
}

void read(ConfigReader& reader, DepthNoiseConfig& config) {
  reader.field("axial_constant_m", config.axial_constant_m, {0, 1});
  reader.field("axial_quadratic_per_m", config.axial_quadratic, {0, 1});
  reader.field("correlated_share", config.correlated_share, {0, 1});
  reader.field("correlation_px", config.correlation_px, {1, 1000});
  reader.field("lateral_px", config.lateral_px, {0, 10});
  reader.field("disparity_step_px", config.disparity_step_px, {0, 10});
  reader.field("baseline_m", config.baseline_m, {0.001, 10});
  reader.field("quantum_m", config.quantum_m, {0, 1});
  reader.field("edge_dropout", config.edge_dropout, {0, 1});
  reader.field("edge_radius_px", config.edge_radius_px, {0, 20});
  reader.field("grazing_start_deg", config.grazing_start_deg, {0, 90});
  reader.field("random_dropout", config.random_dropout, {0, 1});
}

double axialSigma(const DepthNoiseConfig& config, double depth_m) {
  return config.axial_constant_m + config.axial_quadratic * depth_m * depth_m;
}

Image<float> noisyDepth(const RenderedView& view, const Camera& camera,
                        const DepthNoiseConfig& config, std::uint64_t seed) {
  const int width = view.depth.width();
  Image<float> result(width, view.depth.height());
  const NoiseField field(width, view.depth.height(), config.correlation_px,
                         hashSeed(seed, kFieldStream));
  const std::uint64_t axial_seed = hashSeed(seed, kAxialStream);
  const std::uint64_t place_seed = hashSeed(seed, kPlaceStream);
  const auto own_weight = static_cast<float>(std::sqrt(1 - config.correlated_share));
  const auto common_weight = static_cast<float>(std::sqrt(config.correlated_share));
  const auto constant = static_cast<float>(config.axial_constant_m);
  const auto quadratic = static_cast<float>(config.axial_quadratic);
  const auto lateral = static_cast<float>(config.lateral_px);
  // Disparity d = f b / z, in units of its step.
  const auto steps = static_cast<float>(
      config.disparity_step_px > 0 ? camera.fx * config.baseline_m / config.disparity_step_px : 0);
  const auto quantum = static_cast<float>(config.quantum_m);
  const auto edge_dropout = static_cast<float>(config.edge_dropout);
  const auto random_dropout = static_cast<float>(config.random_dropout);
  const auto grazing =
      static_cast<float>(255 * std::cos(config.grazing_start_deg * std::numbers::pi / 180));

  const auto pixel = [&](int u, int v) -> float {
    const std::size_t index =
        static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
    int from_u = u;
    int from_v = v;
    const std::uint64_t place = pixelBits(place_seed, index);
    if (lateral > 0) {
      const std::uint64_t more = mixBits(place);
      from_u = u + nearestInt(lateral * cheapNormal(more));
      from_v = v + nearestInt(lateral * cheapNormal(mixBits(more)));
      if (!view.depth.contains(from_u, from_v)) return 0;
    }
    float z = view.depth(from_u, from_v);
    if (z <= 0) return 0;
    float lost = random_dropout;
    const float incidence = view.incidence(from_u, from_v);
    if (incidence < grazing) lost = std::max(lost, 1 - incidence / grazing);
    if (lost > 0 && unitFrom16(place) < lost) return 0;
    if (edge_dropout > 0 && unitFrom16(place >> 16) < edge_dropout &&
        besideEdge(view.depth, u, v, config.edge_radius_px)) {
      return 0;
    }
    const float sigma = constant + quadratic * z * z;
    if (sigma > 0) {
      z += sigma * (own_weight * cheapNormal(pixelBits(axial_seed, index)) +
                    common_weight * field.at(u, v));
    }
    if (steps > 0) z = steps / std::max(1.0f, std::nearbyint(steps / std::max(z, 0.01f)));
    if (quantum > 0) z = quantum * std::nearbyint(z / quantum);
    return std::max(z, 0.0f);
  };
  parallelForRanges(static_cast<std::size_t>(result.height()), kRowsPerTask,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t row = begin; row < end; ++row) {
                        const int v = static_cast<int>(row);
                        for (int u = 0; u < width; ++u) result(u, v) = pixel(u, v);
                      }
                    });
  return result;
}

void addColorNoise(double sigma, std::uint64_t seed, Image<Rgb>& color) {
  if (sigma <= 0) return;
  const auto deviation = static_cast<float>(sigma);
  const auto disturb = [&](std::uint8_t value, std::uint64_t bits) {
    const float noisy = static_cast<float>(value) + deviation * cheapNormal(bits);
    return static_cast<std::uint8_t>(std::clamp(noisy + 0.5f, 0.0f, 255.0f));
  };
  const auto width = static_cast<std::size_t>(color.width());
  parallelForRanges(
      static_cast<std::size_t>(color.height()), kRowsPerTask,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * width; i < end * width; ++i) {
          const std::uint64_t bits = pixelBits(seed, i);
          const std::uint64_t more = mixBits(bits);
          Rgb& pixel = color.data()[i];
          pixel = {disturb(pixel.r, bits), disturb(pixel.g, more), disturb(pixel.b, mixBits(more))};
        }
      });
}

}  // namespace hydrabench
