// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/furnisher.h"

#include "eval/simulation/placed_shape.h"

namespace hydrabench {
namespace {

constexpr double kGap_m = 0.012;      // between pieces that have nothing to do with each other
constexpr double kContact_m = 0.002;  // how far a piece may sink into its support
constexpr double kWallGap_m = 0.013;  // the depth of the skirting

Aabb boxInWorld(const Aabb& box, const Transform& T_world_object) {
  Aabb result;
  for (int i = 0; i < 8; ++i) {
    result.extend(T_world_object * box.corner(static_cast<Aabb::CornerType>(i)));
  }
  return result;
}

}  // namespace

Transform floorPose(const Eigen::Vector2d& place, double yaw_rad, double z_m) {
  Transform pose = Transform::Identity();
  pose.translate(Eigen::Vector3d(place.x(), place.y(), z_m));
  pose.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  return pose;
}

Furnisher::Furnisher(const FloorPlan& plan, std::vector<Rect> keep_out, std::uint64_t seed,
                     InstanceSplit split)
    : plan_(plan), keep_out_(std::move(keep_out)), seed_(seed), split_(split) {}

Furnisher::Piece Furnisher::draw(const std::string& family, Label label) {
  const std::uint64_t index = instanceIndex(seed_, drawn_++);
  return take(shapeFamily(family).draw(Random(instanceSeed(split_, index))), label);
}

Furnisher::Piece Furnisher::take(ShapeInstance instance, Label label) const {
  Piece piece;
  piece.box = tightBounds(*instance.sdf);
  piece.shape = std::make_shared<const ShapeInstance>(std::move(instance));
  piece.label = label;
  return piece;
}

bool Furnisher::fits(const Placed& candidate, std::optional<Index> support) const {
  const FloorPlan::Room& room = plan_.rooms[static_cast<std::size_t>(candidate.room)];
  const Rect footprint(candidate.box.min().head<2>(), candidate.box.max().head<2>());
  const Rect inside(room.inside.min() + Eigen::Vector2d::Constant(kWallGap_m),
                    room.inside.max() - Eigen::Vector2d::Constant(kWallGap_m));
  if (!inside.contains(footprint) || candidate.box.max().z() > plan_.height_m) return false;
  if (!support && candidate.box.min().z() < 0.5) {
    for (const Rect& area : keep_out_) {
      if (area.intersects(footprint)) return false;
    }
  }
  Aabb widened = candidate.box;
  widened.min().array() -= kGap_m;
  widened.max().array() += kGap_m;
  const PlacedSdf own{candidate.piece.shape->sdf.get(), candidate.T_world_object, widened};
  for (Index i = 0; i < placed_.size(); ++i) {
    const Placed& other = placed_[i];
    if (!other.box.intersects(widened)) continue;
    const bool touching = support == i;
    if (interpenetrate(own, {other.piece.shape->sdf.get(), other.T_world_object, other.box},
                       touching ? kContact_m : -kGap_m)) {
      return false;
    }
  }
  return true;
}

std::optional<Furnisher::Index> Furnisher::put(const Piece& piece, int room,
                                               const Transform& T_world_object,
                                               std::optional<Index> support) {
  const Placed candidate{piece, room, T_world_object, boxInWorld(piece.box, T_world_object)};
  if (!fits(candidate, support)) return std::nullopt;
  placed_.push_back(candidate);
  return placed_.size() - 1;
}

std::optional<Furnisher::Index> Furnisher::putFirst(const Piece& piece, int room,
                                                    const std::vector<Transform>& poses,
                                                    std::optional<Index> support) {
  for (const Transform& pose : poses) {
    if (const auto index = put(piece, room, pose, support)) return index;
  }
  return std::nullopt;
}

std::optional<double> Furnisher::topOf(Index index, const Eigen::Vector2d& point) const {
  const Piece& piece = placed_[index].piece;
  return heightBelow(*piece.shape->sdf, {point.x(), point.y(), piece.box.max().z() + 0.05});
}

void appendPieces(const std::vector<Furnisher::Placed>& placed, const FloorPlan& plan,
                  Scene& scene) {
  std::vector<PlacedShape> shapes;
  for (const Furnisher::Placed& item : placed) {
    shapes.push_back({item.piece.shape, item.piece.label,
                      plan.rooms[static_cast<std::size_t>(item.room)].name, item.T_world_object});
  }
  appendShapes(shapes, scene);
}

}  // namespace hydrabench
