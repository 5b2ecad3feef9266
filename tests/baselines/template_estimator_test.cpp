// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/template_estimator.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/geometry/mesh_io.h"
#include "tests/support/miniature_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace id = miniature_label;
using Eigen::Vector3d;

/// A couch of 1.8 x 0.8 x 0.7 m at a slant, seen from above one of its corners.
class TemplateOfAView : public ::testing::Test {
 protected:
  TemplateOfAView() {
    writeMesh(folder_ / "couch.ply", standingBox(1.8, 0.8, 0.7));
    MiniatureWorld world;
    world.addRoom(8, 8, 2.5);
    world.add(transformed(pose(0.5, -0.3, 0, 0.4), standingBox(1.8, 0.8, 0.7)), id::kCouch, 1);
    const MiniatureWorld::Path path = orbitPath({0.5, -0.3, 0.3}, 2.2, 1.8, 1);
    const Frame frame = world.frame(path.front().T_world_camera, path.front().stamp_ns);
    view_ = {.stamp_ns = frame.stamp_ns,
             .camera = frame.camera,
             .T_world_camera = frame.T_world_camera,
             .color = {},
             .depth = frame.depth,
             .mask = Image<std::uint8_t>(frame.camera.width, frame.camera.height),
             .label = id::kCouch};
    for (std::size_t i = 0; i < view_.mask.size(); ++i) {
      view_.mask.data()[i] = frame.instances.data()[i] == 1 ? 1 : 0;
    }
  }

  ShapeOutcome estimate(const ShapeObservation& view) const {
    TemplateEstimator::Config config;
    config.trim = 0;
    config.templates = {TemplateCad::publishedRules("couch")};
    config.templates[0].mesh = folder_ / "couch.ply";
    return TemplateEstimator(config, miniatureLabelSpace()).estimate(view, {}, 0);
  }

  TemporaryFolder folder_;
  ShapeObservation view_;
};

TEST_F(TemplateOfAView, StandsWhereTheObjectDoes) {
  const ShapeOutcome outcome = estimate(view_);
  ASSERT_TRUE(outcome.estimate) << outcome.failure;
  const Mesh world = transformed(view_.T_world_camera * outcome.estimate->T_camera_object,
                                 scaled(outcome.estimate->scale, outcome.estimate->mesh));
  const Aabb expected = bounds(transformed(pose(0.5, -0.3, 0, 0.4), standingBox(1.8, 0.8, 0.7)));
  EXPECT_LT((bounds(world).center() - expected.center()).norm(), 0.04);
  EXPECT_LT((bounds(world).sizes() - expected.sizes()).norm(), 0.06);
  ASSERT_EQ(outcome.times.stages().size(), 2u);
  EXPECT_EQ(outcome.times.stages()[1].name, "place");
}

TEST_F(TemplateOfAView, SaysWhyThereIsNone) {
  ShapeObservation other = view_;
  other.label = id::kPlant;
  EXPECT_EQ(estimate(other).failure, "no template of its class");
  ShapeObservation blind = view_;
  std::fill(blind.depth.begin(), blind.depth.end(), 0.0f);
  EXPECT_EQ(estimate(blind).failure, "its points span no area");
  ShapeObservation far = view_;  // four times as large
  for (float& depth : far.depth) depth *= 4;
  EXPECT_EQ(estimate(far).failure, "its extents are not those of its class");
}

TEST_F(TemplateOfAView, ReadsItsTemplatesAsTheMethodDoes) {
  writeText(folder_ / "estimator.yaml",
            "trim: 0.1\nplacement: {z: lowest}\ntemplates: [{class: couch, mesh: couch.ply}]\n");
  ConfigReader reader(ConfigDocument::fromFile(folder_ / "estimator.yaml"));
  TemplateEstimator::Config config;
  read(reader, config);
  reader.finish();
  EXPECT_EQ(config.trim, 0.1);
  EXPECT_EQ(config.placement.z, "lowest");
  ASSERT_EQ(config.templates.size(), 1u);
  EXPECT_EQ(config.templates[0].max_length_m, 3.0);  // SlideSLAM's of the class
}

}  // namespace
}  // namespace hydrabench
