// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "core/geometry/mesh_format.h"
#include "core/types/error.h"

// Wavefront OBJ: "v x y z" with an optional "r g b" in [0, 1] (as MeshLab and Open3D write it) and
// "f". Texture coordinates, normals, groups and materials are read over.
namespace hydrabench {
namespace {

/// Takes the next word; empty at the end.
std::string_view takeWord(std::string_view& line) {
  constexpr std::string_view kSpace = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpace));
  line.remove_prefix(word.size());
  return word;
}

void addVertex(std::string_view line, Mesh& mesh) {
  std::array<double, 6> values = {};
  std::size_t count = 0;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    const std::optional<double> value = parseNumber(word);
    if (!value) throw InputError(fmt::format("has '{}', expected a number", word.substr(0, 40)));
    if (count == values.size())
      throw InputError("has more than 6 numbers, expected x y z or x y z r g b");
    values[count++] = *value;
  }
  if (count < 3) throw InputError(fmt::format("has {} coordinates, expected 3", count));
  mesh.vertices.emplace_back(values[0], values[1], values[2]);
  if (count < 6) return;
  const auto channel = [&](std::size_t i) {
    const double value = std::isfinite(values[i]) ? std::clamp(values[i], 0.0, 1.0) : 0.0;
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  mesh.colors.push_back({channel(3), channel(4), channel(5)});
}

/// A corner is "v", "v/vt", "v//vn" or "v/vt/vn"; v counts from 1, or backwards from the last
/// vertex where negative.
void addFace(std::string_view line, Mesh& mesh) {
  std::vector<int> corners;
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const std::int64_t index =
        number > 0 ? number - 1 : static_cast<std::int64_t>(mesh.vertices.size()) + number;
    if (error != std::errc() || end != digits.data() + digits.size() || number == 0 || index < 0 ||
        index > std::numeric_limits<int>::max()) {
      throw InputError(fmt::format("refers to vertex '{}', expected 1 to {} or -{} to -1",
                                   word.substr(0, 40), mesh.vertices.size(), mesh.vertices.size()));
    }
    corners.push_back(static_cast<int>(index));
  }
  if (corners.size() < 3) {
    throw InputError(fmt::format("has {} corners, expected 3 or more", corners.size()));
  }
  addPolygon(corners, mesh);
}

bool isKnown(std::string_view keyword) {
  constexpr std::array<std::string_view, 13> kKnown = {
      "vt", "vn", "vp", "l", "p", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "cstype"};
  return std::find(kKnown.begin(), kKnown.end(), keyword) != kKnown.end();
}

}  // namespace

Mesh parseObj(std::string_view content) {
  Mesh mesh;
  std::size_t line_number = 0;
  std::size_t unknown_line = 0;
  while (!content.empty()) {
    std::string_view line = content.substr(0, content.find('\n'));
    content.remove_prefix(std::min(line.size() + 1, content.size()));
    ++line_number;
    const std::string_view keyword = takeWord(line);
    try {
      if (keyword == "v")
        addVertex(line, mesh);
      else if (keyword == "f")
        addFace(line, mesh);
      else if (!keyword.empty() && !keyword.starts_with('#') && !isKnown(keyword) &&
               !unknown_line) {
        unknown_line = line_number;
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("line {}: {} {}", line_number,
                                   keyword == "v" ? "vertex" : "face", error.what()));
    }
  }
  if (mesh.vertices.empty() && unknown_line > 0) {
    throw InputError(fmt::format("line {}: not OBJ, and the file has no vertex", unknown_line));
  }
  // Colours are all or none: what a file gives to some vertices only cannot be kept.
  if (mesh.colors.size() != mesh.vertices.size()) mesh.colors.clear();
  return mesh;
}

std::string formatObj(const Mesh& mesh) {
  const bool has_colors = !mesh.colors.empty() && mesh.colors.size() == mesh.vertices.size();
  Mesh rounded;
  rounded.vertices = mesh.vertices;
  roundToFloat(rounded);
  std::string out =
      fmt::format("# {} vertices, {} faces\n", mesh.vertices.size(), mesh.faces.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    // The float as the double it is, in its shortest text: read back as a double it is the same
    // number.
    const Eigen::Vector3d& v = rounded.vertices[i];
    fmt::format_to(std::back_inserter(out), "v {} {} {}", v.x(), v.y(), v.z());
    if (has_colors) {
      const Rgb& c = mesh.colors[i];
      fmt::format_to(std::back_inserter(out), " {:.4f} {:.4f} {:.4f}", c.r / 255.0, c.g / 255.0,
                     c.b / 255.0);
    }
    out += '\n';
  }
  for (const Eigen::Vector3i& face : mesh.faces) {
    fmt::format_to(std::back_inserter(out), "f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
  }
  return out;
}

}  // namespace hydrabench
