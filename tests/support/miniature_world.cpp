// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "tests/support/miniature_world.h"

#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/types/random.h"

namespace hydrabench {

using Eigen::Vector3d;

LabelSpace miniatureLabelSpace() {
  namespace id = miniature_label;
  return {{
      {kUnknownLabel, "unknown", {32, 32, 32}, false, false},
      {id::kFloor, "floor", {124, 133, 141}, false, false},
      {id::kChair, "chair", {102, 255, 0}, true, true},
      {id::kCouch, "couch", {39, 144, 65}, true, true},
      {id::kComputer, "computer", {255, 23, 23}, true, false},
      {id::kPlant, "plant", {38, 112, 233}, true, true},
      {id::kBin, "bin", {154, 38, 91}, true, true},
      {id::kWall, "wall", {2, 103, 71}, false, false},
      {id::kHuman, "human", {35, 213, 234}, false, false},
  }};
}

Camera miniatureCamera() { return {180, 120, 90, 90, 89.5, 59.5}; }

MiniatureWorld::MiniatureWorld(const Camera& camera) : camera_(camera) {}

void MiniatureWorld::add(const Mesh& mesh, Label label, InstanceId object, Motion motion) {
  things_.push_back({mesh, label, object, std::move(motion)});
  groups_.clear();
}

void MiniatureWorld::addRoom(double length_x, double length_y, double height) {
  constexpr double kThickness = 0.2;
  const double x = 0.5 * length_x;
  const double y = 0.5 * length_y;
  add(boxMesh(Aabb(Vector3d(-x, -y, -kThickness), Vector3d(x, y, 0))), miniature_label::kFloor);
  const Aabb walls[] = {
      {Vector3d(-x - kThickness, -y, 0), Vector3d(-x, y, height)},
      {Vector3d(x, -y, 0), Vector3d(x + kThickness, y, height)},
      {Vector3d(-x, -y - kThickness, 0), Vector3d(x, -y, height)},
      {Vector3d(-x, y, 0), Vector3d(x, y + kThickness, height)},
  };
  for (const Aabb& wall : walls) add(boxMesh(wall), miniature_label::kWall);
}

void MiniatureWorld::confuse(InstanceId object, Label wrong, std::int64_t stamp_ns) {
  confusions_.push_back({object, wrong, stamp_ns});
}

Label MiniatureWorld::labelOf(const Thing& thing, std::int64_t stamp_ns) const {
  for (const Confusion& confusion : confusions_) {
    if (thing.object != kNoInstance && confusion.object == thing.object &&
        confusion.stamp_ns == stamp_ns) {
      return confusion.wrong;
    }
  }
  return thing.label;
}

void MiniatureWorld::buildGroups() {
  groups_.emplace_back();
  for (std::size_t i = 0; i < things_.size(); ++i) {
    Group* group = &groups_.front();
    if (things_[i].motion) {
      group = &groups_.emplace_back();
      group->motion = things_[i].motion;
    }
    group->raycaster.add(things_[i].mesh);
    group->things.push_back(i);
  }
  for (Group& group : groups_) group.raycaster.commit();
}

Frame MiniatureWorld::frame(const Transform& T_world_camera, std::int64_t stamp_ns) {
  if (groups_.empty()) buildGroups();
  const std::size_t num_pixels =
      static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height);
  std::vector<float> depths(num_pixels, 0.0f);
  std::vector<const Thing*> seen(num_pixels, nullptr);
  std::vector<Raycaster::Ray> rays(num_pixels);
  std::vector<Raycaster::Hit> hits(num_pixels);
  for (const Group& group : groups_) {
    if (group.things.empty()) continue;
    const Transform T_group_camera =
        (group.motion ? group.motion(stamp_ns).inverse() : Transform::Identity()) * T_world_camera;
    for (std::size_t i = 0; i < num_pixels; ++i) {
      // A direction with z = 1 in the camera makes distances z-depths.
      const Vector3d direction = camera_.backproject(static_cast<int>(i) % camera_.width,
                                                     static_cast<int>(i) / camera_.width, 1.0);
      rays[i].origin = T_group_camera.translation().cast<float>();
      rays[i].direction = (T_group_camera.linear() * direction).cast<float>();
    }
    group.raycaster.intersect(rays, hits);
    for (std::size_t i = 0; i < num_pixels; ++i) {
      if (!hits[i] || (seen[i] && depths[i] <= hits[i].distance)) continue;
      depths[i] = hits[i].distance;
      seen[i] = &things_[group.things[hits[i].mesh]];
    }
  }

