// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/furnisher.h"

#include <map>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/surface_mesher.h"

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

std::shared_ptr<const Surface> surfaceOf(const ShapeInstance& shape) {
  SurfaceMesh meshed = meshInstance(shape);
  auto surface = std::make_shared<Surface>();
  surface->mesh = std::move(meshed.mesh);
  surface->face_material = std::move(meshed.face_part);
  for (const ShapePart& part : shape.parts) surface->materials.push_back(part.material);
  return surface;
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
  // Desks of one island share their shape, and so their mesh.
  std::vector<std::size_t> same_as(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    same_as[i] = 0;
    while (placed[same_as[i]].piece.shape != placed[i].piece.shape) ++same_as[i];
  }
  std::vector<std::shared_ptr<const Surface>> surfaces(placed.size());
  parallelFor(placed.size(), [&](std::size_t i) {
    if (same_as[i] == i) surfaces[i] = surfaceOf(*placed[i].piece.shape);
  });
  std::map<Label, int> counts;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Furnisher::Placed& item = placed[i];
    const LabelSpace::Entry* entry = scene.label_space.find(item.piece.label);
    SceneObject object;
    object.name = fmt::format("{}_{:03d}", scene.label_space.nameOf(item.piece.label),
                              ++counts[item.piece.label]);
    object.subtype = item.piece.shape->family;
    object.room = plan.rooms[static_cast<std::size_t>(item.room)].name;
    object.label = item.piece.label;
    object.scored = entry && entry->is_scored;
    object.T_world_object = item.T_world_object;
    object.surface = surfaces[same_as[i]];
    object.shape = item.piece.shape;
    scene.objects.push_back(std::move(object));
  }
}

}  // namespace hydrabench
