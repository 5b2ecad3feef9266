// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/simulation/furnisher.h"

namespace hydrabench {

/// A place where an object of a class would make sense. Recipes offer more slots than there are
/// objects to place; the quota of the class decides how many are used, those of low priority value
/// first.
struct Slot {
  std::string class_name;             ///< "chair"
  std::vector<std::string> families;  ///< one of these is drawn
  int room = 0;
  int priority = 0;
  std::function<std::vector<Transform>(const Furnisher::Piece&, Random)> poses;  ///< tried in order
  std::optional<Furnisher::Index> support;
};

/// One wall of a room, seen from inside with the wall at one's back: `along` runs to the left.
struct WallFrame {
  Eigen::Vector2d origin;
  Eigen::Vector2d along;
  Eigen::Vector2d inward;
  double length = 0;

  double yaw() const;
  /// A piece with its back to the wall, its middle at distance t from the wall's start.
  Transform backTo(const Aabb& box, double t, double gap_m = 0.03, double z_m = 0) const;
};
enum class Side { kSouth, kEast, kNorth, kWest };

/// Furnishes one room: puts furniture down at once, and offers slots for the objects.
class RoomFitter {
 public:
  using Index = Furnisher::Index;
  RoomFitter(Furnisher& furnisher, const FloorPlan& plan, int room, Random random,
             std::vector<Slot>& slots);

  const Rect& inside() const { return inside_; }
  WallFrame wall(Side side) const;
  Side corridorSide() const { return corridor_side_; }
  Side windowSide() const;
  Random& random() { return random_; }
  Furnisher& furnisher() { return furnisher_; }

  std::optional<Index> put(const std::string& family, Label label, const Eigen::Vector2d& place,
                           double yaw_rad);
  std::optional<Index> put(const Furnisher::Piece& piece, const Eigen::Vector2d& place,
                           double yaw_rad);
  /// With its back to a wall, as near to `t` as it fits.
  std::optional<Index> putAtWall(const std::string& family, Label label, Side side, double t);
  std::optional<Index> putAtWall(const Furnisher::Piece& piece, Side side, double t,
                                 double z_m = 0);

  /// A chair in front of a table, more or less pushed under it.
  /// @param seat     place at the table's edge, frame of the table
  /// @param towards  direction the sitter looks, frame of the table [rad]
  void offerChair(Index table, const Eigen::Vector2d& seat, double towards,
                  const std::string& family, int priority);
  /// Chairs all around a table: `along` on each long side, `across` at each end.
  void offerChairsAround(Index table, int along, int across, const std::string& family,
                         int priority);
  /// The same for a table without corners.
  void offerChairsInCircle(Index table, int count, const std::string& family, int priority);
  void offerAtWall(const std::string& class_name, std::vector<std::string> families, Side side,
                   double t, int priority);
  /// Anywhere along the walls.
  void offerAlongWalls(const std::string& class_name, std::vector<std::string> families,
                       int priority);
  void offerInCorner(const std::string& class_name, std::vector<std::string> families,
                     int priority);
  /// Next to a table or desk, on the floor.
  void offerBeside(Index table, const std::string& class_name, std::vector<std::string> families,
                   int priority);
  /// On a table; `place` in the table's frame.
  void offerOnTop(Index table, const std::string& class_name, std::vector<std::string> families,
                  const Eigen::Vector2d& place, double yaw_rad, int priority);

 private:
  void offer(Slot slot);

  Furnisher& furnisher_;
  const FloorPlan& plan_;
  int room_;
  Rect inside_;
  Side corridor_side_ = Side::kNorth;
  Random random_;
  std::vector<Slot>& slots_;
};

}  // namespace hydrabench
