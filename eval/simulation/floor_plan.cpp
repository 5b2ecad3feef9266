// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/floor_plan.h"

#include <algorithm>

namespace hydrabench {
namespace {

constexpr double kOuterWall_m = 0.24;
constexpr double kInnerWall_m = 0.12;

struct RoomSpec {
  std::string name;
  RoomKind kind;
  double low, high;  ///< width is drawn from this range [m]
  bool passage;      ///< open doorway without a leaf
};

/// One row of rooms between y_low and y_high, with their doors in the wall towards the corridor and
/// windows in the other.
void addRow(const std::vector<RoomSpec>& specs, double length, double y_low, double y_high,
            bool corridor_above, Random random, FloorPlan& plan, FloorPlan::Wall& corridor_wall,
            FloorPlan::Wall& outer_wall) {
  std::vector<double> widths;
  double sum = 0;
  for (const RoomSpec& spec : specs) {
    widths.push_back(random.uniform(spec.low, spec.high));
    sum += widths.back();
  }
  double x = 0;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const double width = widths[i] * length / sum;
    const double next = i + 1 == specs.size() ? length : x + width;
    const double left = i == 0 ? kOuterWall_m / 2 : kInnerWall_m / 2;
    const double right = i + 1 == specs.size() ? kOuterWall_m / 2 : kInnerWall_m / 2;
    const double below = corridor_above ? kOuterWall_m / 2 : kInnerWall_m / 2;
    const double above = corridor_above ? kInnerWall_m / 2 : kOuterWall_m / 2;
    const Rect cell = makeRect(x, y_low, next, y_high);
    plan.rooms.push_back({specs[i].name, specs[i].kind, cell,
                          makeRect(x + left, y_low + below, next - right, y_high - above)});

    // Doors stand near a corner, so that the leaf rests along the side wall.
    const double door = specs[i].passage ? random.uniform(1.5, 1.8) : random.uniform(0.95, 1.1);
    const bool at_end = random.chance(0.5);
    const double inset = specs[i].passage ? 0.5 * (next - x - door) : 0.25;
    const double start = at_end ? next - right - inset - door : x + left + inset;
    FloorPlan::Opening opening;
    opening.low = start;
    opening.high = start + door;
    opening.leaf = !specs[i].passage;
    opening.leaf_up = !corridor_above;
    opening.hinge_high = at_end;
    corridor_wall.openings.push_back(opening);

    const int windows = std::max(1, static_cast<int>((next - x) / 2.6));
    const double pitch = (next - right - x - left) / windows;
    for (int k = 0; k < windows; ++k) {
      const double middle = x + left + (k + 0.5) * pitch;
      const double half = std::min(0.85, 0.5 * pitch - 0.25);
      FloorPlan::Opening window;
      window.low = middle - half;
      window.high = middle + half;
      window.window = true;
      outer_wall.openings.push_back(window);
    }
    if (i + 1 < specs.size()) {
      plan.walls.push_back({false, next, y_low, y_high, kInnerWall_m, {}});
    }
    x = next;
  }
}

/// [m]
struct Measures {
  double length;
  double south_depth;
  double corridor;
  double north_depth;
};

FloorPlan drawPlan(const std::vector<RoomSpec>& south, const std::vector<RoomSpec>& north,
                   const Measures& measures, Random random) {
  const double length = measures.length;
  FloorPlan plan;
  const double y1 = measures.south_depth;
  const double y2 = y1 + measures.corridor;
  const double y3 = north.empty() ? y2 : y2 + measures.north_depth;
  const double corridor_top = north.empty() ? kOuterWall_m / 2 : kInnerWall_m / 2;
  plan.rooms.push_back({"corridor", RoomKind::kCorridor, makeRect(0, y1, length, y2),
                        makeRect(kOuterWall_m / 2, y1 + kInnerWall_m / 2, length - kOuterWall_m / 2,
                                 y2 - corridor_top)});
  FloorPlan::Wall south_outer{true, 0, 0, length, kOuterWall_m, {}};
  FloorPlan::Wall south_inner{true, y1, 0, length, kInnerWall_m, {}};
  addRow(south, length, 0, y1, true, random.fork(1), plan, south_inner, south_outer);
  plan.walls.push_back(south_outer);
  plan.walls.push_back(south_inner);
  if (north.empty()) {
    plan.walls.push_back({true, y2, 0, length, kOuterWall_m, {}});
  } else {
    FloorPlan::Wall north_inner{true, y2, 0, length, kInnerWall_m, {}};
    FloorPlan::Wall north_outer{true, y3, 0, length, kOuterWall_m, {}};
    addRow(north, length, y2, y3, false, random.fork(2), plan, north_inner, north_outer);
    plan.walls.push_back(north_inner);
    plan.walls.push_back(north_outer);
  }
  plan.walls.push_back({false, 0, 0, y3, kOuterWall_m, {}});
  plan.walls.push_back({false, length, 0, y3, kOuterWall_m, {}});
  return plan;
}

}  // namespace

int FloorPlan::roomAt(const Eigen::Vector2d& point) const {
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i].cell.contains(point)) return static_cast<int>(i);
  }
  return -1;
}

FloorPlan drawOfficePlan(Random random) {
  const std::vector<RoomSpec> south = {{"open_office", RoomKind::kOpenOffice, 10.6, 11.4, true},
                                       {"meeting", RoomKind::kMeeting, 5.4, 6.0, false},
                                       {"lounge", RoomKind::kLounge, 6.0, 6.8, true}};
  std::vector<RoomSpec> north = {{"lobby", RoomKind::kLobby, 5.4, 6.2, true},
                                 {"office_1", RoomKind::kPrivateOffice, 3.9, 4.3, false},
                                 {"office_2", RoomKind::kPrivateOffice, 3.9, 4.3, false},
                                 {"copy_room", RoomKind::kCopy, 3.2, 3.6, false},
                                 {"training", RoomKind::kTraining, 6.2, 6.8, false}};
  // Which room lies where is part of the seed; the lobby stays at the entrance.
  for (std::size_t i = north.size() - 1; i > 1; --i) {
    std::swap(north[i], north[1 + random.index(static_cast<std::uint32_t>(i))]);
  }
  // Braces: the numbers are drawn in this order.
  const Measures measures{random.uniform(24.0, 25.0), random.uniform(6.6, 7.2),
                          random.uniform(2.0, 2.3), random.uniform(4.8, 5.3)};
  return drawPlan(south, north, measures, random.fork(0));
}

FloorPlan drawQuickPlan(Random random) {
  const Measures measures{random.uniform(9.2, 9.6), random.uniform(4.9, 5.2),
                          random.uniform(2.0, 2.2), 0};
  return drawPlan({{"office_1", RoomKind::kPrivateOffice, 4.0, 4.3, false},
                   {"lounge", RoomKind::kLounge, 5.2, 5.6, true}},
                  {}, measures, random.fork(0));
}

}  // namespace hydrabench
