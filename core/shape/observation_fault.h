// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// Why no shape can come of a view that is seen by its depth: a few words, nullptr where something
/// can. Asks for a valid camera and pose, images of its size, a mask that is not empty, and 5
/// pixels with depth in it (CRISP drops an object with fewer).
const char* faultOf(const ShapeObservation& view, bool needs_color);

}  // namespace hydrabench
