// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/office_structure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/simulation/office_labels.h"

namespace hydrabench {
namespace {

using Pattern = Material::Pattern;
using Opening = FloorPlan::Opening;
using Wall = FloorPlan::Wall;

constexpr double kSillHeight_m = 0.95;
constexpr double kWindowTop_m = 2.25;
constexpr double kLeafThickness_m = 0.04;

/// Box given along, across and up a wall.
Aabb wallBox(const Wall& wall, double low, double high, double across_low, double across_high,
             double z_low, double z_high) {
  const Eigen::Vector3d a(low, wall.at + across_low, z_low);
  const Eigen::Vector3d b(high, wall.at + across_high, z_high);
  if (wall.along_x) return {a, b};
  return {Eigen::Vector3d(a.y(), a.x(), a.z()), Eigen::Vector3d(b.y(), b.x(), b.z())};
}

/// Along-wall and across-wall faces in world terms.
unsigned wallFaces(const Wall& wall, bool ends, bool sides, bool bottom, bool top) {
  const unsigned x = kFaceXLow | kFaceXHigh;
  const unsigned y = kFaceYLow | kFaceYHigh;
  unsigned faces = 0;
  if (ends) faces |= wall.along_x ? x : y;
  if (sides) faces |= wall.along_x ? y : x;
  if (bottom) faces |= kFaceZLow;
  if (top) faces |= kFaceZHigh;
  return faces;
}

void addWall(const Wall& wall, double height, StructurePart& part) {
  const double half = wall.thickness / 2;
  double from = wall.low;
  for (std::size_t i = 0; i <= wall.openings.size(); ++i) {
    const bool last = i == wall.openings.size();
    const double to = last ? wall.high : wall.openings[i].low;
    appendBox(wallBox(wall, from, to, -half, half, 0, height), 0, part.surface,
              wallFaces(wall, true, true, false, false));
    if (last) break;
    const Opening& opening = wall.openings[i];
    const double top = opening.window ? kWindowTop_m : kDoorHeight_m;
    appendBox(wallBox(wall, opening.low, opening.high, -half, half, top, height), 0, part.surface,
              wallFaces(wall, false, true, true, false));
    if (opening.window) {
      appendBox(wallBox(wall, opening.low, opening.high, -half, half, 0, kSillHeight_m), 0,
                part.surface, wallFaces(wall, false, true, false, true));
    }
    from = opening.high;
  }
  // Skirting along both faces, interrupted by doors.
  constexpr double kDepth = 0.012;
  constexpr double kHeight = 0.08;
  from = wall.low;
  for (std::size_t i = 0; i <= wall.openings.size(); ++i) {
    if (i < wall.openings.size() && wall.openings[i].window) continue;
    const double to = i == wall.openings.size() ? wall.high : wall.openings[i].low;
    for (const double side : {-1.0, 1.0}) {
      const double face = side * half;
      const double front = side * (half + kDepth);
      appendBox(wallBox(wall, from, to, std::min(face, front), std::max(face, front), 0, kHeight),
                1, part.surface);
    }
    if (i < wall.openings.size()) from = wall.openings[i].high;
  }
}

Aabb leafBox(const Wall& wall, const Opening& opening) {
  const double width = opening.high - opening.low - 0.04;
  const double half = wall.thickness / 2;
  const double low = opening.hinge_high ? opening.high - kLeafThickness_m : opening.low;
  const double across = opening.leaf_up ? half + 0.02 : -half - 0.02 - width;
  return wallBox(wall, low, low + kLeafThickness_m, across, across + width, 0.008,
                 kDoorHeight_m - 0.03);
}

void addDoor(const Wall& wall, const Opening& opening, StructurePart& part) {
  constexpr double kFrame = 0.05;
  const double reach = wall.thickness / 2 + 0.015;
  // The frame lines the opening from outside its clear width, so that the passage keeps it.
  appendBox(wallBox(wall, opening.low - kFrame, opening.low, -reach, reach, 0, kDoorHeight_m), 1,
            part.surface);
  appendBox(wallBox(wall, opening.high, opening.high + kFrame, -reach, reach, 0, kDoorHeight_m), 1,
            part.surface);
  appendBox(wallBox(wall, opening.low - kFrame, opening.high + kFrame, -reach, reach, kDoorHeight_m,
                    kDoorHeight_m + kFrame),
            1, part.surface);
  if (!opening.leaf) return;
  const Aabb leaf = leafBox(wall, opening);
  appendBox(leaf, 0, part.surface);
  // Handles on both sides near the free edge.
  const double across = opening.leaf_up ? leaf.max()[wall.along_x ? 1 : 0] - 0.08
                                        : leaf.min()[wall.along_x ? 1 : 0] + 0.08;
  Wall handle = wall;
  handle.at = across;
  const double low = leaf.min()[wall.along_x ? 0 : 1];
  appendBox(wallBox(handle, low - 0.045, low + kLeafThickness_m + 0.045, -0.012, 0.012, 1.0, 1.024),
            2, part.surface);
}

void addWindow(const Wall& wall, const Opening& opening, StructurePart& frame,
               StructurePart& pane) {
  constexpr double kBar = 0.05;
  const double middle = 0.5 * (opening.low + opening.high);
  const auto bar = [&](double low, double high, double z_low, double z_high) {
    appendBox(wallBox(wall, low, high, -0.03, 0.03, z_low, z_high), 0, frame.surface);
  };
  bar(opening.low, opening.high, kSillHeight_m, kSillHeight_m + kBar);
  bar(opening.low, opening.high, kWindowTop_m - kBar, kWindowTop_m);
  for (const double at : {opening.low, middle - kBar / 2, opening.high - kBar}) {
    bar(at, at + kBar, kSillHeight_m + kBar, kWindowTop_m - kBar);
  }
  appendBox(wallBox(wall, opening.low, opening.high, -0.005, 0.005, kSillHeight_m, kWindowTop_m), 0,
            pane.surface, wallFaces(wall, false, true, false, false));
}

Material floorMaterial(RoomKind kind, Random& random) {
  switch (kind) {
    case RoomKind::kCorridor:
      return {{132, 134, 138}, {118, 121, 126}, Pattern::kTiles, 0.5};
    case RoomKind::kLounge:
      return {{201, 196, 186}, {176, 170, 160}, Pattern::kTiles, 0.45};
    case RoomKind::kCopy:
      return {{178, 182, 184}, {158, 163, 166}, Pattern::kTiles, 0.4};
    case RoomKind::kMeeting:
      return {{158, 116, 78}, {128, 92, 60}, Pattern::kWood, 0.09};
    case RoomKind::kLobby:
      return {{170, 168, 164}, {148, 146, 143}, Pattern::kTiles, 0.8};
    case RoomKind::kTraining:
      return random.chance(0.5) ? Material{{96, 104, 116}, {82, 90, 101}, Pattern::kFabric, 0.05}
                                : Material{{116, 104, 92}, {101, 90, 80}, Pattern::kFabric, 0.05};
    case RoomKind::kOpenOffice:
      return {{104, 112, 122}, {90, 98, 107}, Pattern::kTiles, 0.6};
    case RoomKind::kPrivateOffice:
      return random.chance(0.5) ? Material{{112, 98, 88}, {98, 86, 77}, Pattern::kFabric, 0.06}
                                : Material{{90, 104, 100}, {78, 91, 88}, Pattern::kFabric, 0.06};
  }
  return {};
}

void addLamps(const FloorPlan& plan, Scene& scene) {
  StructurePart panels{"ceiling_lamps", office_label::kLamp, {}, true, true};
  panels.surface.materials = {{{255, 252, 244}, {255, 252, 244}, Pattern::kPlain, 1}};
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const Rect& inside = plan.rooms[i].inside;
    const Eigen::Vector2d size = inside.sizes();
    const int nx = std::max(1, static_cast<int>(std::lround(size.x() / 3.2)));
    const int ny = std::max(1, static_cast<int>(std::lround(size.y() / 3.0)));
    for (int ix = 0; ix < nx; ++ix) {
      for (int iy = 0; iy < ny; ++iy) {
        const double x = inside.min().x() + size.x() * (ix + 0.5) / nx;
        const double y = inside.min().y() + size.y() * (iy + 0.5) / ny;
        const double z = plan.height_m - 0.02;
        appendBox(
            {Eigen::Vector3d(x - 0.6, y - 0.15, z), Eigen::Vector3d(x + 0.6, y + 0.15, z + 0.02)},
            0, panels.surface, kAllFaces & ~unsigned{kFaceZHigh});
        scene.lamps.push_back({{x, y, z - 0.05}, 4.2, static_cast<int>(i)});
      }
    }
  }
  scene.structure.push_back(std::move(panels));
}

}  // namespace

