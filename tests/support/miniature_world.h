// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/geometry/raycaster.h"
#include "core/geometry/transform.h"
#include "core/graph/scene_graph.h"
#include "core/pipeline/mapping_system.h"
#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Labels of the miniature worlds: the ids of the uHumans2 office.
namespace miniature_label {
inline constexpr Label kFloor = 3;
inline constexpr Label kChair = 5;
inline constexpr Label kCouch = 7;
inline constexpr Label kComputer = 10;
inline constexpr Label kPlant = 13;
inline constexpr Label kBin = 18;
inline constexpr Label kWall = 19;
inline constexpr Label kHuman = 20;
}  // namespace miniature_label

/// Objects: chair, couch, computer, plant, bin.
LabelSpace miniatureLabelSpace();

/// 180 x 120 pixels, 90 degrees wide, 67 high: an image is drawn in about a millisecond.
Camera miniatureCamera();

/// A scene made by hand, drawn without noise: what a test of a method sees.
///
///     MiniatureWorld world;
///     world.addRoom(4, 4, 2.5);
///     world.add(transformed(pose(1, 0, 0, 0.5), tinyChair()), miniature_label::kChair, 1);
///     const SceneGraph graph = world.drive(orbitPath({1, 0, 0.4}, 1.5, 1.2, 60), method);
class MiniatureWorld {
 public:
  /// Where a thing that moves has gone since it was added; world to world.
  using Motion = std::function<Transform(std::int64_t stamp_ns)>;

  explicit MiniatureWorld(const Camera& camera = miniatureCamera());

  /// @param mesh    world frame [m]; either side of a face is seen
  /// @param object  its number, 1, 2, 3 ...: pixels of the same number are one instance. 0: none
  void add(const Mesh& mesh, Label label, InstanceId object = kNoInstance, Motion motion = {});
  /// Floor at z = 0 and four walls around the origin [m].
  void addRoom(double length_x, double length_y, double height);

  /// Instance ids of a frame are the numbers of the objects; from here on they are drawn anew for
  /// every frame, without repetition within a frame.
  void shuffleInstanceIds() { shuffle_ = true; }
  /// In the frame of this stamp the object's pixels and its instance carry `wrong`.
  void confuse(InstanceId object, Label wrong, std::int64_t stamp_ns);

  /// z-depth (exact to float), labels, instances, instance_labels, and as colour that of the label.
  /// Pixels that see nothing: depth 0, label unknown, no instance.
  Frame frame(const Transform& T_world_camera, std::int64_t stamp_ns);

  /// Where the camera is at which time.
  struct View {
    std::int64_t stamp_ns = 0;
    Transform T_world_camera = Transform::Identity();
  };
  using Path = std::vector<View>;
  /// Feeds the frames of a path to a method and finishes it.
  SceneGraph drive(const Path& path, MappingSystem& method);

 private:
  struct Thing {
    Mesh mesh;
    Label label = kUnknownLabel;
    InstanceId object = kNoInstance;
    Motion motion;
  };
  struct Confusion {
    InstanceId object = kNoInstance;
    Label wrong = kUnknownLabel;
    std::int64_t stamp_ns = 0;
  };
  /// Things that move together, i.e. all that stand still, or one that moves.
  struct Group {
    Raycaster raycaster;
    std::vector<std::size_t> things;  ///< by the raycaster's number of the mesh
    Motion motion;
  };
  void buildGroups();
  Label labelOf(const Thing& thing, std::int64_t stamp_ns) const;

  Camera camera_;
  LabelSpace label_space_ = miniatureLabelSpace();
  std::vector<Thing> things_;
  std::vector<Confusion> confusions_;
  std::vector<Group> groups_;  ///< empty until the first frame after an add()
  bool shuffle_ = false;
};

/// Time from one view to the next [ns] (10 frames a second), and stamp of the first.
inline constexpr std::int64_t kMiniaturePeriodNs = 100'000'000;
inline constexpr std::int64_t kMiniatureStartNs = 1'000'000'000;

/// Once around a point from angle 0 (+x), counter-clockwise, looking at it all the time.
/// @param radius  horizontal distance of the eye [m]
/// @param height  of the eye, world z [m]
/// @param turn    angle that is covered [rad]
MiniatureWorld::Path orbitPath(const Eigen::Vector3d& target, double radius, double height,
                               int num_views, double turn = 6.283185307179586,
                               std::int64_t start_ns = kMiniatureStartNs);

/// Along a line, looking at `target` all the time.
MiniatureWorld::Path straightPath(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const Eigen::Vector3d& target, int num_views,
                                  std::int64_t start_ns = kMiniatureStartNs);

/// Stands still.
MiniatureWorld::Path stillPath(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                               int num_views, std::int64_t start_ns = kMiniatureStartNs);

/// Place on the floor and yaw [m, rad].
Transform pose(double x, double y, double z, double yaw);
/// Cuboid that stands at z = 0 around the origin [m].
Mesh standingBox(double length_x, double length_y, double height);
/// Seat, back and four legs: 0.5 x 0.5 x 0.9 m, standing around the origin, front to +x.
Mesh tinyChair();

}  // namespace hydrabench
