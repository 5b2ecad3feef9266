// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_estimator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/crisp_model.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/core/shape/crisp/ball_view.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Knows the ball: object coordinates are in radii, its z axis points up.
class BallModel : public CrispModel {
 public:
  SdfField field = [](std::span<const Eigen::Vector3f> points, std::span<float> values) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i].norm() - 1;
  };
  std::function<void(CrispPrediction&)> spoil = [](CrispPrediction&) {};
  NocsFreedom freedom_allowed = NocsFreedom::kUpright;
  bool wants_color = false;

  CrispPrediction predict(const ShapeObservation& view, std::uint64_t) const override {
    CrispPrediction prediction;
    prediction.field = field;
    for (int v = 0; v < view.camera.height; ++v) {
      for (int u = 0; u < view.camera.width; ++u) {
        if (view.mask(u, v) == 0 || !(view.depth(u, v) > 0)) continue;
        const Eigen::Vector3d point = view.camera.backproject(u, v, view.depth(u, v));
        prediction.points.push_back(point);
        prediction.nocs.emplace_back(view.T_world_camera.linear() * (point - kBallCenter) /
                                     kBallRadius);
      }
    }
    spoil(prediction);
    return prediction;
  }
  NocsFreedom freedom() const override { return freedom_allowed; }
  double cubeHalfSide() const override { return 1.1; }
  bool needsColor() const override { return wants_color; }
};

ShapeOutcome estimateWith(const BallModel& model, const ShapeObservation& view,
                          const CrispEstimator::Config& config = {}) {
  return CrispEstimator(std::make_shared<BallModel>(model), config).estimate(view, {}, 1);
}

void expectFailure(const ShapeOutcome& outcome, const std::string& phrase) {
  EXPECT_FALSE(outcome.estimate);
  EXPECT_EQ(outcome.failure, phrase);
}

TEST(CrispEstimator, FindsABallWhereItIs) {
  for (const NocsFreedom freedom : {NocsFreedom::kUpright, NocsFreedom::kSimilarity}) {
    BallModel model;
    model.freedom_allowed = freedom;
    const ShapeObservation view = viewOfABall();
    const ShapeOutcome outcome = estimateWith(model, view);
    ASSERT_TRUE(outcome.estimate) << outcome.failure;
    EXPECT_EQ(outcome.failure, "");
    EXPECT_NEAR(outcome.estimate->scale, kBallRadius, 1e-6);
    EXPECT_LE((outcome.estimate->T_camera_object.translation() - kBallCenter).norm(), 1e-6);
    EXPECT_TRUE((view.T_world_camera.linear() * outcome.estimate->T_camera_object.linear())
                    .isIdentity(1e-6));
    EXPECT_TRUE(analyzeTopology(outcome.estimate->mesh).watertight());
    EXPECT_NEAR(bounds(outcome.estimate->mesh).max().z(), 1, 1e-3);
    EXPECT_EQ(outcome.estimate->inlier_ratio, 1);
  }
}

TEST(CrispEstimator, TimesItsStages) {
  const ShapeOutcome outcome = estimateWith({}, viewOfABall());
  std::vector<std::string> names;
  for (const StageTimes::Stage& stage : outcome.times.stages()) names.push_back(stage.name);
  EXPECT_EQ(names, (std::vector<std::string>{"network", "pose", "mesh"}));
}

TEST(CrispEstimator, IsTheSameForAnyNumberOfThreads) {
  const ShapeObservation view = viewOfABall();
  setNumThreads(1);
  const ShapeOutcome alone = estimateWith({}, view);
  setNumThreads(4);
  const ShapeOutcome together = estimateWith({}, view);
  setNumThreads(0);
  ASSERT_TRUE(alone.estimate && together.estimate);
  EXPECT_EQ(alone.estimate->mesh.vertices, together.estimate->mesh.vertices);
  EXPECT_EQ(alone.estimate->T_camera_object.matrix(), together.estimate->T_camera_object.matrix());
}

struct BadView {
  const char* name;
  std::function<void(ShapeObservation&)> spoil;
  const char* failure;
};
class CrispEstimatorBadView : public ::testing::TestWithParam<BadView> {};
INSTANTIATE_TEST_SUITE_P(
    Views, CrispEstimatorBadView,
    ::testing::Values(
        BadView{"ZeroFocalLength", [](auto& v) { v.camera.fx = 0; }, "camera is not valid"},
        BadView{"NanFocalLength", [](auto& v) { v.camera.fy = kNan; }, "camera is not valid"},
        BadView{"NegativeFocalLength", [](auto& v) { v.camera.fx = -80; }, "camera is not valid"},
        BadView{"NanCenter", [](auto& v) { v.camera.cx = kNan; }, "camera is not valid"},
        BadView{"NothingAtAll", [](auto& v) { v = {}; }, "camera is not valid"},
        BadView{"NanPose", [](auto& v) { v.T_world_camera(0, 3) = kNan; },
                "camera pose is not finite"},
        BadView{"SmallerMask", [](auto& v) { v.mask = Image<std::uint8_t>(40, 60, 1); },
                "image sizes differ"},
        BadView{"NoDepthImage", [](auto& v) { v.depth = {}; }, "image sizes differ"},
        BadView{"LargerColor", [](auto& v) { v.color = Image<Rgb>(81, 60); }, "image sizes differ"},
        BadView{"EmptyMask", [](auto& v) { v.mask.fill(0); }, "mask is empty"},
        BadView{"AllNanDepth", [](auto& v) { v.depth.fill(kNan); },
                "fewer than 5 pixels with depth in the mask"},
        BadView{"InfiniteDepth",
                [](auto& v) { v.depth.fill(std::numeric_limits<float>::infinity()); },
                "fewer than 5 pixels with depth in the mask"},
        BadView{"FourPixels",
                [](auto& v) {
                  v.mask.fill(0);
                  for (int u = 40; u < 44; ++u) v.mask(u, 30) = 1;
                },
                "fewer than 5 pixels with depth in the mask"}),
    [](const auto& test) { return test.param.name; });

