// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "eval/simulation/campus_labels.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Pattern = Material::Pattern;

constexpr double kSpacing_m = 0.6;   // of lines where the ground is smooth
constexpr double kSame_m = 1e-6;     // lines as near as this are one
constexpr int kBendSteps = 45;       // per quarter circle: 2 mm off the circle at the kerbs
constexpr double kMarking_m = 0.06;  // half the width of a line on the road
constexpr double kDash_m = 2.4;      // of the middle line, and as much between two
constexpr double kBayDepth_m = 2.2;  // of the parking bays along the kerbs
constexpr std::uint16_t kPaint = 1;  // material of the road's part

/// Ascending lines from low to high: the creases between them, and more at most kSpacing_m apart.
std::vector<double> gridLines(double low, double high, std::vector<double> creases) {
  std::vector<double> fixed = {low, high};
  for (const double crease : creases) {
    if (crease > low && crease < high) fixed.push_back(crease);
  }
  std::sort(fixed.begin(), fixed.end());
  std::vector<double> lines = {fixed.front()};
  for (std::size_t i = 1; i < fixed.size(); ++i) {
    const double width = fixed[i] - fixed[i - 1];
    if (width < kSame_m) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(width / kSpacing_m)));
    for (int k = 1; k < parts; ++k) lines.push_back(fixed[i - 1] + width * k / parts);
    lines.push_back(fixed[i]);
  }
  return lines;
}

/// Triangles of the ground, sorted into parts by class; vertices are shared within a part.
class GroundMesh {
 public:
  explicit GroundMesh(const CampusTerrain& terrain) : terrain_(terrain) {}

  /// A cell with corners counter-clockwise seen from above, cut along the diagonal that is nearer
  /// to the ground.
  void add(const std::array<Vector2d, 4>& corners) {
    const Vector2d middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    const double height = terrain_.heightAt(middle);
    const auto error = [&](int a, int b) {
      const double mean = 0.5 * (terrain_.heightAt(corners[static_cast<std::size_t>(a)]) +
                                 terrain_.heightAt(corners[static_cast<std::size_t>(b)]));
      return std::abs(mean - height);
    };
    const bool first = error(0, 2) <= error(1, 3) + 1e-12;
    Part& part = parts_[terrain_.labelAt(middle)];
    const std::uint16_t material = isPainted(middle) ? kPaint : 0;
    if (first) {
      addFace(corners[0], corners[1], corners[2], material, part);
      addFace(corners[0], corners[2], corners[3], material, part);
    } else {
      addFace(corners[0], corners[1], corners[3], material, part);
      addFace(corners[1], corners[2], corners[3], material, part);
    }
  }

  Mesh takeMesh(Label label) { return std::move(parts_[label].mesh); }
  std::vector<std::uint16_t> takeMaterials(Label label) {
    return std::move(parts_[label].face_material);
  }

 private:
  struct Part {
    Mesh mesh;
    std::vector<std::uint16_t> face_material;
    std::map<std::pair<std::int64_t, std::int64_t>, int> vertices;
  };

  bool isPainted(const Vector2d& place) const {
    const double offset = terrain_.loop().offsetOf(place);
    const double bay = CampusTerrain::kRoadHalfWidth_m - kBayDepth_m;
    if (std::abs(std::abs(offset) - bay) < kMarking_m) return true;
    if (std::abs(offset) > kMarking_m) return false;
    const bool along_x = std::abs(place.x()) < terrain_.loop().half_x_m;
    return std::fmod((along_x ? place.x() : place.y()) + 100 * kDash_m, 2 * kDash_m) < kDash_m;
  }

  int vertex(const Vector2d& place, Part& part) const {
    const auto key =
        std::pair(std::llround(place.x() / kSame_m), std::llround(place.y() / kSame_m));
    const auto [at, added] = part.vertices.emplace(key, part.mesh.vertices.size());
    if (added) part.mesh.vertices.emplace_back(place.x(), place.y(), terrain_.heightAt(place));
    return at->second;
  }

  void addFace(const Vector2d& a, const Vector2d& b, const Vector2d& c, std::uint16_t material,
               Part& part) const {
    const Eigen::Vector3i face(vertex(a, part), vertex(b, part), vertex(c, part));
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return;
    part.mesh.faces.push_back(face);
    part.face_material.push_back(material);
  }

  const CampusTerrain& terrain_;
  std::map<Label, Part> parts_;
};

/// A line across the road: from the edge of the inner rectangle outwards.
struct Spoke {
  Vector2d foot;
  Vector2d out;
};

