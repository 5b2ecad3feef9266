// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_buildings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "eval/simulation/campus_labels.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Pattern = Material::Pattern;

constexpr double kStorey_m = 3.1;
constexpr double kSill_m = 0.95;
constexpr double kWindow_m = 1.45;  // height
enum Skin : std::uint16_t { kWall, kFrame, kGlass, kDoor, kRoof, kPlinth };

struct House {
  Rect outline;
  double ground = 0;  ///< of the highest corner [m]
  double foot = 0;    ///< of the walls, below the ground everywhere
  int storeys = 2;
  double top() const { return ground + 0.3 + kStorey_m * storeys; }
};

/// One side of a house: boxes on it are given along it from its middle, up, and by how far they
/// stand out.
struct Side {
  Vector2d middle;
  Vector2d out;
  double length = 0;

  Aabb box(double low, double high, double z_low, double z_high, double depth) const {
    const Vector2d along(-out.y(), out.x());
    Aabb box;
    for (const double at : {low, high}) {
      for (const double reach : {-0.05, depth}) {
        const Vector2d p = middle + at * along + reach * out;
        box.extend(Vector3d(p.x(), p.y(), z_low));
        box.extend(Vector3d(p.x(), p.y(), z_high));
      }
    }
    return box;
  }
};

std::array<Side, 4> sidesOf(const Rect& outline) {
  const Vector2d c = outline.center();
  const Vector2d half = 0.5 * outline.sizes();
  return {{{c + Vector2d(half.x(), 0), {1, 0}, 2 * half.y()},
           {c - Vector2d(half.x(), 0), {-1, 0}, 2 * half.y()},
           {c + Vector2d(0, half.y()), {0, 1}, 2 * half.x()},
           {c - Vector2d(0, half.y()), {0, -1}, 2 * half.x()}}};
}

void addWindow(const Side& side, double at, double width, double sill, Surface& surface) {
  const double half = 0.5 * width;
  appendBox(side.box(at - half, at + half, sill, sill + kWindow_m, 0.01), kGlass, surface);
  constexpr double kBar = 0.06;
  const double top = sill + kWindow_m;
  appendBox(side.box(at - half - kBar, at + half + kBar, sill - kBar, sill, 0.05), kFrame, surface);
  appendBox(side.box(at - half - kBar, at + half + kBar, top, top + kBar, 0.03), kFrame, surface);
  for (const double x : {-half - kBar, -0.5 * kBar, half}) {
    appendBox(side.box(at + x, at + x + kBar, sill, top, 0.03), kFrame, surface);
  }
}

void addDoor(const Side& side, double at, double sill, Surface& surface) {
  appendBox(side.box(at - 0.75, at + 0.75, sill, sill + 2.3, 0.03), kFrame, surface);
  appendBox(side.box(at - 0.65, at + 0.65, sill, sill + 2.2, 0.05), kDoor, surface);
  appendBox(side.box(at - 1.0, at + 1.0, sill - 0.8, sill, 0.6), kPlinth, surface);
}

void addSide(const House& house, const Side& side, bool front, double spacing, Surface& surface) {
  const int columns = std::max(1, static_cast<int>((side.length - 1.2) / spacing));
  for (int storey = 0; storey < house.storeys; ++storey) {
    const double floor = house.ground + 0.3 + storey * kStorey_m;
    for (int i = 0; i < columns; ++i) {
      const double at = (i - 0.5 * (columns - 1)) * spacing;
      if (front && storey == 0 && i == columns / 2) {
        addDoor(side, at, floor, surface);
      } else {
        addWindow(side, at, 0.45 * spacing, floor + kSill_m, surface);
      }
    }
  }
}

void addGable(const House& house, bool along_x, double rise, Surface& surface) {
  constexpr double kOverhang = 0.45;
  const Vector2d low = house.outline.min() - Vector2d::Constant(kOverhang);
  const Vector2d high = house.outline.max() + Vector2d::Constant(kOverhang);
  const double z = house.top();
  const Vector2d c = house.outline.center();
  const auto ridge = [&](bool end) {
    return along_x ? Vector3d(end ? high.x() : low.x(), c.y(), z + rise)
                   : Vector3d(c.x(), end ? high.y() : low.y(), z + rise);
  };
  const int first = static_cast<int>(surface.mesh.vertices.size());
  const std::array<Vector3d, 6> corners = {Vector3d(low.x(), low.y(), z),
                                           Vector3d(high.x(), low.y(), z),
                                           Vector3d(high.x(), high.y(), z),
                                           Vector3d(low.x(), high.y(), z),
                                           ridge(false),
                                           ridge(true)};
  surface.mesh.vertices.insert(surface.mesh.vertices.end(), corners.begin(), corners.end());
  // Slopes, ends, underside.
  std::vector<Eigen::Vector3i> faces = {{0, 2, 1}, {0, 3, 2}};
  if (along_x) {
    faces.insert(faces.end(), {{0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}, {1, 2, 5}, {3, 0, 4}});
  } else {
    faces.insert(faces.end(), {{1, 2, 5}, {1, 5, 4}, {3, 0, 4}, {3, 4, 5}, {0, 1, 4}, {2, 3, 5}});
  }
  for (const Eigen::Vector3i& face : faces) {
    surface.mesh.faces.push_back(face + Eigen::Vector3i::Constant(first));
    surface.face_material.push_back(kRoof);
  }
}

