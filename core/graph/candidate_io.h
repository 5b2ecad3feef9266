// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/graph/shape_candidate.h"

namespace hydrabench {

inline constexpr const char* kCandidatesFile = "candidates.jsonl";

/// Writes candidates.jsonl, one line per candidate, with the meshes as PLY in candidates/ beside
/// it. Reading gives the same values, bit by bit. Throws OutputError.
void writeCandidates(const std::filesystem::path& folder,
                     const std::vector<ShapeCandidate>& candidates);
/// Empty where the folder has no candidates. Throws InputError naming file, line and field.
std::vector<ShapeCandidate> readCandidates(const std::filesystem::path& folder);

}  // namespace hydrabench
