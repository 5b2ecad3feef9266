// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eval/simulation/floor_plan.h"
#include "eval/simulation/scene.h"
#include "eval/simulation/sdf_queries.h"

namespace hydrabench {

/// Puts pieces of furniture into the rooms of a plan, so that nothing touches anything else, leaves
/// its room or blocks a door. Works on the exact distance fields; meshes are made at the end, all
/// at once.
class Furnisher {
 public:
  /// A drawn instance that has no place yet.
  struct Piece {
    std::shared_ptr<const ShapeInstance> shape;
    Label label = kUnknownLabel;
    Aabb box;                                         ///< object frame, tight
    double depth() const { return box.sizes().x(); }  ///< from back to front
    double width() const { return box.sizes().y(); }
  };
  struct Placed {
    Piece piece;
    int room = 0;
    Transform T_world_object = Transform::Identity();
    Aabb box;  ///< world frame
  };
  using Index = std::size_t;

  /// @param keep_out  floor areas in which nothing may stand
  /// @param split  that instances are drawn from
  Furnisher(const FloorPlan& plan, std::vector<Rect> keep_out, std::uint64_t seed,
            InstanceSplit split = InstanceSplit::kEvaluation);

  Piece draw(const std::string& family, Label label);     ///< a new instance
  Piece take(ShapeInstance instance, Label label) const;  ///< a piece made to measure
  /// @param support  what it stands on or hangs at; may be touched. Pieces that stand on something
  /// or hang do not block doors.
  std::optional<Index> put(const Piece& piece, int room, const Transform& T_world_object,
                           std::optional<Index> support = std::nullopt);
  /// The first of the poses that fits.
  std::optional<Index> putFirst(const Piece& piece, int room, const std::vector<Transform>& poses,
                                std::optional<Index> support = std::nullopt);

  const Placed& operator[](Index index) const { return placed_[index]; }
  std::size_t size() const { return placed_.size(); }
  /// Top of a placed piece below a point given in its own frame [m].
  std::optional<double> topOf(Index index, const Eigen::Vector2d& point) const;

  const std::vector<Placed>& placed() const { return placed_; }

 private:
  bool fits(const Placed& candidate, std::optional<Index> support) const;

  const FloorPlan& plan_;
  std::vector<Rect> keep_out_;
  std::uint64_t seed_;
  InstanceSplit split_;
  std::uint64_t drawn_ = 0;
  std::vector<Placed> placed_;
};

/// Meshes all pieces and appends them to the scene.
void appendPieces(const std::vector<Furnisher::Placed>& placed, const FloorPlan& plan,
                  Scene& scene);

/// Pose on the floor.
Transform floorPose(const Eigen::Vector2d& place, double yaw_rad, double z_m = 0);

}  // namespace hydrabench
