// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/types/lidar_scan.h"

namespace hydrabench {

/// Throws InputError, naming the stamp, the field, its value and what was expected, unless every
/// list has one entry per point or none, the sensor has rows and columns, rings are below its rows,
/// times lie within the sweep, poses are finite, and the sweep does not end before it starts.
/// Points without a return are no fault.
void requireUsable(const LidarScan& scan);

}  // namespace hydrabench
