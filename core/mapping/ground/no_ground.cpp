// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/no_ground.h"

#include <algorithm>

namespace hydrabench {

GroundMask NoGround::segment(const GroundScan& scan) {
  requireUsable(scan);
  GroundMask mask;
  mask.classes.assign(scan.points.size(), GroundClass::kNotJudged);
  mask.num_invalid = scan.points.size() - static_cast<std::size_t>(std::count_if(
                                              scan.points.begin(), scan.points.end(), isMeasured));
  return mask;
}

}  // namespace hydrabench
