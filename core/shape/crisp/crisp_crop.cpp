// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_crop.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr float kMaxDepth = 500;  // [m]; CRISP, pixels beyond are background

// Statistics of ImageNet, as for every network trained on it.
constexpr std::array<float, 3> kMean = {0.485f, 0.456f, 0.406f};
constexpr std::array<float, 3> kDeviation = {0.229f, 0.224f, 0.225f};

/// Where a pixel of the crop reads, along one axis.
struct Tap {
  int low = 0;  ///< pixel of the image
  int high = 0;
  float weight = 0;  ///< of `high`
  int nearest = 0;
};

/// Half-pixel centres, clamped to the box: PyTorch's bilinear without aligned corners, and its
/// "nearest-exact".
std::vector<Tap> taps(int first, int last, int side) {
  const int extent = last - first + 1;
  std::vector<Tap> result(static_cast<std::size_t>(side));
  for (int i = 0; i < side; ++i) {
    const double position = (i + 0.5) * extent / side;
    const double center = std::clamp(position - 0.5, 0.0, extent - 1.0);
    const int low = static_cast<int>(center);
    Tap& tap = result[static_cast<std::size_t>(i)];
    tap.low = first + low;
    tap.high = std::min(tap.low + 1, last);
    tap.weight = static_cast<float>(center - low);
    tap.nearest = first + std::min(static_cast<int>(position), extent - 1);
  }
  return result;
}

Eigen::Vector3f colorAt(const Image<Rgb>& image, int u, int v) {
  if (!image.contains(u, v)) return Eigen::Vector3f::Zero();
  const Rgb& c = image(u, v);
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

std::optional<Eigen::Vector3f> pointAt(const ShapeObservation& view, int u, int v) {
  if (!view.mask.contains(u, v) || view.mask(u, v) == 0) return std::nullopt;
  const float depth = view.depth(u, v);
  if (!(depth > 0 && depth < kMaxDepth)) return std::nullopt;
  const Eigen::Vector3f point = view.camera.backproject(u, v, depth).cast<float>();
  return point.allFinite() ? std::optional(point) : std::nullopt;
}

}  // namespace

std::optional<PixelBox> tightBox(const Image<std::uint8_t>& mask) {
  PixelBox box{mask.width(), mask.height(), -1, -1};
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask(u, v) == 0) continue;
      box = {std::min(box.u0, u), std::min(box.v0, v), std::max(box.u1, u), v};
    }
  }
  return box.v1 >= 0 ? std::optional(box) : std::nullopt;
}

CrispCrop makeCrispCrop(const ShapeObservation& observation, const PixelBox& box,
                        const CrispManifest& manifest, int side) {
  assert(!observation.color.empty() && !observation.depth.empty());
  assert(box.u0 <= box.u1 && box.v0 <= box.v1 && side > 0);
  CrispCrop crop;
  crop.box = box;
  crop.side = side;
  const std::size_t area = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  crop.color.resize(3 * area);
  crop.valid.assign(area, 0);
  crop.points.assign(area, Eigen::Vector3f::Zero());

  const bool normalise = manifest.input_normalisation == "imagenet";
  const std::vector<Tap> columns = taps(box.u0, box.u1, side);
  const std::vector<Tap> rows = taps(box.v0, box.v1, side);
  for (int v = box.v0; v <= box.v1; ++v) {
    for (int u = box.u0; u <= box.u1; ++u)
      crop.measured_pixels += pointAt(observation, u, v) ? 1 : 0;
  }
  std::size_t i = 0;
  for (const Tap& row : rows) {
    for (const Tap& column : columns) {
      const auto blend = [&](int v) -> Eigen::Vector3f {
        return (1 - column.weight) * colorAt(observation.color, column.low, v) +
               column.weight * colorAt(observation.color, column.high, v);
      };
      const Eigen::Vector3f color =
          ((1 - row.weight) * blend(row.low) + row.weight * blend(row.high)) / 255.0f;
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = color[static_cast<Eigen::Index>(c)];
        crop.color[c * area + i] = normalise ? (value - kMean[c]) / kDeviation[c] : value;
      }
      if (const auto point = pointAt(observation, column.nearest, row.nearest)) {
        crop.valid[i] = 1;
        crop.points[i] = *point;
      }
      ++i;
    }
  }
  return crop;
}

std::optional<CrispCrop> makeCrispCrop(const ShapeObservation& observation,
                                       const CrispManifest& manifest, int side) {
  const std::optional<PixelBox> box = tightBox(observation.mask);
  if (!box) return std::nullopt;
  return makeCrispCrop(observation, *box, manifest, side);
}

NocsPairs gatherNocsPairs(const CrispCrop& crop, std::span<const float> nocs,
                          const CrispManifest& manifest, std::size_t max_pairs,
                          std::uint64_t seed) {
  const std::size_t area = crop.valid.size();
  assert(nocs.size() == 3 * area);
  std::vector<std::uint32_t> pixels;
  for (std::size_t i = 0; i < area; ++i) {
    if (crop.valid[i] != 0) pixels.push_back(static_cast<std::uint32_t>(i));
  }
  if (pixels.size() > max_pairs) {
    Random random(seed);
    std::vector<std::uint32_t> drawn(max_pairs);
    for (std::uint32_t& pixel : drawn) {
      pixel = pixels[random.index(static_cast<std::uint32_t>(pixels.size()))];
    }
    pixels = std::move(drawn);
  }
  NocsPairs pairs;
  for (const std::uint32_t i : pixels) {
    const Eigen::Vector3d value(nocs[i], nocs[area + i], nocs[2 * area + i]);
    pairs.nocs.push_back(manifest.isMetric() ? value : Eigen::Vector3d(2 * (value.array() - 0.5)));
    pairs.points.push_back(crop.points[i].cast<double>());
  }
  return pairs;
}

}  // namespace hydrabench
