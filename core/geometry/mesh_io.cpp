// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "core/geometry/mesh_format.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

enum class Format { kPly, kObj };

std::optional<Format> formatOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".ply") return Format::kPly;
  if (extension == ".obj") return Format::kObj;
  return std::nullopt;
}

void check(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3d& v = mesh.vertices[i];
    if (!v.allFinite()) {
      throw InputError(fmt::format("vertex {} is ({}, {}, {}), expected finite coordinates", i,
                                   v.x(), v.y(), v.z()));
    }
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const int corner : mesh.faces[i]) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.vertices.size()) {
        throw InputError(fmt::format("face {} refers to vertex {}, expected 0 to {}", i, corner,
                                     static_cast<long>(mesh.vertices.size()) - 1));
      }
    }
  }
}

}  // namespace

void addPolygon(const std::vector<int>& corners, Mesh& mesh) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.faces.emplace_back(corners[0], corners[i - 1], corners[i]);
  }
}

std::optional<double> parseNumber(std::string_view token) {
  if (token.starts_with('+')) token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || token.empty()) return std::nullopt;
  // Too small for a double is zero enough; too large is no number a mesh can hold.
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = token.find_first_of("eE");
    const bool is_small = exponent != token.npos && token.substr(exponent + 1).starts_with('-');
    return is_small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

Mesh readMesh(const std::filesystem::path& path) {
  const std::optional<Format> format = formatOf(path);
  if (!format) {
    throw InputError(fmt::format("{}: extension '{}', expected .ply or .obj", path.string(),
                                 path.extension().string()));
  }
  const std::string content = readFile(path);
  try {
    if (content.empty()) throw InputError("the file is empty, expected a mesh");
    Mesh mesh = *format == Format::kPly ? parsePly(content) : parseObj(content);
    check(mesh);
    return mesh;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh) {
  const std::optional<Format> format = formatOf(path);
  if (!format) {
    throw OutputError(fmt::format("{}: extension '{}', expected .ply or .obj", path.string(),
                                  path.extension().string()));
  }
  writeFileAtomic(path, *format == Format::kPly ? formatPly(mesh) : formatObj(mesh));
}

}  // namespace hydrabench