void buildStructure(const FloorPlan& plan, Random random, Scene& scene) {
  Rect footprint;
  for (const FloorPlan::Room& room : plan.rooms) {
    footprint.extend(room.cell);
    scene.rooms.push_back(
        {room.name,
         Aabb(Eigen::Vector3d(room.inside.min().x(), room.inside.min().y(), 0),
              Eigen::Vector3d(room.inside.max().x(), room.inside.max().y(), plan.height_m))});
    StructurePart floor{"floor_" + room.name, office_label::kFloor, {}, false, false};
    floor.surface.materials = {floorMaterial(room.kind, random)};
    appendBox({Eigen::Vector3d(room.cell.min().x(), room.cell.min().y(), -0.1),
               Eigen::Vector3d(room.cell.max().x(), room.cell.max().y(), 0)},
              0, floor.surface, kFaceZHigh);
    scene.structure.push_back(std::move(floor));
  }

  StructurePart doors{"doors", office_label::kCabinet, {}, false, false};
  doors.surface.materials = {{{176, 132, 88}, {150, 108, 68}, Pattern::kWood, 0.22},
                             {{214, 212, 206}, {214, 212, 206}, Pattern::kPlain, 1},
                             {{150, 152, 156}, {150, 152, 156}, Pattern::kPlain, 1}};
  StructurePart frames{"window_frames", office_label::kWall, {}, false, false};
  frames.surface.materials = {{{236, 237, 238}, {236, 237, 238}, Pattern::kPlain, 1}};
  StructurePart panes{"windows", office_label::kWall, {}, false, true};
  panes.surface.materials = {{{206, 226, 242}, {206, 226, 242}, Pattern::kPlain, 1}};
  StructurePart walls{"walls", office_label::kWall, {}, false, false};
  walls.surface.materials = {{{226, 223, 214}, {219, 216, 207}, Pattern::kNoise, 0.25},
                             {{112, 108, 104}, {112, 108, 104}, Pattern::kPlain, 1}};
  for (const Wall& wall : plan.walls) {
    addWall(wall, plan.height_m, walls);
    for (const Opening& opening : wall.openings) {
      opening.window ? addWindow(wall, opening, frames, panes) : addDoor(wall, opening, doors);
    }
  }
  for (StructurePart* part : {&walls, &doors, &frames, &panes}) {
    scene.structure.push_back(std::move(*part));
  }

  StructurePart ceiling{"ceiling", office_label::kCeiling, {}, true, false};
  ceiling.surface.materials = {{{232, 232, 228}, {214, 214, 210}, Pattern::kTiles, 0.6}};
  appendBox({Eigen::Vector3d(footprint.min().x(), footprint.min().y(), plan.height_m),
             Eigen::Vector3d(footprint.max().x(), footprint.max().y(), plan.height_m + 0.1)},
            0, ceiling.surface, kFaceZLow);
  scene.structure.push_back(std::move(ceiling));
  addLamps(plan, scene);
}

std::vector<Rect> keepOutAreas(const FloorPlan& plan) {
  constexpr double kApproach_m = 1.0;
  constexpr double kSide_m = 0.1;
  std::vector<Rect> areas;
  for (const Wall& wall : plan.walls) {
    for (const Opening& opening : wall.openings) {
      if (opening.window) continue;
      const double reach = wall.thickness / 2 + kApproach_m;
      const Aabb box =
          wallBox(wall, opening.low - kSide_m, opening.high + kSide_m, -reach, reach, 0, 1);
      areas.emplace_back(box.min().head<2>(), box.max().head<2>());
      if (!opening.leaf) continue;
      const Aabb leaf = leafBox(wall, opening);
      areas.emplace_back(leaf.min().head<2>() - Eigen::Vector2d::Constant(0.06),
                         leaf.max().head<2>() + Eigen::Vector2d::Constant(0.06));
    }
  }
  return areas;
}

}  // namespace hydrabench
