// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "eval/datasets/dataset.h"

namespace hydrabench {

/// The folder ground_truth of docs/datasets.md: objects.yaml, meshes/*.ply (object frame),
/// scene.ply, trajectory.txt. Meshes are stored in float; vertices that are exact in float read
/// back bit-equal.
void writeGroundTruth(const std::filesystem::path& folder, const GroundTruth& ground_truth);

/// Throws InputError for what is missing or malformed, and for a list of objects that is empty.
GroundTruth readGroundTruth(const std::filesystem::path& folder);

}  // namespace hydrabench
