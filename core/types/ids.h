// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hydrabench {

/// Semantic class. The built-in worlds use the label ids of the uHumans2 office, so that configs of
/// Hydra and Khronos fit.
using Label = std::int32_t;
inline constexpr Label kUnknownLabel = 0;

/// One object in one frame. Valid within that frame only: the same object carries another id in the
/// next frame. 0: no instance.
using InstanceId = std::int32_t;
inline constexpr InstanceId kNoInstance = 0;

/// One object for the length of a run, in ground truth or in a prediction. 64 bits; never passes
/// through a double.
using ObjectId = std::uint64_t;

}  // namespace hydrabench
