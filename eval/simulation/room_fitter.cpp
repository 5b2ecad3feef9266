// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/room_fitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hydrabench {
namespace {

using Piece = Furnisher::Piece;
using Eigen::Vector2d;
constexpr double kPi = std::numbers::pi;

}  // namespace

double WallFrame::yaw() const { return std::atan2(inward.y(), inward.x()); }

Transform WallFrame::backTo(const Aabb& box, double t, double gap_m, double z_m) const {
  return floorPose(origin + t * along + (gap_m - box.min().x()) * inward, yaw(), z_m);
}

RoomFitter::RoomFitter(Furnisher& furnisher, const FloorPlan& plan, int room, Random random,
                       std::vector<Slot>& slots)
    : furnisher_(furnisher),
      plan_(plan),
      room_(room),
      inside_(plan.rooms[static_cast<std::size_t>(room)].inside),
      random_(random),
      slots_(slots) {
  const bool below = inside_.center().y() < plan.rooms.front().inside.center().y();
  corridor_side_ = below ? Side::kNorth : Side::kSouth;
}

Side RoomFitter::windowSide() const {
  return corridor_side_ == Side::kNorth ? Side::kSouth : Side::kNorth;
}

WallFrame RoomFitter::wall(Side side) const {
  const Vector2d low = inside_.min();
  const Vector2d high = inside_.max();
  const Vector2d size = high - low;
  switch (side) {
    case Side::kSouth:
      return {{high.x(), low.y()}, {-1, 0}, {0, 1}, size.x()};
    case Side::kEast:
      return {high, {0, -1}, {-1, 0}, size.y()};
    case Side::kNorth:
      return {{low.x(), high.y()}, {1, 0}, {0, -1}, size.x()};
    case Side::kWest:
      return {low, {0, 1}, {1, 0}, size.y()};
  }
  return {};
}

std::optional<RoomFitter::Index> RoomFitter::put(const std::string& family, Label label,
                                                 const Vector2d& place, double yaw_rad) {
  return put(furnisher_.draw(family, label), place, yaw_rad);
}

std::optional<RoomFitter::Index> RoomFitter::put(const Piece& piece, const Vector2d& place,
                                                 double yaw_rad) {
  return furnisher_.put(piece, room_, floorPose(place, yaw_rad));
}

std::optional<RoomFitter::Index> RoomFitter::putAtWall(const std::string& family, Label label,
                                                       Side side, double t) {
  return putAtWall(furnisher_.draw(family, label), side, t);
}

std::optional<RoomFitter::Index> RoomFitter::putAtWall(const Piece& piece, Side side, double t,
                                                       double z_m) {
  const WallFrame frame = wall(side);
  const double half = 0.5 * piece.width() + 0.03;
  std::vector<Transform> poses;
  for (int step = 0; step < 40; ++step) {
    const double at = t + (step % 2 == 0 ? 1 : -1) * 0.1 * ((step + 1) / 2);
    if (at > half && at < frame.length - half)
      poses.push_back(frame.backTo(piece.box, at, 0.03, z_m));
  }
  return furnisher_.putFirst(piece, room_, poses);
}

void RoomFitter::offer(Slot slot) {
  slot.room = room_;
  slots_.push_back(std::move(slot));
}

void RoomFitter::offerChair(Index table, const Vector2d& seat, double towards,
                            const std::string& family, int priority) {
  const Transform T_world_table = furnisher_[table].T_world_object;
  offer({"chair",
         {family},
         room_,
         priority,
         [=](const Piece& piece, Random random) {
           const bool pulled_out = random.chance(0.25);
           const double under =
               pulled_out ? random.uniform(-0.25, -0.05) : random.uniform(0.05, 0.28);
           const double turn = pulled_out ? random.uniform(-0.7, 0.7) : random.uniform(-0.22, 0.22);
           const Vector2d look(std::cos(towards), std::sin(towards));
           const Vector2d side(-look.y(), look.x());
           const double shift = random.uniform(-0.05, 0.05);
           std::vector<Transform> poses;
           for (int step = 0; step < 10; ++step) {
             const double back = piece.box.max().x() - under + 0.05 * step;
             poses.push_back(T_world_table *
                             floorPose(seat - back * look + shift * side, towards + turn));
           }
           return poses;
         },
         std::nullopt});
}

void RoomFitter::offerChairsAround(Index table, int along, int across, const std::string& family,
                                   int priority) {
  const Aabb box = furnisher_[table].piece.box;
  const bool long_y = box.sizes().y() >= box.sizes().x();
  const Vector2d half = 0.5 * box.sizes().head<2>();
  for (const int sign : {-1, 1}) {
    for (int i = 0; i < along; ++i) {
      const double share = (i + 0.5) / along * 2 - 1;
      const Vector2d seat = long_y ? Vector2d(sign * half.x(), share * half.y())
                                   : Vector2d(share * half.x(), sign * half.y());
      const Vector2d look = long_y ? Vector2d(-sign, 0) : Vector2d(0, -sign);
      offerChair(table, seat, std::atan2(look.y(), look.x()), family, priority);
    }
    for (int i = 0; i < across; ++i) {
      const Vector2d seat = long_y ? Vector2d(0, sign * half.y()) : Vector2d(sign * half.x(), 0);
      const Vector2d look = -seat.normalized();
      offerChair(table, seat, std::atan2(look.y(), look.x()), family, priority + 1);
    }
  }
}

