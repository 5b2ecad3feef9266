// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "core/types/random.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// A few small frames of noise with poses full of digits, and two objects: everything a dataset can
/// hold.
class ToyDataset : public Dataset {
 public:
  explicit ToyDataset(std::size_t num_frames = 4) {
    camera_ = {.width = 12, .height = 8, .fx = 10.1, .fy = 1.0 / 3.0, .cx = 6, .cy = -4.25};
    label_space_.entries = {{0, "unknown", {32, 32, 32}, false, false},
                            {5, "chair: \"tall\"", {102, 255, 0}, true, true},
                            {10, "computer", {255, 23, 23}, true, false}};
    for (std::size_t i = 0; i < num_frames; ++i) {
      ground_truth_.trajectory.push_back(
          {static_cast<std::int64_t>(1'700'000'000'123'456'789 + 100'000'000 * i), pose(i)});
    }
    for (std::uint64_t i = 0; i < 2; ++i) {
      GroundTruthObject object;
      object.id = i == 0 ? 1 : 5692549928996306947u;
      object.label = i == 0 ? 5 : 10;
      object.name = i == 0 ? "chair_000" : "computer_000";
      object.subtype = i == 0 ? "" : "laptop #2";
      object.room = i == 0 ? "meeting_1" : "";
      object.T_world_object = pose(100 + i);
      Mesh mesh = sphereMesh({0, 0, 0.4}, 0.3, 1);
      roundToFloat(mesh);
      if (i == 1) mesh.colors.assign(mesh.vertices.size(), Rgb{1, 2, 3});
      object.mesh = std::make_shared<const Mesh>(mesh);
      object.visible_fraction = 1.0 / (3.0 + static_cast<double>(i));
      object.scored = i == 0;
      ground_truth_.objects.push_back(object);
      append(transformed(object.T_world_object, mesh), ground_truth_.scene_mesh);
    }
    ground_truth_.scene_mesh.colors.clear();
    ground_truth_.scene_labels.assign(ground_truth_.scene_mesh.faces.size(), 5);
    ground_truth_.scene_labels.back() = 19;
    roundToFloat(ground_truth_.scene_mesh);
    ground_truth_.rooms.push_back(
        {"meeting_1", Aabb(Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d(1.0 / 3.0, 2, 3))});
  }

  std::string name() const override { return "toy"; }
  std::uint64_t seed() const override { return 18446744073709551615u; }
  const LabelSpace& labelSpace() const override { return label_space_; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return ground_truth_.trajectory.size(); }
  const GroundTruth& groundTruth() const override { return ground_truth_; }

  Frame frame(std::size_t index) const override {
    Random random(index);
    Frame frame;
    frame.stamp_ns = ground_truth_.trajectory.at(index).stamp_ns;
    frame.T_world_camera = pose(1000 + index);  // drifted: not the true one
    frame.camera = camera_;
    frame.color = Image<Rgb>(camera_.width, camera_.height);
    frame.depth = Image<float>(camera_.width, camera_.height);
    frame.labels = Image<Label>(camera_.width, camera_.height);
    frame.instances = Image<InstanceId>(camera_.width, camera_.height);
    frame.instance_labels = {{3, 5}, {300, 10}};
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
      frame.color.data()[i] = {static_cast<std::uint8_t>(random.index(256)), 0, 255};
      const float n = std::nearbyint(static_cast<float>(random.uniform(0, 5000)));
      frame.depth.data()[i] = exact_depth ? static_cast<float>(random.uniform(0, 5))
                                          : static_cast<float>(depth_quantum_m) * n;
      const InstanceId id = random.chance(0.3) ? 3 : random.chance(0.3) ? 300 : kNoInstance;
      frame.instances.data()[i] = id;
      frame.labels.data()[i] = id == kNoInstance ? 19 : frame.instance_labels.at(id);
    }
    return frame;
  }

  double depth_quantum_m = 0.001;
  bool exact_depth = false;  ///< depth that is no multiple of anything

 protected:
  static Transform pose(std::uint64_t seed) {
    Random random(seed);
    const Eigen::Vector3d axis =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    Transform pose = Transform::Identity();
    pose.linear() = Eigen::AngleAxisd(random.uniform(0, 3), axis).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(random.normal(), random.normal(), 1e-9 * random.normal());
    return pose;
  }

 private:
  Camera camera_;
  LabelSpace label_space_;
  GroundTruth ground_truth_;
};

}  // namespace hydrabench
