// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/packed_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hydrabench {
namespace {

constexpr double kSteps = 65535;

template <typename Number>
void appendPlanes(const std::vector<Number>& numbers, std::string& out) {
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
    for (const Number number : numbers) out += static_cast<char>(number >> (8 * byte) & 0xFF);
  }
}

template <typename Number>
std::vector<Number> readPlanes(const std::string& bytes, std::size_t& at, std::size_t count) {
  std::vector<Number> numbers(count, 0);
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
    for (Number& number : numbers) {
      number = static_cast<Number>(
          number | static_cast<Number>(static_cast<std::uint8_t>(bytes[at++])) << (8 * byte));
    }
  }
  return numbers;
}

template <typename Number>
std::vector<Number> differences(std::vector<Number> numbers) {
  for (std::size_t i = numbers.size(); i-- > 1;) {
    numbers[i] = static_cast<Number>(numbers[i] - numbers[i - 1]);
  }
  return numbers;
}

template <typename Number>
std::vector<Number> sums(std::vector<Number> numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    numbers[i] = static_cast<Number>(numbers[i] + numbers[i - 1]);
  }
  return numbers;
}

/// Vertices in the order of their first use.
Mesh ordered(const Mesh& mesh) {
  constexpr int kUnused = -1;
  std::vector<int> place(mesh.vertices.size(), kUnused);
  Mesh result;
  result.faces = mesh.faces;
  for (Eigen::Vector3i& face : result.faces) {
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(face[k]);
      if (place[from] == kUnused) {
        place[from] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[from]);
        if (!mesh.colors.empty()) result.colors.push_back(mesh.colors[from]);
      }
      face[k] = place[from];
    }
  }
  return result;
}

template <typename Number>
void appendFaces(const std::vector<Eigen::Vector3i>& faces, std::string& out) {
  std::vector<Number> codes;
  int met = 0;
  for (const Eigen::Vector3i& face : faces) {
    for (int k = 0; k < 3; ++k) {
      codes.push_back(static_cast<Number>(met - face[k]));
      if (face[k] == met) ++met;
    }
  }
  appendPlanes(codes, out);
}

template <typename Number>
void readFaces(const std::string& bytes, std::size_t& at, std::vector<Eigen::Vector3i>& faces) {
  const auto codes = readPlanes<Number>(bytes, at, 3 * faces.size());
  int met = 0;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    faces[i / 3][static_cast<int>(i % 3)] = met - static_cast<int>(codes[i]);
    if (codes[i] == 0) ++met;
  }
}

}  // namespace

PackedMesh packMesh(const Mesh& mesh) {
  const Mesh source = ordered(mesh);
  PackedMesh packed;
  packed.vertices = source.vertices.size();
  packed.faces = source.faces.size();
  if (packed.vertices == 0) return packed;
  const Aabb box = bounds(source);
  packed.low = box.min();
  packed.size = box.sizes();
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = std::max(packed.size[axis], std::numeric_limits<double>::min());
    std::vector<std::uint16_t> numbers;
    for (const Eigen::Vector3d& vertex : source.vertices) {
      numbers.push_back(static_cast<std::uint16_t>(
          std::lround((vertex[axis] - packed.low[axis]) / extent * kSteps)));
    }
    appendPlanes(differences(std::move(numbers)), packed.bytes);
  }
  packed.has_colors = !source.colors.empty();
  for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
    if (!packed.has_colors) break;
    std::vector<std::uint8_t> numbers;
    for (const Rgb& color : source.colors) numbers.push_back(color.*channel);
    appendPlanes(differences(std::move(numbers)), packed.bytes);
  }
  packed.wide = packed.vertices > std::numeric_limits<std::uint16_t>::max();
  if (packed.wide) {
    appendFaces<std::uint32_t>(source.faces, packed.bytes);
  } else {
    appendFaces<std::uint16_t>(source.faces, packed.bytes);
  }
  return packed;
}

Mesh unpackMesh(const PackedMesh& packed) {
  Mesh mesh;
  std::size_t at = 0;
  mesh.vertices.resize(packed.vertices);
  for (int axis = 0; axis < 3; ++axis) {
    const auto numbers = sums(readPlanes<std::uint16_t>(packed.bytes, at, packed.vertices));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      mesh.vertices[i][axis] = packed.low[axis] + numbers[i] / kSteps * packed.size[axis];
    }
  }
  if (packed.has_colors) mesh.colors.resize(packed.vertices);
  for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
    if (!packed.has_colors) break;
    const auto numbers = sums(readPlanes<std::uint8_t>(packed.bytes, at, packed.vertices));
    for (std::size_t i = 0; i < numbers.size(); ++i) mesh.colors[i].*channel = numbers[i];
  }
  mesh.faces.resize(packed.faces);
  if (packed.wide) {
    readFaces<std::uint32_t>(packed.bytes, at, mesh.faces);
  } else {
    readFaces<std::uint16_t>(packed.bytes, at, mesh.faces);
  }
  return mesh;
}

}  // namespace hydrabench
