// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/mapping/ground/ground_scan.h"

namespace hydrabench {

/// Tells the ground in the scans of one LiDAR, given in the order of time. An implementation may
/// learn from scan to scan: one instance per sensor and run. The same scans give the same bytes,
/// for any number of threads.
class GroundSegmenter {
 public:
  virtual ~GroundSegmenter() = default;
  /// Throws InputError where the scan is not usable, see requireUsable(), or lacks what the
  /// implementation needs; nothing is learned from it then. A scan without points gives no classes.
  virtual GroundMask segment(const GroundScan& scan) = 0;
};

}  // namespace hydrabench
