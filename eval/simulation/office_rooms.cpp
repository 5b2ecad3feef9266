// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/office_rooms.h"

#include <cmath>
#include <numbers>

#include "eval/simulation/fitted_furniture.h"
#include "eval/simulation/office_labels.h"

namespace hydrabench {
namespace {

namespace id = office_label;
using Eigen::Vector2d;
using Index = Furnisher::Index;
using Names = std::vector<std::string>;
constexpr double kPi = std::numbers::pi;

// Shape families, by the role they play here.
const std::string kDesk = "desk";
const std::string kRoundTable = "table_round";
const std::string kCoffeeTable = "coffee_table";
const std::string kShelf = "shelf";
const std::string kCabinet = "cabinet";
const Names kDeskChairs = {"office_chair_arms", "office_chair"};
const std::string kTableChair = "table_chair";
const std::string kArmChair = "office_chair_arms";
const Names kCouches = {"couch_1_seat", "couch_2_seats", "couch_3_seats"};
const Names kSmallBins = {"bin_small"};
const Names kLargeBins = {"bin_large"};
const Names kDispensers = {"water_dispenser"};
const Names kFloorPlants = {"plant_large"};
const Names kDeskPlants = {"plant_small"};
const Names kScreens = {"monitor", "monitor", "all_in_one"};

// Of the slots of a class the first are always used, the last only while the quota lasts.
enum Priority : int { kAlways = 0, kUsually = 2, kOften = 4, kSometimes = 6 };

double yawOf(const Vector2d& direction) { return std::atan2(direction.y(), direction.x()); }

/// A desk's sitter, screen, and what stands on it and beside it.
void offerDeskSetup(RoomFitter& room, Index desk, int priority) {
  const Aabb box = room.furnisher()[desk].piece.box;
  const double width = box.sizes().y();
  Random& random = room.random();
  room.offerChair(desk, {box.max().x(), random.uniform(-0.1, 0.1)}, kPi,
                  kDeskChairs[random.index(2)], priority);
  const double side = random.chance(0.5) ? 1 : -1;
  // Screen and keyboard, or a laptop in the middle.
  if (random.chance(0.65)) {
    const double y = -0.08 * side * width;
    room.offerOnTop(desk, "computer", kScreens, {box.min().x() + 0.24, y}, 0, priority);
    room.offerOnTop(desk, "computer", {"keyboard"}, {box.max().x() - 0.2, y}, 0, kOften);
    room.offerBeside(desk, "computer", {"desktop_tower"}, kSometimes);
  } else {
    room.offerOnTop(desk, "computer", {"laptop"}, {0.05, 0.1 * side * width}, 0, priority);
  }
  const int plant_priority = random.chance(0.25) ? kAlways : kSometimes;
  room.offerOnTop(desk, "plant", kDeskPlants, {box.min().x() + 0.2, 0.38 * side * width},
                  random.uniform(0, 6), plant_priority);
  room.offerBeside(desk, "bin", kSmallBins, kOften);
}

/// Two rows of desks back to back with screens between; the middle of the island at `center`, rows
/// along y.
void addIsland(RoomFitter& room, const Vector2d& center, int desks_per_row, double height_m) {
  const Furnisher::Piece desk = room.furnisher().draw(kDesk, id::kDesk);
  constexpr double kScreen_m = 0.045;
  const double pitch = desk.width() + 2 * kScreen_m;
  room.put(room.furnisher().take(fitted::cubicleScreens(desks_per_row, pitch, 0.9 * desk.depth(),
                                                        height_m, room.random().fork(1)),
                                 id::kCubicle),
           center, 0);
  for (const int row : {-1, 1}) {
    for (int i = 0; i < desks_per_row; ++i) {
      const double y = (i - 0.5 * (desks_per_row - 1)) * pitch;
      const double x = row * (kScreen_m - desk.box.min().x());
      const auto index = room.put(desk, center + Vector2d(x, y), row > 0 ? 0 : kPi);
      if (index) offerDeskSetup(room, *index, kAlways);
    }
  }
}

void furnishOpenOffice(RoomFitter& room) {
  const Rect& inside = room.inside();
  const Vector2d size = inside.sizes();
  // Islands keep to the window side; the way in is along the corridor wall.
  const double shift = room.windowSide() == Side::kSouth ? -0.42 : 0.42;
  const double height = room.random().uniform(1.15, 1.35);
  for (const double share : {0.25, 0.64}) {
    addIsland(room, inside.min() + Vector2d(share * size.x(), 0.5 * size.y() + shift), 3, height);
  }
  const double depth = size.y();
  room.putAtWall(kShelf, id::kCabinet, Side::kWest, 0.85 * depth);
  room.putAtWall(kCabinet, id::kCabinet, Side::kEast, 0.75 * depth);
  room.putAtWall(kCabinet, id::kCabinet, Side::kEast, 0.9 * depth);
  room.offerAtWall("couch", kCouches, Side::kEast, 0.35 * depth, kAlways);
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerInCorner("plant", kFloorPlants, kUsually);
  room.offerAlongWalls("bin", kLargeBins, kAlways);
  room.offerAlongWalls("bin", kDispensers, kUsually);
  room.offerAlongWalls("chair", {kTableChair}, kSometimes);
}

void furnishPrivateOffice(RoomFitter& room) {
  const Rect& inside = room.inside();
  const WallFrame window = room.wall(room.windowSide());
  // The sitter has the window behind and sees the door.
  const auto desk = room.put(
      kDesk, id::kDesk, window.origin + 0.5 * window.length * window.along + 1.45 * window.inward,
      yawOf(-window.inward));
  if (desk) {
    offerDeskSetup(room, *desk, kAlways);
    const Aabb box = room.furnisher()[*desk].piece.box;
    for (const double y : {-0.4, 0.4}) {
      room.offerChair(*desk, {box.min().x() - 0.12, y}, 0, kTableChair, y < 0 ? kUsually : kOften);
    }
  }
  const double depth = inside.sizes().y();
  const bool mirrored = room.random().chance(0.5);
  const Side storage = mirrored ? Side::kWest : Side::kEast;
  const Side lounge = mirrored ? Side::kEast : Side::kWest;
  const bool window_south = room.windowSide() == Side::kSouth;
  // Distances along a side wall run from the south on the west side, from the north on the east
  // side.
  const auto fromWindow = [&](Side side, double distance) {
    return (side == Side::kWest) == window_south ? distance : depth - distance;
  };
  room.putAtWall(kShelf, id::kCabinet, storage, fromWindow(storage, 0.9));
  room.putAtWall(kCabinet, id::kCabinet, storage, fromWindow(storage, 2.2));
  room.offerAtWall("couch", {"couch_1_seat", "couch_2_seats"}, lounge,
                   fromWindow(lounge, 0.62 * depth), kAlways);
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerAlongWalls("bin", kSmallBins, kUsually);
}

void furnishMeeting(RoomFitter& room) {
  const Rect& inside = room.inside();
  const bool turned = inside.sizes().x() > inside.sizes().y();
  const double length = std::min(3.6, inside.sizes().maxCoeff() - 3.0);
  const double width = room.random().uniform(1.15, 1.35);
  const auto table =
      room.put(room.furnisher().take(fitted::conferenceTable(length, width, room.random().fork(2)),
                                     id::kDesk),
               inside.center(), turned ? kPi / 2 : 0);
  if (table)
    room.offerChairsAround(*table, static_cast<int>(length / 0.8), 1,
                           room.random().chance(0.5) ? kArmChair : kTableChair, kAlways);
  room.putAtWall(room.furnisher().take(fitted::whiteboard(2.4, 1.2), id::kSign), Side::kWest,
                 0.5 * inside.sizes().y(), 0.9);
  room.putAtWall(kCabinet, id::kCabinet, Side::kEast, 0.5 * inside.sizes().y());
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerInCorner("plant", kFloorPlants, kOften);
  room.offerAlongWalls("bin", kSmallBins, kAlways);
  room.offerAlongWalls("couch", {"couch_2_seats"}, kOften);
}

void furnishTraining(RoomFitter& room) {
  const Rect& inside = room.inside();
  const Vector2d size = inside.sizes();
  const bool board_west = room.random().chance(0.5);
  const double towards = board_west ? -1 : 1;
  const double front = board_west ? inside.min().x() : inside.max().x();
  room.putAtWall(room.furnisher().take(fitted::whiteboard(2.6, 1.2), id::kSign),
                 board_west ? Side::kWest : Side::kEast, 0.5 * size.y(), 0.9);
  const double shift = room.corridorSide() == Side::kNorth ? -0.2 : 0.2;
  for (int row = 0; row < 3; ++row) {
    for (const double side : {-1.0, 1.0}) {
      const Vector2d place(front - towards * (2.2 + 1.45 * row),
                           inside.center().y() + shift + side * 0.24 * size.y());
      const auto table =
          room.put(room.furnisher().take(fitted::conferenceTable(1.6, 0.65, room.random().fork(3)),
                                         id::kDesk),
                   place, board_west ? 0 : kPi);
      if (!table) continue;
      const Aabb box = room.furnisher()[*table].piece.box;
      for (const double y : {-0.38, 0.38})
        room.offerChair(*table, {box.max().x(), y}, kPi, kTableChair, row < 2 ? kUsually : kOften);
    }
  }
  const Side back = board_west ? Side::kEast : Side::kWest;
  room.putAtWall(kShelf, id::kCabinet, back, 0.4 * size.y());
  room.offerInCorner("plant", kFloorPlants, kUsually);
  room.offerAlongWalls("bin", kLargeBins, kAlways);
  room.offerAtWall("couch", {"couch_1_seat", "couch_2_seats"}, back, 0.7 * size.y(), kSometimes);
}

/// Couches around a low table.
void addSittingGroup(RoomFitter& room, Side side, double t) {
  const WallFrame frame = room.wall(side);
  room.put(kCoffeeTable, id::kDesk, frame.origin + t * frame.along + 1.75 * frame.inward,
           frame.yaw());
  room.offerAtWall("couch", {"couch_3_seats"}, side, t, kAlways);
}

void furnishLounge(RoomFitter& room) {
  const Rect& inside = room.inside();
  const Vector2d size = inside.sizes();
  const bool kitchen_east = room.random().chance(0.5);
  const Side kitchen = kitchen_east ? Side::kEast : Side::kWest;
  const Side quiet = kitchen_east ? Side::kWest : Side::kEast;
  const bool window_south = room.windowSide() == Side::kSouth;
  const auto fromWindow = [&](Side side, double distance) {
    return (side == Side::kWest) == window_south ? distance : size.y() - distance;
  };
  room.putAtWall(room.furnisher().take(
                     fitted::kitchenCounter(std::min(2.6, 0.45 * size.y()), room.random().fork(5)),
                     id::kCabinet),
                 kitchen, fromWindow(kitchen, 0.42 * size.y()));
  room.offerAtWall("bin", kLargeBins, kitchen, fromWindow(kitchen, 0.75 * size.y()), kAlways);
  room.offerAtWall("bin", kDispensers, kitchen, fromWindow(kitchen, 0.08 * size.y()), kAlways);

  const double kitchen_x = kitchen_east ? inside.max().x() : inside.min().x();
  const double inward = kitchen_east ? -1 : 1;
  const WallFrame window = room.wall(room.windowSide());
  const double away = window.inward.y();
  const double window_y = window.origin.y();
  const int tables = size.y() > 6 ? 2 : 1;
  for (int i = 0; i < tables; ++i) {
    const Vector2d place(kitchen_x + inward * 2.3, window_y + away * (1.5 + 2.5 * i));
    const auto table = room.put(kRoundTable, id::kDesk, place, room.random().uniform(0, 0.2));
    if (table) room.offerChairsInCircle(*table, 4, kTableChair, kAlways);
  }
  addSittingGroup(room, quiet, fromWindow(quiet, 0.36 * size.y()));
  const double t_window =
      kitchen_east ? window.length - 1.9 : 1.9;  // the quiet end of the window wall
  room.offerAtWall("couch", {"couch_2_seats"}, room.windowSide(),
                   window_south ? t_window : window.length - t_window, kUsually);
  room.offerAtWall("couch", {"couch_1_seat"}, quiet, fromWindow(quiet, 0.72 * size.y()), kAlways);
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerInCorner("plant", kFloorPlants, kUsually);
  room.offerAlongWalls("chair", {kTableChair}, kSometimes);
}

void furnishLobby(RoomFitter& room) {
  const Vector2d size = room.inside().sizes();
  const WallFrame west = room.wall(Side::kWest);
  const double middle = 0.5 * size.y();
  // The clerk sits with the back to the west wall.
  const auto desk =
      room.put(room.furnisher().take(fitted::receptionDesk(1.9, room.random().fork(6)), id::kDesk),
               west.origin + middle * west.along + 1.55 * west.inward, 0);
  if (desk) {
    const Aabb box = room.furnisher()[*desk].piece.box;
    room.offerChair(*desk, {box.min().x(), 0}, 0, kArmChair, kAlways);
    room.offerOnTop(*desk, "computer", kScreens, {0.02, 0.35}, kPi, kAlways);
    room.offerOnTop(*desk, "plant", kDeskPlants, {0.28, -0.7}, 0, kAlways);
  }
  addSittingGroup(room, Side::kEast, middle);
  room.offerAtWall("couch", {"couch_2_seats"}, room.windowSide(),
                   room.windowSide() == Side::kSouth ? 1.6 : size.x() - 1.6, kAlways);
  room.offerAtWall("couch", {"couch_1_seat"}, room.corridorSide(),
                   room.corridorSide() == Side::kSouth ? 0.8 : size.x() - 0.8, kOften);
  for (const double t : {0.35, 0.5})
    room.offerAtWall("chair", {kTableChair}, room.windowSide(), t * size.x(), kUsually);
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerInCorner("plant", kFloorPlants, kAlways);
  room.offerAlongWalls("bin", kDispensers, kUsually);
  room.offerAlongWalls("bin", kLargeBins, kOften);
}

void furnishCopyRoom(RoomFitter& room) {
  const Vector2d size = room.inside().sizes();
  room.putAtWall(room.furnisher().take(fitted::copier(room.random().fork(7)), id::kCabinet),
                 Side::kWest, 0.45 * size.y());
  room.putAtWall(room.furnisher().take(fitted::copier(room.random().fork(8)), id::kCabinet),
                 Side::kWest, 0.7 * size.y());
  room.putAtWall(kShelf, id::kCabinet, Side::kEast, 0.3 * size.y());
  room.putAtWall(kShelf, id::kCabinet, Side::kEast, 0.55 * size.y());
  const auto table = room.putAtWall(kDesk, id::kDesk, room.windowSide(), 0.5 * size.x());
  if (table) room.offerOnTop(*table, "computer", {"printer"}, {0, 0}, 0, kAlways);
  room.offerAlongWalls("bin", kLargeBins, kAlways);
  room.offerAlongWalls("bin", kLargeBins, kUsually);
  room.offerAlongWalls("chair", {kTableChair}, kSometimes);
}

void furnishCorridor(RoomFitter& room) {
  // Everything on one side, so that there is always a way past.
  const Side side = room.random().chance(0.5) ? Side::kNorth : Side::kSouth;
  const double length = room.wall(side).length;
  const bool is_long = length > 15;
  const auto somewhere = [&](double low, double high) {
    return room.random().uniform(low, high) * length;
  };
  room.offerAtWall("couch", {"couch_2_seats", "couch_1_seat"}, side, somewhere(0.3, 0.4),
                   is_long ? kUsually : kSometimes);
  room.offerAtWall("couch", {"couch_2_seats", "couch_1_seat"}, side, somewhere(0.65, 0.8),
                   kSometimes);
  room.offerAtWall("bin", kDispensers, side, somewhere(0.45, 0.6), kAlways);
  room.offerAtWall("plant", kFloorPlants, side, somewhere(0.05, 0.2), kUsually);
  room.offerAtWall("plant", kFloorPlants, side, somewhere(0.85, 0.97), kUsually);
  for (const double t : {0.12, 0.16, 0.88})
    room.offerAtWall("chair", {kTableChair}, side, t * length, kOften);
}

}  // namespace

void furnishRoom(RoomKind kind, RoomFitter& room) {
  switch (kind) {
    case RoomKind::kCorridor:
      return furnishCorridor(room);
    case RoomKind::kOpenOffice:
      return furnishOpenOffice(room);
    case RoomKind::kPrivateOffice:
      return furnishPrivateOffice(room);
    case RoomKind::kMeeting:
      return furnishMeeting(room);
    case RoomKind::kTraining:
      return furnishTraining(room);
    case RoomKind::kLounge:
      return furnishLounge(room);
    case RoomKind::kCopy:
      return furnishCopyRoom(room);
    case RoomKind::kLobby:
      return furnishLobby(room);
  }
}

}  // namespace hydrabench
