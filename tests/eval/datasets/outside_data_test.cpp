// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Recordings and worlds by others. They are not part of the project: the tests look for them below
// HYDRABENCH_DATA and skip where they are absent.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/datasets/open_dataset.h"
#include "eval/simulation/office_labels.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;

fs::path dataRoot() {
  const char* variable = std::getenv("HYDRABENCH_DATA");
  return variable ? variable : "";
}

OpenedDataset open(const char* config, std::vector<std::string> overrides = {}) {
  overrides.push_back("root=" + fs::absolute(dataRoot()).string());
  return openDataset(fs::path(HYDRABENCH_SOURCE_DIR) / "configs/datasets" / config, overrides);
}

#define SKIP_WITHOUT(folder)                                                              \
  if (!fs::exists(dataRoot() / (folder))) {                                               \
    GTEST_SKIP() << "no " << (dataRoot() / (folder)).string() << "; set HYDRABENCH_DATA"; \
  }

/// Pixel (u, v) of a frame in the world.
Eigen::Vector3d inWorld(const Frame& frame, int u, int v) {
  return frame.T_world_camera * frame.camera.backproject(u, v, frame.depth(u, v));
}

TEST(RedKitchen, HundredFramesWithPosesAndRoughInstances) {
  SKIP_WITHOUT("rgbd/7scenes");
  const OpenedDataset opened = open("redkitchen.yaml");
  const Dataset& dataset = *opened.dataset;
  EXPECT_EQ(dataset.numFrames(), 100u);
  EXPECT_EQ(dataset.camera().width, 640);
  EXPECT_EQ(dataset.camera().fx, 585);
  EXPECT_FALSE(dataset.hasGroundTruth());
  std::size_t with_chairs = 0;
  for (const std::size_t i : {0u, 40u, 99u}) {
    const Frame frame = dataset.frame(i);
    EXPECT_EQ(frame.stamp_ns, std::llround(static_cast<double>(5 * i) * 1e9 / 30));
    float largest = 0;
    for (const float z : frame.depth) largest = std::max(largest, z);
    EXPECT_GT(largest, 1);
    EXPECT_LT(largest, 20) << "65535 means no measurement";
    for (const auto& [id, label] : frame.instance_labels) with_chairs += label == 5;
  }
  EXPECT_GT(with_chairs, 0u);
}

TEST(RedKitchen, AlignedWorldHasItsFloorAtZero) {
  SKIP_WITHOUT("rgbd/7scenes");
  const OpenedDataset opened = open("redkitchen.yaml");
  // The lowest percentile of all heights is the floor.
  std::vector<double> heights;
  for (std::size_t i = 0; i < 100; i += 10) {
    const Frame frame = opened.dataset->frame(i);
    EXPECT_GT(frame.T_world_camera.translation().z(), 0.5);
    for (int v = 0; v < frame.depth.height(); v += 8) {
      for (int u = 0; u < frame.depth.width(); u += 8) {
        if (frame.depth(u, v) > 0) heights.push_back(inWorld(frame, u, v).z());
      }
    }
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_NEAR(heights[heights.size() / 50], 0, 0.15);
}

TEST(ApcShelf, AnnotatedAndPredictedMasksAgreeRoughly) {
  SKIP_WITHOUT("instances/apc2016_shelf_scene0000");
  const OpenedDataset annotated = open("apc_shelf.yaml");
  const OpenedDataset predicted = open("apc_shelf_predicted.yaml");
  EXPECT_EQ(annotated.dataset->numFrames(), 15u);
  EXPECT_EQ(annotated.dataset->labelSpace().nameOf(132), "kleenex_tissue_box");
  EXPECT_FALSE(annotated.dataset->hasGroundTruth());
  std::size_t both = 0, either = 0;
  for (std::size_t f = 0; f < 15; f += 7) {
    const Frame a = annotated.dataset->frame(f);
    const Frame b = predicted.dataset->frame(f);
    EXPECT_TRUE(a.depth == b.depth);
    EXPECT_FALSE(a.instance_labels.empty());
    for (std::size_t i = 0; i < a.instances.size(); ++i) {
      const InstanceId x = a.instances.data()[i];
      const InstanceId y = b.instances.data()[i];
      both += x != kNoInstance && x == y;
      either += x != kNoInstance || y != kNoInstance;
    }
  }
  ASSERT_GT(either, 0u);
  const double iou = static_cast<double>(both) / static_cast<double>(either);
  EXPECT_GT(iou, 0.1);
  EXPECT_LT(iou, 0.999) << "the predicted masks are noisy";
}

TEST(ApcShelf, ViewsMeetOnTheShelf) {
  SKIP_WITHOUT("instances/apc2016_shelf_scene0000");
  const OpenedDataset opened = open("apc_shelf.yaml");
  // The mean position of an object must be about the same from every view that shows it.
  std::vector<Eigen::Vector3d> means;
  for (std::size_t f = 0; f < 15; ++f) {
    const Frame frame = opened.dataset->frame(f);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (int v = 0; v < frame.depth.height(); ++v) {
      for (int u = 0; u < frame.depth.width(); ++u) {
        if (frame.instances(u, v) != 132 || frame.depth(u, v) <= 0) continue;
        sum += inWorld(frame, u, v);
        ++count;
      }
    }
    if (count > 500) means.push_back(sum / count);
  }
  ASSERT_GT(means.size(), 3u);
  for (const Eigen::Vector3d& mean : means) EXPECT_LT((mean - means[0]).norm(), 0.1);
}

TEST(ServicesimOffice, ItsObjectsAreScoredButForPartitions) {
  SKIP_WITHOUT("scenes/servicesim_office.json");
  // A short drive with a small camera.
  const OpenedDataset opened = open("servicesim_office.yaml",
                                    {"trajectory.duration_s=160", "trajectory.rate_hz=2",
                                     "camera.width_px=90", "camera.height_px=60", "camera.fx_px=52",
                                     "camera.fy_px=52", "camera.cx_px=45", "camera.cy_px=30"});
  const Dataset& dataset = *opened.dataset;
  std::map<Label, int> scored;
  int unscored_computers = 0;
  for (const GroundTruthObject& object : dataset.groundTruth().objects) {
    scored[object.label] += object.scored;
    unscored_computers += object.label == office_label::kComputer && !object.scored;
    EXPECT_NE(object.label, office_label::kCubicle) << object.name;
  }
  EXPECT_EQ(scored[office_label::kChair], 74);
  EXPECT_EQ(scored[office_label::kCouch], 3);
  EXPECT_EQ(scored[office_label::kBin], 6);
  EXPECT_EQ(scored[office_label::kDesk], 0);
  EXPECT_EQ(unscored_computers, 17);
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < dataset.numFrames(); i += 20) {
    const Frame frame = dataset.frame(i);
    pixels += static_cast<std::size_t>(
        std::count_if(frame.depth.begin(), frame.depth.end(), [](float z) { return z > 0; }));
  }
  EXPECT_GT(pixels, dataset.numFrames() / 20 * 90 * 60 / 3);
}

}  // namespace
}  // namespace hydrabench
