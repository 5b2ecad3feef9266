// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/graph/shape_candidate.h"
#include "core/objects/rmcc.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// The view a shape was estimated from, cut out around the object, as files a browser reads.
struct ViewCut {
  std::string color;  ///< JPEG
  std::string parts;  ///< grey PNG of the same size, 16 times the bits of MaskCut::parts
};

/// A candidate and the check it went through.
struct CandidateView {
  const ShapeCandidate* candidate = nullptr;
  const RmccConfig* config = nullptr;
};

/// Cuts of all views, in their order; every frame is made or read once.
std::vector<ViewCut> viewCuts(const Dataset& dataset, const std::vector<CandidateView>& views,
                              int size_px);

}  // namespace hydrabench
