// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// The two file formats of mesh_io.h, as text in memory. Readers of our own rather than OpenMesh's,
/// which split vertices of meshes that are not manifold (scans often are not), so that counts
/// change, and which believe a header that states 10^12 vertices.
///
/// Parsers throw InputError without the name of the file, which readMesh puts in front.
Mesh parsePly(std::string_view content);
Mesh parseObj(std::string_view content);
std::string formatPly(const Mesh& mesh);
std::string formatObj(const Mesh& mesh);

/// Adds a polygon as a fan of triangles around its first corner.
void addPolygon(const std::vector<int>& corners, Mesh& mesh);

/// A number in text, all of `token`; NaN and infinity are read as such. nullopt: not a number.
std::optional<double> parseNumber(std::string_view token);

}  // namespace hydrabench
