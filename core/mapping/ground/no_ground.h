// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/mapping/ground/ground_segmenter.h"

namespace hydrabench {

/// Judges no point: mapping without knowledge of the ground.
class NoGround : public GroundSegmenter {
 public:
  GroundMask segment(const GroundScan& scan) override;
};

}  // namespace hydrabench
