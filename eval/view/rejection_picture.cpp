// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/rejection_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "eval/simulation/label_text.h"

namespace hydrabench {
namespace {

constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kInk{30, 33, 38};
constexpr Rgb kFaintInk{110, 115, 123};
constexpr Rgb kObserved{40, 120, 230};
constexpr Rgb kProjected{240, 130, 20};
constexpr Rgb kBoth{50, 190, 90};
constexpr Rgb kOutside{225, 227, 230};  // of the image
constexpr Rgb kNoColor{150, 150, 150};
constexpr int kTile = 240;  // [px]
constexpr int kGap = 12;
constexpr int kTextHeightPx = 52;
constexpr int kLegend = 30;
constexpr int kColumns = 6;

/// Part of an image, a square in its pixels.
struct Crop {
  double u = 0;  ///< left
  double v = 0;  ///< top
  double side = 1;
};

/// Around all pixels that are set in either mask, with room at the borders.
Crop cropAround(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b) {
  int u_low = a.width(), u_high = -1, v_low = a.height(), v_high = -1;
  for (int v = 0; v < a.height(); ++v) {
    for (int u = 0; u < a.width(); ++u) {
      if (a(u, v) == 0 && b(u, v) == 0) continue;
      u_low = std::min(u_low, u);
      u_high = std::max(u_high, u);
      v_low = std::min(v_low, v);
      v_high = std::max(v_high, v);
    }
  }
  if (u_high < 0) return {0, 0, static_cast<double>(a.width())};
  const double side = 1.3 * std::max({u_high - u_low + 1, v_high - v_low + 1, 24});
  return {0.5 * (u_low + u_high + 1) - side / 2, 0.5 * (v_low + v_high + 1) - side / 2, side};
}

/// The observed mask in the full image.
Image<std::uint8_t> fullMask(const ShapeCandidate& candidate) {
  Image<std::uint8_t> full(candidate.camera.width, candidate.camera.height);
  for (int v = 0; v < candidate.mask.height(); ++v) {
    for (int u = 0; u < candidate.mask.width(); ++u) {
      if (full.contains(candidate.mask_u + u, candidate.mask_v + v)) {
        full(candidate.mask_u + u, candidate.mask_v + v) = candidate.mask(u, v);
      }
    }
  }
  return full;
}

Rgb blended(Rgb below, Rgb above, double weight) {
  const auto mix = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround((1 - weight) * a + weight * b));
  };
  return {mix(below.r, above.r), mix(below.g, above.g), mix(below.b, above.b)};
}

bool onOutline(const Image<std::uint8_t>& mask, int u, int v) {
  if (mask(u, v) == 0) return false;
  for (const auto& [du, dv] :
       {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
    if (!mask.contains(u + du, v + dv) || mask(u + du, v + dv) == 0) return true;
  }
  return false;
}

void paste(const Image<Rgb>& part, int left, int top, Image<Rgb>& whole) {
  for (int v = 0; v < part.height(); ++v) {
    for (int u = 0; u < part.width(); ++u) whole(left + u, top + v) = part(u, v);
  }
}

int drawLegendEntry(Image<Rgb>& image, int left, Rgb color, const std::string& text) {
  for (int v = 8; v < 22; ++v) {
    for (int u = 0; u < 14; ++u) {
      const bool border = u == 0 || u == 13 || v == 8 || v == 21;
      if (image.contains(left + u, v)) image(left + u, v) = border ? kInk : color;
    }
  }
  drawText(image, left + 20, 8, text, kInk, 2);
  return left + 20 + textWidth(text, 2) + 24;
}

}  // namespace

ColorAt colorAt(const Dataset& dataset) {
  std::map<std::int64_t, std::size_t> index_of;
  const std::vector<StampedPose>& poses = dataset.groundTruth().trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i) index_of.emplace(poses[i].stamp_ns, i);
  return [&dataset, index_of](std::int64_t stamp_ns) {
    const auto found = index_of.find(stamp_ns);
    return found == index_of.end() ? Image<Rgb>() : dataset.frame(found->second).color;
  };
}

