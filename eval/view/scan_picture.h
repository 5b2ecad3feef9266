// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/types/color.h"
#include "core/types/image.h"
#include "core/types/lidar_scan.h"

namespace hydrabench {

/// A sweep from above, the sensor in the middle and ahead being up, red points above blue ones; and
/// below it as the sensor saw it: one row a ring, straight ahead in the middle, near red and far
/// blue. Points whose ring is not known are put into the row of their elevation. The robot's motion
/// during the sweep is undone above, not below.
/// @param radius_m  what is farther to a side is not drawn
Image<Rgb> scanPicture(const LidarScan& scan, double radius_m = 30);

}  // namespace hydrabench
