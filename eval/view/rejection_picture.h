// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/graph/shape_candidate.h"
#include "core/objects/rmcc.h"
#include "core/types/color.h"
#include "core/types/label_space.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// Colour image at a stamp; empty where there is none.
using ColorAt = std::function<Image<Rgb>(std::int64_t stamp_ns)>;
/// Of a dataset whose poses say which stamps there are. It must outlive what is returned.
ColorAt colorAt(const Dataset& dataset);

/// The estimates that the consistency check turned down, lowest overlap first, at most `count`: the
/// view of each, cut out around it, with the observed mask in blue, the projected one in orange and
/// what they share in green, and the scores and the reason below. Empty where none was turned down;
/// tracks without an estimate have nothing to show.
/// @param config  of the method, for the projected mask
Image<Rgb> rejectionPicture(const std::vector<ShapeCandidate>& candidates,
                            const LabelSpace& label_space, const ColorAt& color_at,
                            const RmccConfig& config, std::size_t count = 24);

/// The part of a view around both masks, and which of them holds each pixel.
struct MaskCut {
  static constexpr std::uint8_t kObserved = 1;
  static constexpr std::uint8_t kProjected = 2;
  static constexpr std::uint8_t kObservedOutline = 4;
  static constexpr std::uint8_t kProjectedOutline = 8;  ///< of the surface: points leave gaps
  Image<Rgb> color;           ///< square; grey where the view has no colour, lighter outside of it
  Image<std::uint8_t> parts;  ///< of the same size, the bits above; 0 outside the view
};

/// @param color   of the view, or empty
/// @param config  of the method, for the projected mask
MaskCut maskCut(const ShapeCandidate& candidate, const Image<Rgb>& color, const RmccConfig& config,
                int tile_px);

/// The cut as one picture without text; what rejectionPicture is made of.
Image<Rgb> maskOverlay(const ShapeCandidate& candidate, const Image<Rgb>& color,
                       const RmccConfig& config, int tile_px);

}  // namespace hydrabench
