// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/shape/crisp/point_input.h"

namespace hydrabench {

/// The frame of an object as the numbers that the flow of poses works on, relative to the frame
/// that a view is seen in (PointInput::frame): three tokens of up to three numbers, the rest 0.
/// Rotation: cosine and sine of the yaw, which is all that is left of it where gravity is known
/// (the first column of the 6-D rotation of Zhou et al., CVPR 2019). Translation: of the box
/// centre. Scale: log of the half extent.
struct PoseTokens {
  static constexpr int kTokens = 3;
  static constexpr int kWidth = 3;
  static constexpr int kNumbers = kTokens * kWidth;
  std::array<float, kNumbers> numbers = {};
};

/// @param object  in the level frame, as view
PoseTokens toPoseTokens(const LocalFrame& object, const LocalFrame& view);
/// The inverse, for any numbers: cosine and sine need not be of length 1.
LocalFrame fromPoseTokens(const PoseTokens& tokens, const LocalFrame& view);

}  // namespace hydrabench