/// All around, counter-clockwise.
std::vector<Spoke> spokesAround(const CampusLoop& loop, const std::vector<double>& xs,
                                const std::vector<double>& ys) {
  std::vector<Spoke> spokes;
  const auto bend = [&](const Vector2d& corner, double from) {
    for (int i = 1; i < kBendSteps; ++i) {
      const double angle = from + 0.5 * std::numbers::pi * i / kBendSteps;
      spokes.push_back({corner, {std::cos(angle), std::sin(angle)}});
    }
  };
  const double a = loop.half_x_m;
  const double b = loop.half_y_m;
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  for (const double x : xs) spokes.push_back({{x, -b}, {0, -1}});
  bend({a, -b}, -kQuarter);
  for (const double y : ys) spokes.push_back({{a, y}, {1, 0}});
  bend({a, b}, 0);
  for (auto x = xs.rbegin(); x != xs.rend(); ++x) spokes.push_back({{*x, b}, {0, 1}});
  bend({-a, b}, kQuarter);
  for (auto y = ys.rbegin(); y != ys.rend(); ++y) spokes.push_back({{-a, *y}, {-1, 0}});
  bend({-a, -b}, 2 * kQuarter);
  return spokes;
}

/// Offsets of lines along the road: kerbs, borders of the pavements, markings.
std::vector<double> offsetsAcross(const CampusLoop& loop) {
  const double kerb = CampusTerrain::kRoadHalfWidth_m;
  const double bay = kerb - kBayDepth_m;
  std::vector<double> creases = {-kMarking_m, kMarking_m};
  for (const double side : {-1.0, 1.0}) {
    for (const double at :
         {bay - kMarking_m, bay + kMarking_m, kerb, kerb + CampusTerrain::kKerbRamp_m,
          kerb + CampusTerrain::kPavementWidth_m}) {
      creases.push_back(side * at);
    }
  }
  return gridLines(-loop.radius_m, CampusTerrain::kEdge_m, creases);
}

Material materialOf(Label label) {
  namespace id = campus_label;
  switch (label) {
    case id::kRoad:
      return {{92, 92, 96}, {74, 74, 79}, Pattern::kNoise, 0.06};
    case id::kSidewalk:
      return {{172, 168, 160}, {140, 137, 131}, Pattern::kTiles, 0.4};
    case id::kStairs:
      return {{184, 178, 168}, {164, 158, 149}, Pattern::kNoise, 0.08};
    case id::kWall:
      return {{150, 134, 118}, {112, 100, 90}, Pattern::kTiles, 0.3};
    default:
      return {{92, 132, 62}, {66, 102, 46}, Pattern::kLeaves, 0.35};
  }
}

}  // namespace

void buildCampusGround(const CampusTerrain& terrain, Scene& scene) {
  const CampusLoop& loop = terrain.loop();
  const std::vector<double> xs = gridLines(-loop.half_x_m, loop.half_x_m, terrain.creasesAlongX());
  const std::vector<double> ys = gridLines(-loop.half_y_m, loop.half_y_m, terrain.creasesAlongY());
  GroundMesh ground(terrain);
  for (std::size_t i = 1; i < xs.size(); ++i) {
    for (std::size_t j = 1; j < ys.size(); ++j) {
      ground.add({Vector2d(xs[i - 1], ys[j - 1]), Vector2d(xs[i], ys[j - 1]),
                  Vector2d(xs[i], ys[j]), Vector2d(xs[i - 1], ys[j])});
    }
  }
  const std::vector<Spoke> spokes = spokesAround(loop, xs, ys);
  const std::vector<double> offsets = offsetsAcross(loop);
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& from = spokes[i];
    const Spoke& to = spokes[(i + 1) % spokes.size()];
    for (std::size_t k = 1; k < offsets.size(); ++k) {
      const double inner = loop.radius_m + offsets[k - 1];
      const double outer = loop.radius_m + offsets[k];
      ground.add({from.foot + inner * from.out, from.foot + outer * from.out,
                  to.foot + outer * to.out, to.foot + inner * to.out});
    }
  }
  for (const LabelSpace::Entry& entry : scene.label_space.entries) {
    StructurePart part{"ground_" + entry.name, entry.label, {}, false, false};
    part.surface.mesh = ground.takeMesh(entry.label);
    if (part.surface.mesh.empty()) continue;
    part.surface.face_material = ground.takeMaterials(entry.label);
    part.surface.materials = {materialOf(entry.label), {{222, 222, 216}, {222, 222, 216}}};
    scene.structure.push_back(std::move(part));
  }
}

}  // namespace hydrabench
