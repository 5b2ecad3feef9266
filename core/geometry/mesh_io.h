// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// Reads PLY (ascii, binary) or OBJ, by extension. Polygons are triangulated. Throws InputError
/// naming file, field and value for: a missing or truncated file, counts the file is too short to
/// hold, non-finite vertices, indices out of range.
Mesh readMesh(const std::filesystem::path& path);

/// Writes binary little-endian PLY (float vertices, uchar colours) or OBJ, by extension;
/// atomically. Throws OutputError.
void writeMesh(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace hydrabench
