// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/view_oracle.h"

#include <gtest/gtest.h>

#include "tests/eval/oracles/two_boxes.h"

namespace hydrabench {
namespace {

/// Puts a shape half a metre before the camera of the view it is shown.
class Parrot : public ShapeEstimator {
 public:
  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t) const override {
    shown = best.stamp_ns;
    num_others = others.size();
    ShapeOutcome outcome;
    outcome.estimate.emplace();
    outcome.estimate->T_camera_object.translation().z() = 0.5;
    outcome.estimate->mesh = sphereMesh({0, 0, 0}, 0.1, 0);
    return outcome;
  }
  int maxOtherViews() const override { return 1; }
  mutable std::int64_t shown = -1;
  mutable std::size_t num_others = 0;
};

/// The camera at a place, looking at the chair; the mask is all that shows it.
ShapeObservation viewFrom(const TrueInstances& truth, std::int64_t stamp_ns,
                          const Eigen::Vector3d& eye, std::int32_t object = 0) {
  ShapeObservation view;
  view.stamp_ns = stamp_ns;
  view.camera = smallCamera();
  view.T_world_camera =
      lookAt(eye, truth.objects()[0].T_world_object.translation() + Eigen::Vector3d(0, 0, 1));
  view.mask = Image<std::uint8_t>(60, 60);
  const Image<std::int32_t> seen = truth.render(view.camera, view.T_world_camera);
  for (std::size_t i = 0; i < seen.size(); ++i) view.mask.data()[i] = seen.data()[i] == object;
  return view;
}

TEST(ViewOracle, ShowsTheViewInWhichMostOfTheObjectIsSeen) {
  const auto truth = std::make_shared<const TrueInstances>(twoBoxes());
  const auto parrot = std::make_shared<Parrot>();
  const ViewOracle oracle(parrot, truth);
  EXPECT_EQ(oracle.maxOtherViews(), 15);
  // One side of the chair, then two sides and the top.
  const ShapeObservation front = viewFrom(*truth, 100, {-1, 1, 0});
  const ShapeObservation corner = viewFrom(*truth, 101, {0, 4, 3});
  const std::vector<ShapeObservation> others = {corner, front};
  const ShapeOutcome outcome = oracle.estimate(front, others, 1);
  EXPECT_EQ(parrot->shown, 101);
  EXPECT_EQ(parrot->num_others, 1u);
  ASSERT_TRUE(outcome.estimate);
  // The shape stays where it was put: before the camera at the corner.
  const Eigen::Vector3d place =
      front.T_world_camera * outcome.estimate->T_camera_object.translation();
  const Eigen::Vector3d expected = corner.T_world_camera * Eigen::Vector3d(0, 0, 0.5);
  EXPECT_TRUE(place.isApprox(expected, 1e-12)) << place.transpose();
}

TEST(ViewOracle, PassesOverViewsWhoseMaskShowsAnotherObject) {
  const auto truth = std::make_shared<const TrueInstances>(twoBoxes());
  const auto parrot = std::make_shared<Parrot>();
  const ShapeObservation front = viewFrom(*truth, 100, {-1, 1, 0});
  const std::vector<ShapeObservation> others = {viewFrom(*truth, 101, {0, 4, 3}, 1)};
  ViewOracle(parrot, truth).estimate(front, others, 1);
  EXPECT_EQ(parrot->shown, 100);
}

TEST(ViewOracle, KeepsTheBestViewWhereItsMaskShowsNoObject) {
  const auto truth = std::make_shared<const TrueInstances>(twoBoxes());
  const auto parrot = std::make_shared<Parrot>();
  ShapeObservation nothing = viewFrom(*truth, 100, {-1, 1, 0});
  nothing.mask.fill(0);
  const std::vector<ShapeObservation> others = {viewFrom(*truth, 101, {0, 4, 3})};
  ViewOracle(parrot, truth).estimate(nothing, others, 1);
  EXPECT_EQ(parrot->shown, 100);
}

}  // namespace
}  // namespace hydrabench
