// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/shape_oracle.h"

#include <gtest/gtest.h>

#include "tests/eval/oracles/two_boxes.h"

namespace hydrabench {
namespace {

ShapeObservation observationOf(int u_begin, int u_end) {
  ShapeObservation view;
  view.stamp_ns = 7;
  view.camera = smallCamera();
  view.T_world_camera = twoBoxes().trajectory.front().T_world_camera;
  view.mask = Image<std::uint8_t>(60, 60);
  for (int v = 20; v < 30; ++v) {
    for (int u = u_begin; u < u_end; ++u) view.mask(u, v) = 1;
  }
  return view;
}

const ShapeOracle& oracle() {
  static const ShapeOracle instance(std::make_shared<const TrueInstances>(twoBoxes()));
  return instance;
}

/// Box of an estimate in the world.
Aabb worldBox(const ShapeEstimate& estimate, const Transform& T_world_camera) {
  return bounds(transformed(T_world_camera * estimate.T_camera_object,
                            scaled(estimate.scale, estimate.mesh)));
}

TEST(ShapeOracle, PutsTheTrueMeshWhereItIs) {
  const ShapeObservation view = observationOf(2, 18);
  const ShapeOutcome outcome = oracle().estimate(view, {}, 1);
  ASSERT_TRUE(outcome.estimate);
  EXPECT_TRUE(outcome.failure.empty());
  const Aabb box = worldBox(*outcome.estimate, view.T_world_camera);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(3, 0.5, -1), 1e-12)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(4, 1.5, 1), 1e-12)) << box.max().transpose();
}

TEST(ShapeOracle, NormalisesTheLargestHalfExtentToOne) {
  const ShapeOutcome outcome = oracle().estimate(observationOf(2, 18), {}, 1);
  ASSERT_TRUE(outcome.estimate);
  EXPECT_DOUBLE_EQ(outcome.estimate->scale, 1);  // the chair is 2 m high
  const Aabb box = bounds(outcome.estimate->mesh);
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(0.5, 0.5, 1)));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(-0.5, -0.5, -1)));
}

TEST(ShapeOracle, TakesTheObjectThatMostOfTheMaskShows) {
  const ShapeOutcome outcome = oracle().estimate(observationOf(15, 60), {}, 1);  // 5 against 20
  ASSERT_TRUE(outcome.estimate);
  EXPECT_DOUBLE_EQ(outcome.estimate->scale, 0.5);  // the bin
}

TEST(ShapeOracle, IsRightInTheCameraFrameWhateverOdometrySays) {
  ShapeObservation drifted = observationOf(2, 18);
  drifted.T_world_camera.translation() += Eigen::Vector3d(5, 5, 0);
  const ShapeOutcome outcome = oracle().estimate(drifted, {}, 1);
  ASSERT_TRUE(outcome.estimate);
  // 3.5 m ahead and 1 m to the left.
  EXPECT_TRUE(
      outcome.estimate->T_camera_object.translation().isApprox(Eigen::Vector3d(-1, 0, 3.5), 1e-12));
}

TEST(ShapeOracle, SaysSoWhereTheMaskShowsNoObject) {
  for (const ShapeObservation& view : {observationOf(25, 35), observationOf(0, 0)}) {
    const ShapeOutcome outcome = oracle().estimate(view, {}, 1);
    EXPECT_FALSE(outcome.estimate);
    EXPECT_EQ(outcome.failure, ShapeOracle::kNoObject);
  }
}

}  // namespace
}  // namespace hydrabench
