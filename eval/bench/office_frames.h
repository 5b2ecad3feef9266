// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/types/frame.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {

/// 100 consecutive frames of the built-in office, 720 x 480, rendered before anything is measured.
inline const std::vector<Frame>& officeFrames() {
  static const std::vector<Frame> frames = [] {
    const SimulatedDataset dataset(SimulatedConfig::forWorld("office"));
    std::vector<Frame> drive;
    for (std::size_t i = 400; i < 500; ++i) drive.push_back(dataset.frame(i));
    return drive;
  }();
  return frames;
}

}  // namespace hydrabench
