// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "metrics/detection.h"

namespace hydrabench {

/// What detection must count, by the definitions alone: under `exists` an object counts if any
/// same-label partner is inside the gate; under `one_to_one` as many pairs as possible, found by
/// augmenting paths (Kuhn 1955) over who is inside whose gate. Shares no code with metrics/matching
/// but the gate itself, and knows nothing of distances or ids.
CountsByClass expectedCounts(std::span<const DetectionObject> estimates,
                             std::span<const DetectionObject> truths, Matching matching,
                             const Threshold& threshold);

}  // namespace hydrabench