Surface makeHouse(const House& house, const Vector2d& front, Random& random) {
  static const std::array<Material, 4> kWalls = {
      {{{196, 172, 140}, {182, 158, 128}, Pattern::kNoise, 0.4},
       {{158, 92, 72}, {128, 74, 60}, Pattern::kTiles, 0.24},
       {{206, 202, 192}, {190, 186, 178}, Pattern::kNoise, 0.5},
       {{142, 150, 156}, {124, 132, 138}, Pattern::kTiles, 0.9}}};
  Surface surface;
  surface.materials = {kWalls[random.index(4)],
                       {{226, 226, 220}, {226, 226, 220}},
                       {{58, 78, 96}, {58, 78, 96}, Pattern::kPlain, 1, 0.8},
                       {{92, 62, 44}, {72, 48, 34}, Pattern::kWood, 0.2},
                       {{112, 68, 58}, {88, 54, 48}, Pattern::kTiles, 0.35},
                       {{128, 126, 122}, {112, 110, 106}, Pattern::kNoise, 0.2}};
  const Rect& r = house.outline;
  appendBox({Vector3d(r.min().x(), r.min().y(), house.foot),
             Vector3d(r.max().x(), r.max().y(), house.top())},
            kWall, surface, kAllFaces & ~unsigned{kFaceZLow});
  const double spacing = random.uniform(2.1, 2.9);
  for (const Side& side : sidesOf(r)) {
    addSide(house, side, side.out.dot(front) > 0.5, spacing, surface);
  }
  const bool along_x = r.sizes().x() > r.sizes().y();
  if (random.chance(0.6)) {
    addGable(house, along_x, random.uniform(0.28, 0.42) * r.sizes().minCoeff(), surface);
  } else {
    appendBox({Vector3d(r.min().x() - 0.25, r.min().y() - 0.25, house.top()),
               Vector3d(r.max().x() + 0.25, r.max().y() + 0.25, house.top() + 0.35)},
              kPlinth, surface);
  }
  return surface;
}

}  // namespace

void buildCampusBuildings(const CampusTerrain& terrain, Random random, Scene& scene) {
  const CampusLoop& loop = terrain.loop();
  int number = 0;
  for (int side = 0; side < 4; ++side) {
    const bool along_x = side % 2 == 0;
    const Vector2d out =
        along_x ? Vector2d(0, side == 0 ? -1 : 1) : Vector2d(side == 1 ? 1 : -1, 0);
    const Vector2d along(-out.y(), out.x());
    const double half = along_x ? loop.half_x_m + 4 : loop.half_y_m + 2;
    const double middle_line = (along_x ? loop.half_y_m : loop.half_x_m) + loop.radius_m;
    double at = -half + random.uniform(0, 3);
    for (;;) {
      const double length = random.uniform(10, 17);
      if (at + length > half + 2) break;
      const double front = middle_line + kNearestFront_m + random.uniform(0, 2.5);
      const double depth = random.uniform(7.5, 10);
      House house;
      house.outline.extend(at * along + front * out);
      house.outline.extend((at + length) * along + (front + depth) * out);
      house.ground = -1e9;
      house.foot = 1e9;
      for (int corner = 0; corner < 4; ++corner) {
        const double height =
            terrain.heightAt(house.outline.corner(static_cast<Rect::CornerType>(corner)));
        house.ground = std::max(house.ground, height);
        house.foot = std::min(house.foot, height - 0.5);
      }
      house.storeys = 1 + static_cast<int>(random.index(3));
      StructurePart part{
          fmt::format("building_{:02d}", ++number), campus_label::kBuilding, {}, false, false};
      part.surface = makeHouse(house, -out, random);
      scene.structure.push_back(std::move(part));
      at += length + random.uniform(3, 10);
    }
  }
}

}  // namespace hydrabench