  // Ids of this frame, drawn in the order of the objects' numbers.
  std::map<InstanceId, InstanceId> frame_id;
  for (const Thing& thing : things_) frame_id[thing.object] = thing.object;
  if (shuffle_) {
    Random random(0x1d5, static_cast<std::uint64_t>(stamp_ns));
    std::set<InstanceId> taken;
    for (auto& [object, id] : frame_id) {
      do {
        id = 1 + static_cast<InstanceId>(random.index(1000));
      } while (!taken.insert(id).second);
    }
  }
  frame_id[kNoInstance] = kNoInstance;

  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.camera = camera_;
  frame.T_world_camera = T_world_camera;
  frame.color = Image<Rgb>(camera_.width, camera_.height);
  frame.depth = Image<float>(camera_.width, camera_.height);
  frame.labels = Image<Label>(camera_.width, camera_.height, kUnknownLabel);
  frame.instances = Image<InstanceId>(camera_.width, camera_.height, kNoInstance);
  for (std::size_t i = 0; i < num_pixels; ++i) {
    if (!seen[i]) continue;
    const Label label = labelOf(*seen[i], stamp_ns);
    const LabelSpace::Entry* entry = label_space_.find(label);
    frame.color.data()[i] = entry ? entry->color : Rgb{};
    frame.depth.data()[i] = depths[i];
    frame.labels.data()[i] = label;
    frame.instances.data()[i] = frame_id.at(seen[i]->object);
    if (seen[i]->object != kNoInstance) frame.instance_labels[frame_id.at(seen[i]->object)] = label;
  }
  return frame;
}

SceneGraph MiniatureWorld::drive(const Path& path, MappingSystem& method) {
  for (const View& view : path) method.process(frame(view.T_world_camera, view.stamp_ns));
  return method.finish();
}

MiniatureWorld::Path orbitPath(const Vector3d& target, double radius, double height, int num_views,
                               double turn, std::int64_t start_ns) {
  MiniatureWorld::Path path;
  for (int i = 0; i < num_views; ++i) {
    const double angle = turn * i / num_views;
    const Vector3d eye(target.x() + radius * std::cos(angle), target.y() + radius * std::sin(angle),
                       height);
    path.push_back({start_ns + i * kMiniaturePeriodNs, lookAt(eye, target)});
  }
  return path;
}

MiniatureWorld::Path straightPath(const Vector3d& from, const Vector3d& to, const Vector3d& target,
                                  int num_views, std::int64_t start_ns) {
  assert(num_views > 1);
  MiniatureWorld::Path path;
  for (int i = 0; i < num_views; ++i) {
    const double fraction = static_cast<double>(i) / (num_views - 1);
    path.push_back(
        {start_ns + i * kMiniaturePeriodNs, lookAt(from + fraction * (to - from), target)});
  }
  return path;
}

MiniatureWorld::Path stillPath(const Vector3d& eye, const Vector3d& target, int num_views,
                               std::int64_t start_ns) {
  MiniatureWorld::Path path;
  for (int i = 0; i < num_views; ++i) {
    path.push_back({start_ns + i * kMiniaturePeriodNs, lookAt(eye, target)});
  }
  return path;
}

Transform pose(double x, double y, double z, double yaw) {
  Transform T = Transform::Identity();
  T.translation() = Vector3d(x, y, z);
  T.linear() = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

Mesh standingBox(double length_x, double length_y, double height) {
  return boxMesh(Aabb(Vector3d(-0.5 * length_x, -0.5 * length_y, 0),
                      Vector3d(0.5 * length_x, 0.5 * length_y, height)));
}

Mesh tinyChair() {
  Mesh chair = boxMesh(Aabb(Vector3d(-0.25, -0.25, 0.40), Vector3d(0.25, 0.25, 0.46)));
  append(boxMesh(Aabb(Vector3d(-0.25, -0.25, 0.46), Vector3d(-0.19, 0.25, 0.90))), chair);
  for (const double x : {-0.25, 0.20}) {
    for (const double y : {-0.25, 0.20}) {
      append(boxMesh(Aabb(Vector3d(x, y, 0), Vector3d(x + 0.05, y + 0.05, 0.40))), chair);
    }
  }
  return chair;
}

}  // namespace hydrabench