void RoomFitter::offerChairsInCircle(Index table, int count, const std::string& family,
                                     int priority) {
  const double radius = 0.25 * furnisher_[table].piece.box.sizes().head<2>().sum();
  const double start = random_.uniform(0, 2 * kPi);
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2 * kPi * i / count;
    offerChair(table, radius * Vector2d(std::cos(angle), std::sin(angle)), angle + kPi, family,
               priority);
  }
}

void RoomFitter::offerAtWall(const std::string& class_name, std::vector<std::string> families,
                             Side side, double t, int priority) {
  const WallFrame frame = wall(side);
  offer({class_name, std::move(families), room_, priority,
         [=](const Piece& piece, Random random) {
           std::vector<Transform> poses;
           const double gap = random.uniform(0.03, 0.08);
           const double turn = random.uniform(-0.03, 0.03);
           for (int step = 0; step < 24; ++step) {
             const double at = t + (step % 2 == 0 ? 1 : -1) * 0.1 * ((step + 1) / 2);
             if (at < 0 || at > frame.length) continue;
             poses.push_back(frame.backTo(piece.box, at, gap) *
                             Transform(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ())));
           }
           return poses;
         },
         std::nullopt});
}

void RoomFitter::offerAlongWalls(const std::string& class_name, std::vector<std::string> families,
                                 int priority) {
  std::array<WallFrame, 4> frames = {wall(Side::kSouth), wall(Side::kEast), wall(Side::kNorth),
                                     wall(Side::kWest)};
  offer({class_name, std::move(families), room_, priority,
         [=](const Piece& piece, Random random) {
           std::vector<Transform> poses;
           for (int attempt = 0; attempt < 40; ++attempt) {
             const WallFrame& frame = frames[random.index(4)];
             const double half = 0.5 * piece.width() + 0.05;
             const double place = random.uniform(half, frame.length - half);
             poses.push_back(frame.backTo(piece.box, place, random.uniform(0.03, 0.07)));
           }
           return poses;
         },
         std::nullopt});
}

void RoomFitter::offerInCorner(const std::string& class_name, std::vector<std::string> families,
                               int priority) {
  const Rect area = inside_;
  offer({class_name, std::move(families), room_, priority,
         [=](const Piece& piece, Random random) {
           const double reach =
               piece.box.min().head<2>().cwiseAbs().cwiseMax(piece.box.max().head<2>()).maxCoeff();
           const std::uint32_t first = random.index(4);
           std::vector<Transform> poses;
           for (std::uint32_t i = 0; i < 4; ++i) {
             for (const double inset : {0.06, 0.15, 0.3}) {
               const std::uint32_t corner = (first + i) % 4;
               const Vector2d margin = Vector2d::Constant(reach + inset);
               const Vector2d low = area.min() + margin;
               const Vector2d high = area.max() - margin;
               poses.push_back(
                   floorPose({corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y()},
                             random.uniform(0, 2 * kPi)));
             }
           }
           return poses;
         },
         std::nullopt});
}

void RoomFitter::offerBeside(Index table, const std::string& class_name,
                             std::vector<std::string> families, int priority) {
  const Transform T_world_table = furnisher_[table].T_world_object;
  const Aabb around = furnisher_[table].piece.box;
  offer(
      {class_name, std::move(families), room_, priority,
       [=](const Piece& piece, Random random) {
         std::vector<Transform> poses;
         const int first = random.chance(0.5) ? 1 : -1;
         for (const int sign : {first, -first}) {
           for (const double gap : {0.05, 0.12, 0.25}) {
             for (const double share : {0.3, 0.0, 0.6, -0.3}) {
               const double y = sign * (0.5 * (around.sizes().y() + piece.width()) + gap);
               const double x = share * 0.5 * around.sizes().x();
               poses.push_back(T_world_table * floorPose({x, y}, random.uniform(-0.3, 0.3)));
             }
           }
         }
         // Under the desk, where the legs leave room.
         for (const double share : {0.6, -0.6, 0.3}) {
           poses.push_back(T_world_table * floorPose({-0.1, share * 0.5 * around.sizes().y()}, 0));
         }
         return poses;
       },
       std::nullopt});
}

void RoomFitter::offerOnTop(Index table, const std::string& class_name,
                            std::vector<std::string> families, const Vector2d& place,
                            double yaw_rad, int priority) {
  const Transform T_world_table = furnisher_[table].T_world_object;
  const Furnisher* furnisher = &furnisher_;
  offer({class_name, std::move(families), room_, priority,
         [=](const Piece& piece, Random random) {
           std::vector<Transform> poses;
           for (int attempt = 0; attempt < 8; ++attempt) {
             const Vector2d spot =
                 place +
                 0.03 * (1 + attempt) * Vector2d{random.uniform(-1, 1), random.uniform(-1, 1)};
             // The whole footprint must find the top at one height.
             const double yaw = yaw_rad + random.uniform(-0.12, 0.12);
             const auto height = furnisher->topOf(table, spot);
             bool level = height.has_value();
             for (int corner = 0; corner < 4 && level; ++corner) {
               const Vector2d offset(corner & 1 ? piece.box.max().x() : piece.box.min().x(),
                                     corner & 2 ? piece.box.max().y() : piece.box.min().y());
               const auto other = furnisher->topOf(table, spot + Eigen::Rotation2Dd(yaw) * offset);
               level = other && std::abs(*other - *height) < 0.002;
             }
             if (level) poses.push_back(T_world_table * floorPose(spot, yaw, *height));
           }
           return poses;
         },
         table});
}

}  // namespace hydrabench
