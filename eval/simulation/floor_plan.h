// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/types/random.h"

namespace hydrabench {

using Rect = Eigen::AlignedBox2d;  ///< floor area [m], world frame

inline Rect makeRect(double x_low, double y_low, double x_high, double y_high) {
  return {Eigen::Vector2d(x_low, y_low), Eigen::Vector2d(x_high, y_high)};
}

enum class RoomKind {
  kCorridor,
  kOpenOffice,
  kPrivateOffice,
  kMeeting,
  kTraining,
  kLounge,
  kCopy,
  kLobby
};

struct FloorPlan {
  struct Room {
    std::string name;  ///< "meeting"
    RoomKind kind = RoomKind::kCorridor;
    Rect cell;    ///< up to the middle of the walls; the cells tile the building
    Rect inside;  ///< between the wall faces
  };
  /// A gap in a wall: a door or passage from the floor up, or a window.
  struct Opening {
    double low = 0;  ///< along the wall, world x or y [m]
    double high = 0;
    bool window = false;
    bool leaf = false;     ///< has a door that stands open
    bool leaf_up = false;  ///< the leaf stands on the side of growing y (or x)
    bool hinge_high = false;
  };
  struct Wall {
    bool along_x = true;
    double at = 0;  ///< y (or x) of the middle plane
    double low = 0;
    double high = 0;
    double thickness = 0.12;
    std::vector<Opening> openings;  ///< ascending, apart
  };
  std::vector<Room> rooms;  ///< the corridor first
  std::vector<Wall> walls;
  double height_m = 2.7;

  int roomAt(const Eigen::Vector2d& point) const;  ///< -1 outside
};

/// Two rows of rooms along a corridor: open-plan office, meeting room and lounge on one side;
/// lobby, two private offices, copy room and training room on the other. Sizes and doors vary with
/// the seed.
FloorPlan drawOfficePlan(Random random);

/// A private office, a lounge and a piece of corridor.
FloorPlan drawQuickPlan(Random random);

}  // namespace hydrabench