MaskCut maskCut(const ShapeCandidate& candidate, const Image<Rgb>& color, const RmccConfig& config,
                int tile_px) {
  const Image<std::uint8_t> observed = fullMask(candidate);
  const Image<std::uint8_t> projected = projectedMask(
      transformed(candidate.T_world_camera.inverse(), candidate.mesh), candidate.camera, config);
  // Points leave gaps; the outline is that of the surface.
  RmccConfig whole = config;
  whole.mask = "raster";
  const Image<std::uint8_t> silhouette = projectedMask(
      transformed(candidate.T_world_camera.inverse(), candidate.mesh), candidate.camera, whole);
  const Crop crop = cropAround(observed, projected);
  MaskCut cut{Image<Rgb>(tile_px, tile_px, kOutside), Image<std::uint8_t>(tile_px, tile_px, 0)};
  for (int v = 0; v < tile_px; ++v) {
    for (int u = 0; u < tile_px; ++u) {
      const int x = static_cast<int>(std::floor(crop.u + (u + 0.5) * crop.side / tile_px));
      const int y = static_cast<int>(std::floor(crop.v + (v + 0.5) * crop.side / tile_px));
      if (!observed.contains(x, y)) continue;
      cut.color(u, v) = color.contains(x, y) ? color(x, y) : kNoColor;
      int parts = 0;
      if (observed(x, y) != 0) parts |= MaskCut::kObserved;
      if (projected(x, y) != 0) parts |= MaskCut::kProjected;
      if (onOutline(observed, x, y)) parts |= MaskCut::kObservedOutline;
      if (onOutline(silhouette, x, y)) parts |= MaskCut::kProjectedOutline;
      cut.parts(u, v) = static_cast<std::uint8_t>(parts);
    }
  }
  return cut;
}

Image<Rgb> maskOverlay(const ShapeCandidate& candidate, const Image<Rgb>& color,
                       const RmccConfig& config, int tile_px) {
  const MaskCut cut = maskCut(candidate, color, config, tile_px);
  Image<Rgb> tile = cut.color;
  std::transform(tile.begin(), tile.end(), cut.parts.begin(), tile.begin(),
                 [](Rgb pixel, std::uint8_t parts) {
                   const bool seen = (parts & MaskCut::kObserved) != 0;
                   const bool hit = (parts & MaskCut::kProjected) != 0;
                   const Rgb paint = seen && hit ? kBoth : seen ? kObserved : kProjected;
                   if (seen || hit) pixel = blended(pixel, paint, 0.42);
                   if ((parts & MaskCut::kProjectedOutline) != 0) {
                     pixel = blended(pixel, kProjected, 0.9);
                   }
                   if ((parts & MaskCut::kObservedOutline) != 0) {
                     pixel = blended(pixel, kObserved, 0.9);
                   }
                   return pixel;
                 });
  return tile;
}

Image<Rgb> rejectionPicture(const std::vector<ShapeCandidate>& candidates,
                            const LabelSpace& label_space, const ColorAt& color_at,
                            const RmccConfig& config, std::size_t count) {
  std::vector<const ShapeCandidate*> rejected;
  for (const ShapeCandidate& candidate : candidates) {
    if (candidate.hasEstimate() && !candidate.accepted) rejected.push_back(&candidate);
  }
  if (rejected.empty()) return {};
  std::stable_sort(rejected.begin(), rejected.end(),
                   [](const auto* a, const auto* b) { return a->overlap < b->overlap; });
  rejected.resize(std::min(rejected.size(), count));

  const int columns = std::max(3, std::min(kColumns, static_cast<int>(rejected.size())));
  const int rows = (static_cast<int>(rejected.size()) + columns - 1) / columns;
  const int cell = kTile + kTextHeightPx + kGap;
  Image<Rgb> image(kGap + columns * (kTile + kGap), kLegend + kGap + rows * cell, kPaper);
  int left = kGap;
  left = drawLegendEntry(image, left, kObserved, "observed");
  left = drawLegendEntry(image, left, kProjected, "projected");
  drawLegendEntry(image, left, kBoth, "both");
  for (std::size_t i = 0; i < rejected.size(); ++i) {
    const ShapeCandidate& candidate = *rejected[i];
    const int u = kGap + static_cast<int>(i) % columns * (kTile + kGap);
    const int v = kLegend + kGap + static_cast<int>(i) / columns * cell;
    paste(maskOverlay(candidate, color_at(candidate.view_stamp_ns), config, kTile), u, v, image);
    drawText(image, u, v + kTile + 6,
             fmt::format("{} (track {})", label_space.nameOf(candidate.label), candidate.track),
             kInk, 2);
    drawText(image, u, v + kTile + 24,
             fmt::format("O {:.2f}  coverage {:.2f}{}", candidate.overlap, candidate.coverage,
                         candidate.depth_residual_m
                             ? fmt::format("  depth {:.1f} cm", 100 * *candidate.depth_residual_m)
                             : ""),
             kInk, 1);
    drawText(image, u, v + kTile + 36, "rejected: " + candidate.reason, kFaintInk, 1);
  }
  return image;
}

}  // namespace hydrabench
