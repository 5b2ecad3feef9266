// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "eval/datasets/dataset.h"

namespace hydrabench {

struct ExportOptions {
  std::size_t num_frames = 0;  ///< the first so many frames; 0: all
  bool replace = false;        ///< swap a folder that exists instead of refusing
};

/// Writes a dataset as the plain folder of docs/datasets.md: images, poses, and ground truth.
/// Frames are written in parallel; the bytes do not depend on the number of threads. The folder
/// appears complete or not at all. Reading it back (type: folder) gives the same frames and ground
/// truth, bit for bit.
///
/// @param advance  called once after every frame, from any thread
/// Throws OutputError, and InputError for a frame the layout cannot hold without loss (depth that
/// is no multiple of the quantum).
void exportDataset(const Dataset& dataset, const std::filesystem::path& path,
                   const ExportOptions& options = {},
                   const std::function<void()>& advance = nullptr);

}  // namespace hydrabench
