// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/latent_flow_estimator.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/latent_flow/latent_flow_model.h"
#include "core/shape/latent_flow/torch_latent_flow_model.h"
#include "core/shape/scale_alignment.h"
#include "core/types/error.h"
#include "tests/core/shape/crisp/ball_view.h"
#include "tests/core/shape/latent_flow/toy_network.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kTurn = 0.4;

/// Knows the ball: finds its frame, turned a little, and a shape that has a bump along x.
class BallModel : public LatentFlowModel {
 public:
  double scale = kBallRadius;
  SdfField field = [](std::span<const Eigen::Vector3f> points, std::span<float> values) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = std::min(points[i].norm() - 0.95f,
                           (points[i] - Eigen::Vector3f(0.9f, 0, 0)).norm() - 0.2f);
    }
  };
  mutable int steps_asked = 0;
  mutable int samples_asked = 0;
  mutable double guidance_asked = 0;

  LocalFrame drawPose(const PointInput&, int samples, int steps, std::uint64_t) const override {
    samples_asked = samples;
    steps_asked = steps;
    LocalFrame frame;
    frame.center = viewOfABall().T_world_camera.linear() * kBallCenter;
    frame.bearing = kTurn;
    frame.scale = scale;
    return frame;
  }
  SdfField drawShape(const ViewGrid&, double guidance, int, std::uint64_t) const override {
    guidance_asked = guidance;
    return field;
  }
};

ShapeOutcome estimateWith(const BallModel& model, const ShapeObservation& view) {
  return LatentFlowEstimator(std::make_shared<BallModel>(model), {}).estimate(view, {}, 1);
}

TEST(LatentFlowEstimator, PlacesTheShapeUprightWhereItsFrameIs) {
  const ShapeObservation view = viewOfABall();
  const ShapeOutcome outcome = estimateWith({}, view);
  ASSERT_TRUE(outcome.estimate) << outcome.failure;
  const ShapeEstimate& estimate = *outcome.estimate;
  EXPECT_NEAR(estimate.scale, kBallRadius, 1e-9);
  EXPECT_LE((estimate.T_camera_object.translation() - kBallCenter).norm(), 1e-9);
  const Eigen::Matrix3d R_world_object =
      view.T_world_camera.linear() * estimate.T_camera_object.linear();
  EXPECT_LE((R_world_object.col(2) - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_NEAR(std::atan2(R_world_object(1, 0), R_world_object(0, 0)), kTurn, 1e-9);
  // The bump reaches to 1.1 along x of the object, and no other side does.
  const Aabb box = bounds(estimate.mesh);
  EXPECT_NEAR(box.max().x(), 1.1, 0.02);
  EXPECT_NEAR(box.min().x(), -0.95, 0.02);
  EXPECT_NEAR(box.max().z(), 0.95, 0.02);
  EXPECT_GE(estimate.inlier_ratio, 0.9);  // the measured ball has a radius of 1, this one of 0.95
}

TEST(LatentFlowEstimator, HandsItsKeysOn) {
  const auto model = std::make_shared<BallModel>();
  LatentFlowEstimator::Config config;
  config.steps = 4;
  config.pose_samples = 3;
  config.guidance = 2.5;
  LatentFlowEstimator(model, config).estimate(viewOfABall(), {}, 1);
  EXPECT_EQ(model->steps_asked, 4);
  EXPECT_EQ(model->samples_asked, 3);
  EXPECT_EQ(model->guidance_asked, 2.5);
}

TEST(LatentFlowEstimator, IsAFailureWhereTheViewOrTheNetworkIsNoGood) {
  ShapeObservation empty = viewOfABall();
  std::fill(empty.mask.begin(), empty.mask.end(), std::uint8_t{0});
  EXPECT_EQ(estimateWith({}, empty).failure, "mask is empty");
  BallModel model;
  model.scale = kNan;
  EXPECT_EQ(estimateWith(model, viewOfABall()).failure, "network output is not finite");
  model.scale = 50;
  EXPECT_EQ(estimateWith(model, viewOfABall()).failure, "size of the object is not plausible");
  model = {};
  model.field = [](std::span<const Eigen::Vector3f>, std::span<float> values) {
    std::fill(values.begin(), values.end(), 1.0f);
  };
  EXPECT_EQ(estimateWith(model, viewOfABall()).failure, "shape has no surface");
  model.field = [](std::span<const Eigen::Vector3f>, std::span<float> values) {
    std::fill(values.begin(), values.end(), kNan);
  };
  EXPECT_EQ(estimateWith(model, viewOfABall()).failure, "network output is not finite");
}

TEST(LatentFlowEstimator, GivesTheSameMeshForAnyNumberOfThreads) {
  LatentFlowEstimator::Config config;
  config.steps = 3;
  config.pose_samples = 2;
  config.mesh.resolution = 32;
  // Random weights: of a few networks some draw a surface, and it is the same.
  int compared = 0;
  for (std::uint64_t weights = 1; weights <= 12; ++weights) {
    const LatentFlowEstimator estimator(makeLatentFlowModel(toyNetwork(weights), "cpu"), config);
    std::vector<ShapeOutcome> outcomes;
    for (const int threads : {1, 2}) {
      setNumThreads(threads);
      outcomes.push_back(estimator.estimate(viewOfABall(), {}, 9));
    }
    setNumThreads(0);
    ASSERT_EQ(outcomes[0].failure, outcomes[1].failure);
    if (!outcomes[0].estimate) continue;
    ++compared;
    EXPECT_EQ(outcomes[0].estimate->mesh.vertices, outcomes[1].estimate->mesh.vertices);
    EXPECT_EQ(outcomes[0].estimate->T_camera_object.matrix(),
              outcomes[1].estimate->T_camera_object.matrix());
  }
  EXPECT_GE(compared, 1);
}

TEST(LatentFlowEstimator, MayHaveItsScaleCorrectedByDepth) {
  auto model = std::make_shared<BallModel>();
  model->scale = 0.7 * kBallRadius;  // smaller, in the same place
  model->field = [](std::span<const Eigen::Vector3f> points, std::span<float> values) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i].norm() - 1;
  };
  const auto plain = std::make_shared<LatentFlowEstimator>(model, LatentFlowEstimator::Config());
  ScaleAlignmentConfig alignment;
  alignment.enabled = true;
  const ShapeOutcome outcome = ScaleAligned(plain, alignment).estimate(viewOfABall(), {}, 1);
  ASSERT_TRUE(outcome.estimate) << outcome.failure;
  // The nearer half of the small ball is rendered deeper than measured: the factor pulls it nearer.
  EXPECT_LT(outcome.estimate->scale, 0.7 * kBallRadius);
  EXPECT_NEAR(outcome.estimate->scale / (0.7 * kBallRadius),
              outcome.estimate->T_camera_object.translation().norm() / kBallCenter.norm(), 1e-9);
}

TEST(LatentFlowEstimatorConfig, NeedsAModel) {
  EXPECT_THAT(messageOf<InputError>([] { LatentFlowEstimator(LatentFlowEstimator::Config()); }),
              ::testing::HasSubstr("model: missing"));
}

}  // namespace
}  // namespace hydrabench
