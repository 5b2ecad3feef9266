// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/scale_alignment.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/geometry/depth_raster.h"

namespace hydrabench {
namespace {

/// An L of two boxes: the same from no two sides.
Mesh asymmetric() {
  Mesh mesh;
  const auto addBox = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i) {
      mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                 i & 4 ? high.z() : low.z());
    }
    for (const auto& f :
         {Eigen::Vector3i(0, 2, 1), Eigen::Vector3i(1, 2, 3), Eigen::Vector3i(4, 5, 6),
          Eigen::Vector3i(5, 7, 6), Eigen::Vector3i(0, 1, 4), Eigen::Vector3i(1, 5, 4),
          Eigen::Vector3i(2, 6, 3), Eigen::Vector3i(3, 6, 7), Eigen::Vector3i(0, 4, 2),
          Eigen::Vector3i(2, 4, 6), Eigen::Vector3i(1, 3, 5), Eigen::Vector3i(3, 7, 5)}) {
      mesh.faces.push_back(f.array() + first);
    }
  };
  addBox({-0.5, -0.5, -0.5}, {0.5, 0.1, -0.1});
  addBox({-0.5, -0.5, -0.1}, {-0.2, -0.2, 0.5});
  return mesh;
}

ShapeEstimate placed() {
  ShapeEstimate estimate;
  estimate.mesh = asymmetric();
  estimate.scale = 0.8;
  estimate.T_camera_object.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  estimate.T_camera_object.translation() = Eigen::Vector3d(0.15, -0.1, 2.2);
  return estimate;
}

/// What a sensor sees of an estimate: exact depth, its pixels as the mask.
ShapeObservation viewOf(const ShapeEstimate& truth) {
  ShapeObservation view;
  view.camera = {320, 240, 260, 260, 160, 120};
  Mesh mesh = truth.mesh;
  for (auto& vertex : mesh.vertices) vertex = truth.T_camera_object * (truth.scale * vertex);
  view.depth = rasterizeDepth(mesh, view.camera);
  view.mask = Image<std::uint8_t>(320, 240);
  for (std::size_t i = 0; i < view.depth.size(); ++i)
    view.mask.data()[i] = view.depth.data()[i] > 0;
  return view;
}

/// Says the same whatever it is shown.
class Fixed : public ShapeEstimator {
 public:
  explicit Fixed(ShapeEstimate estimate) : estimate_(std::move(estimate)) {}
  ShapeOutcome estimate(const ShapeObservation&, std::span<const ShapeObservation>,
                        std::uint64_t) const override {
    return {estimate_, "", {}};
  }

 private:
  ShapeEstimate estimate_;
};

ShapeOutcome aligned(const ShapeEstimate& said, const ShapeObservation& view,
                     const ScaleAlignmentConfig& config = {}) {
  return ScaleAligned(std::make_shared<Fixed>(said), config).estimate(view, {}, 1);
}

TEST(ScaleAlignment, FindsTheScaleOfAMeshThatIsRightButForIt) {
  const ShapeEstimate truth = placed();
  for (const double factor : {0.2, 0.9, 3.0, 40.0}) {
    const ShapeOutcome outcome = aligned(scaled(truth, factor), viewOf(truth));
    ASSERT_TRUE(outcome.estimate) << outcome.failure;
    EXPECT_NEAR(outcome.estimate->scale, 0.8, 1e-5) << factor;
    EXPECT_TRUE(outcome.estimate->T_camera_object.isApprox(truth.T_camera_object, 1e-5));
    ASSERT_EQ(outcome.times.stages().size(), 1u);
    EXPECT_EQ(outcome.times.stages()[0].name, "align_scale");
  }
}

TEST(ScaleAlignment, FindsItToOnePerCentUnderNoiseAndOutliers) {
  const ShapeEstimate truth = placed();
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    ShapeObservation view = viewOf(truth);
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0, 0.02f);
    std::uniform_real_distribution<float> anywhere(0.5f, 5), share(0, 1);
    for (float& depth : view.depth) {
      if (depth > 0) depth = share(random) < 0.3f ? anywhere(random) : depth + noise(random);
    }
    const ShapeOutcome outcome = aligned(scaled(truth, 7), view);
    ASSERT_TRUE(outcome.estimate) << outcome.failure;
    EXPECT_NEAR(outcome.estimate->scale / 0.8, 1, 0.01) << seed;
  }
}

TEST(ScaleAlignment, SaysHowManyPixelsAndHowTheyDisagree) {
  const ShapeEstimate truth = placed();
  ShapeObservation view = viewOf(truth);
  const auto exact = measureScale(truth, view);
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->factor, 1, 1e-6);
  EXPECT_LT(exact->spread, 1e-6);
  EXPECT_GT(exact->pixels, 5000);
  // Three quarters at once, one quarter at twice the depth: half of all deviate by 0 from 1.
  int i = 0;
  for (float& depth : view.depth) depth *= i++ % 4 == 0 ? 2 : 1;
  EXPECT_LT(measureScale(truth, view)->spread, 1e-6);
  // In thirds at 1, 2 and 3 times: the median is 2, the deviations 0 and twice 1.
  i = 0;
  view = viewOf(truth);
  for (float& depth : view.depth) depth *= static_cast<float>(1 + i++ % 3);
  EXPECT_NEAR(measureScale(truth, view)->spread, 0.5, 1e-5);
}

TEST(ScaleAlignment, IsNoEstimateWhereDepthSaysTooLittleOrContradictsItself) {
  const ShapeEstimate truth = placed();
  ShapeObservation view = viewOf(truth);
  int i = 0;
  for (float& depth : view.depth) depth *= static_cast<float>(1 + i++ % 3);
  EXPECT_EQ(aligned(truth, view).failure, "depths disagree about the scale");
  EXPECT_FALSE(aligned(truth, view).estimate);
  view = viewOf(truth);
  view.depth.fill(0);
  EXPECT_EQ(aligned(truth, view).failure, "too few depths to scale by");
  view.depth.fill(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(aligned(truth, view).failure, "too few depths to scale by");
  view = viewOf(truth);
  const int pixels = measureScale(truth, view)->pixels;
  EXPECT_TRUE(aligned(truth, view, {.min_pixels = pixels}).estimate);
  EXPECT_FALSE(aligned(truth, view, {.min_pixels = pixels + 1}).estimate);
}

TEST(ScaleAlignment, LeavesAFailureAsItIs) {
  class Failing : public ShapeEstimator {
    ShapeOutcome estimate(const ShapeObservation&, std::span<const ShapeObservation>,
                          std::uint64_t) const override {
      return {std::nullopt, "out of luck", {}};
    }
  };
  const ShapeOutcome outcome =
      ScaleAligned(std::make_shared<Failing>(), {}).estimate(viewOf(placed()), {}, 1);
  EXPECT_EQ(outcome.failure, "out of luck");
}

}  // namespace
}  // namespace hydrabench
