// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/simulated_dataset.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/office_labels.h"

namespace hydrabench {
namespace {

/// The quick world with a few objects and a small camera.
SimulatedConfig smallWorld(const std::string& preset = "default") {
  SimulatedConfig config = SimulatedConfig::forWorld("quick", preset);
  config.office.chairs = 3;
  config.office.couches = 1;
  config.office.plants = 0;
  config.office.bins = 1;
  config.office.computers = 1;
  config.sensor.camera = {160, 120, 92, 92, 80, 60};
  return config;
}

void expectEqual(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.stamp_ns, b.stamp_ns);
  EXPECT_EQ(a.T_world_camera.matrix(), b.T_world_camera.matrix());
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.instances, b.instances);
  EXPECT_EQ(a.instance_labels, b.instance_labels);
}

TEST(SimulatedDataset, GivesTheSameBytesForAnyNumberOfThreadsAndInAnyOrder) {
  setNumThreads(1);
  const SimulatedDataset one(smallWorld("hard"));
  const std::vector<std::size_t> chosen = {0, 150, 299};
  std::vector<Frame> frames;
  for (const std::size_t index : chosen) frames.push_back(one.frame(index));
  const GroundTruth truth = one.groundTruth();
  for (const int threads : {2, 7}) {
    setNumThreads(threads);
    for (std::size_t i = chosen.size(); i-- > 0;) expectEqual(one.frame(chosen[i]), frames[i]);
  }
  // The world itself, made by seven threads.
  const SimulatedDataset many(smallWorld("hard"));
  for (std::size_t i = chosen.size(); i-- > 0;) expectEqual(many.frame(chosen[i]), frames[i]);
  const GroundTruth& other = many.groundTruth();
  EXPECT_EQ(other.scene_mesh.vertices, truth.scene_mesh.vertices);
  ASSERT_EQ(other.objects.size(), truth.objects.size());
  for (std::size_t i = 0; i < truth.objects.size(); ++i) {
    EXPECT_EQ(other.objects[i].visible_fraction, truth.objects[i].visible_fraction);
    EXPECT_EQ(other.objects[i].name, truth.objects[i].name);
  }
  setNumThreads(0);
}

TEST(SimulatedDataset, FramesAndGroundTruthFitTogether) {
  const SimulatedDataset dataset(smallWorld("clean"));
  EXPECT_EQ(dataset.numFrames(), 300u);
  EXPECT_EQ(dataset.name(), "office_quick_clean");
  const GroundTruth& truth = dataset.groundTruth();
  EXPECT_EQ(truth.rooms.size(), 3u);
  ASSERT_EQ(truth.trajectory.size(), dataset.numFrames());
  std::set<ObjectId> ids;
  for (const GroundTruthObject& object : truth.objects) {
    ids.insert(object.id);
    EXPECT_FALSE(object.mesh->empty());
    const LabelSpace::Entry* entry = dataset.labelSpace().find(object.label);
    ASSERT_TRUE(entry);
    EXPECT_EQ(object.scored, entry->is_scored) << object.name;
    EXPECT_GE(object.visible_fraction, 0);
    EXPECT_LE(object.visible_fraction, 1);
  }
  EXPECT_EQ(ids.size(), truth.objects.size());
  EXPECT_FALSE(ids.contains(0));

  // A clean pixel of an object, taken back to the world, lies on the surface of an object of that
  // label.
  int checked = 0;
  for (const std::size_t index : {20u, 120u, 220u}) {
    const Frame frame = dataset.frame(index);
    EXPECT_EQ(frame.T_world_camera.matrix(), truth.trajectory[index].T_world_camera.matrix());
    for (int v = 5; v < frame.depth.height(); v += 9) {
      for (int u = 5; u < frame.depth.width(); u += 9) {
        if (frame.depth(u, v) == 0 || frame.instances(u, v) == kNoInstance) continue;
        const Eigen::Vector3d p =
            frame.T_world_camera * frame.camera.backproject(u, v, frame.depth(u, v));
        double nearest = 1e9;
        for (const SceneObject& object : dataset.scene().objects) {
          if (object.label != frame.labels(u, v)) continue;
          nearest = std::min(
              nearest, std::abs(object.shape->sdf->value(object.T_world_object.inverse() * p)));
        }
        EXPECT_LT(nearest, 0.01);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(SimulatedDataset, DriftMovesTheReportedPosesOnly) {
  SimulatedConfig config = smallWorld("clean");
  config.odometry.translation_m_per_sqrt_m = 0.1;
  const SimulatedDataset dataset(config);
  const std::size_t last = dataset.numFrames() - 1;
  const Frame frame = dataset.frame(last);
  const Transform& truth = dataset.groundTruth().trajectory[last].T_world_camera;
  EXPECT_GT((frame.T_world_camera.translation() - truth.translation()).norm(), 0.01);
  EXPECT_EQ(truth.matrix(), dataset.trajectory()[last].T_world_camera.matrix());
}

SimulatedConfig configFrom(const std::string& yaml) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "office.yaml"));
  SimulatedConfig config;
  read(reader, config);
  reader.finish();
  return config;
}

TEST(SimulatedConfig, PresetFillsInWhatTheFileDoesNotSay) {
  const SimulatedConfig config =
      configFrom("world: quick\npreset: hard\nmasks: {miss_probability: 0.5}\n");
  EXPECT_EQ(config.office.world, "quick");
  EXPECT_EQ(config.trajectory.numFrames(), 300u);
  EXPECT_EQ(config.sensor.masks.miss_probability, 0.5);
  EXPECT_EQ(config.sensor.masks.merge_probability,
            RgbdSensorConfig::hard().masks.merge_probability);
  EXPECT_GT(config.odometry.yaw_deg_per_sqrt_m, 0);
}

TEST(SimulatedConfig, EmptyFileIsTheDefaultOffice) {
  const SimulatedConfig config = configFrom("{}");
  EXPECT_EQ(config.trajectory.numFrames(), 2000u);
  EXPECT_EQ(config.sensor.camera, (Camera{720, 480, 415.7, 415.7, 360, 240}));
  EXPECT_EQ(
      config.office.chairs + config.office.couches + config.office.plants + config.office.bins, 88);
}

TEST(SimulatedConfig, NamesEveryFault) {
  try {
    configFrom("world: moon\ntrajectory: {rate_hz: -1}\nmasks: {mis_probability: 0.1}\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("moon"));
    EXPECT_THAT(error.what(), testing::HasSubstr("rate_hz"));
    EXPECT_THAT(error.what(), testing::HasSubstr("miss_probability"));
  }
}

}  // namespace
}  // namespace hydrabench
