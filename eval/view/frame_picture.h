// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Depth as colours: near red, far blue (the "turbo" map of Mikhailov 2019 in polynomial form);
/// black where nothing was measured.
Image<Rgb> depthPicture(const Image<float>& depth, float max_depth_m);

/// Every instance in a colour of its own, black for none. Neighbouring ids differ strongly.
Image<Rgb> instancePicture(const Image<InstanceId>& instances);

/// Every label in the colour of its class.
Image<Rgb> labelPicture(const Image<Label>& labels, const LabelSpace& label_space);

/// Pictures of equal size in a row, with a gap between.
Image<Rgb> sideBySide(const std::vector<Image<Rgb>>& pictures, int gap_px = 4);
/// Average over blocks of factor x factor pixels.
Image<Rgb> reduced(const Image<Rgb>& picture, int factor);

/// Colour, depth and instances of a frame, side by side.
Image<Rgb> framePicture(const Frame& frame, float max_depth_m = 5);

}  // namespace hydrabench