TEST_P(CrispEstimatorBadView, IsAFailureWithAPhrase) {
  ShapeObservation view = viewOfABall();
  GetParam().spoil(view);
  expectFailure(estimateWith({}, view), GetParam().failure);
}

TEST(CrispEstimator, NeedsColorOnlyWhereTheModelDoes) {
  ShapeObservation view = viewOfABall();
  view.color = {};
  BallModel model;
  EXPECT_TRUE(estimateWith(model, view).estimate);
  model.wants_color = true;
  expectFailure(estimateWith(model, view), "no color image");
}

TEST(CrispEstimator, TakesFiveDepthPixels) {
  ShapeObservation view = viewOfABall();
  view.mask.fill(0);
  for (const auto& [u, v] : {std::pair(36, 24), {50, 24}, {43, 31}, {36, 38}, {50, 38}}) {
    view.mask(u, v) = 1;
  }
  EXPECT_TRUE(estimateWith({}, view).estimate);
}

TEST(CrispEstimator, RejectsObjectCoordinatesThatAreNotFinite) {
  BallModel model;
  model.spoil = [](CrispPrediction& p) { p.nocs[7].y() = kNan; };
  expectFailure(estimateWith(model, viewOfABall()), "network output is not finite");
}

TEST(CrispEstimator, RejectsAFieldThatIsNotFinite) {
  BallModel model;
  model.field = [](std::span<const Eigen::Vector3f> points, std::span<float> values) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = points[i].x() > 0.99f ? kNan : points[i].norm() - 1;
    }
  };
  expectFailure(estimateWith(model, viewOfABall()), "network output is not finite");
}

TEST(CrispEstimator, RejectsAFieldWithoutSurface) {
  BallModel model;
  model.field = [](std::span<const Eigen::Vector3f>, std::span<float> values) {
    std::fill(values.begin(), values.end(), 0.4f);
  };
  expectFailure(estimateWith(model, viewOfABall()), "shape has no surface");
}

TEST(CrispEstimator, RejectsPointsThatDoNotAgree) {
  BallModel model;
  model.spoil = [](CrispPrediction& p) {
    for (std::size_t i = 0; i < p.nocs.size(); ++i) {
      Random random(5, i);
      for (int axis = 0; axis < 3; ++axis) p.nocs[i][axis] = random.uniform(-1, 1);
    }
  };
  CrispEstimator::Config config;
  config.pose.min_inlier_ratio = 0.5;
  expectFailure(estimateWith(model, viewOfABall(), config), "points do not agree on a pose");
  model.spoil = [](CrispPrediction& p) {
    p.nocs.assign(p.nocs.size(), Eigen::Vector3d(0.1, 0.2, 0.3));
  };
  expectFailure(estimateWith(model, viewOfABall()), "points do not agree on a pose");
}

TEST(CrispEstimator, RejectsSizesThatAreNotPlausible) {
  BallModel model;
  model.spoil = [](CrispPrediction& p) {
    for (Eigen::Vector3d& n : p.nocs) n *= 1e-3;  // the ball is then 600 m wide
  };
  expectFailure(estimateWith(model, viewOfABall()), "size of the object is not plausible");
  model.spoil = [](CrispPrediction& p) {
    for (Eigen::Vector3d& n : p.nocs) n *= 100;
  };
  expectFailure(estimateWith(model, viewOfABall()), "size of the object is not plausible");
}

TEST(CrispEstimator, RefusesAModelThatIsNotThere) {
  EXPECT_THROW(CrispEstimator(CrispEstimator::Config{}), InputError);
  const TemporaryFolder folder;
  CrispEstimator::Config config;
  config.model = folder.path() / "none";
  EXPECT_THROW(CrispEstimator{config}, InputError);
}

TEST(CrispEstimator, RefusesADeviceThatIsNotThere) {
  CrispEstimator::Config config;
  config.model = "anywhere";
  config.device = "abacus";
  EXPECT_THROW(CrispEstimator{config}, InputError);
}

}  // namespace
}  // namespace hydrabench
