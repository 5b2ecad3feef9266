// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/types/color.h"
#include "core/types/image.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// Pictures of equal size in a grid, row by row, each with its label below (no label: no text).
Image<Rgb> tiled(const std::vector<Image<Rgb>>& pictures, const std::vector<std::string>& labels,
                 int columns, Rgb background);

struct ContactSheetStyle {
  int cell_px = 150;
  int blocks = 2;  ///< families side by side
};
/// One row for every family: the nominal instance, then drawn ones, all of a row at one scale, with
/// name and class above.
/// @param seed  picks the instances (evaluation split)
Image<Rgb> renderContactSheet(std::span<const ShapeFamily> families, std::uint64_t seed,
                              int instances_per_family, const ContactSheetStyle& style = {});

}  // namespace hydrabench
