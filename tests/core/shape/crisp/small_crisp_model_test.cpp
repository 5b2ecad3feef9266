// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/small_crisp_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/shape/crisp/crisp_models.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/types/error.h"
#include "tests/core/shape/crisp/ball_view.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

PointNetwork randomNetwork() {
  torch::manual_seed(3);
  return PointNetwork(PointNetworkImpl::Options{
      .dim = 32, .depth = 1, .heads = 2, .decoder = {.layers = 2, .width = 16}});
}

CrispManifest manifestOf(const std::filesystem::path& weights) {
  CrispManifest manifest;
  manifest.preset = "small";
  manifest.mode = "normalised";
  manifest.cube_half_side = 1.25;
  manifest.encoder_dim = 32;
  manifest.encoder_depth = 1;
  manifest.encoder_heads = 2;
  manifest.sdf_layers = 2;
  manifest.sdf_width = 16;
  manifest.weights = weights;
  return manifest;
}

TEST(SmallCrispModel, GivesPointsOfTheViewInTheCameraFrame) {
  const auto model = makeSmallCrisp(randomNetwork(), manifestOf(""), "cpu");
  EXPECT_EQ(model->freedom(), NocsFreedom::kUpright);
  EXPECT_EQ(model->cubeHalfSide(), 1.25);
  EXPECT_FALSE(model->needsColor());
  const CrispPrediction prediction = model->predict(viewOfABall(), 1);
  ASSERT_EQ(prediction.points.size(), std::size_t{PointInput::kObjectPoints});
  ASSERT_EQ(prediction.nocs.size(), prediction.points.size());
  for (const Eigen::Vector3d& p : prediction.points) {
    EXPECT_NEAR((p - kBallCenter).norm(), kBallRadius, 1e-5);
  }
}

TEST(SmallCrispModel, SaysTheSameTwiceAndDrawsOtherPointsWithAnotherSeed) {
  const auto model = makeSmallCrisp(randomNetwork(), manifestOf(""), "cpu");
  const ShapeObservation view = viewOfABall();
  const CrispPrediction a = model->predict(view, 1);
  const CrispPrediction b = model->predict(view, 1);
  EXPECT_EQ(a.nocs, b.nocs);
  EXPECT_EQ(a.points, b.points);
  EXPECT_NE(a.points, model->predict(view, 2).points);
}

TEST(SmallCrispModel, DependsOnNothingButGeometry) {
  const auto model = makeSmallCrisp(randomNetwork(), manifestOf(""), "cpu");
  ShapeObservation view = viewOfABall();
  const CrispPrediction before = model->predict(view, 1);
  view.color = {};
  view.label = 7;
  view.stamp_ns = 99;
  view.T_world_camera.translation() += Eigen::Vector3d(4, 5, 6);
  EXPECT_EQ(model->predict(view, 1).nocs, before.nocs);
}

TEST(SmallCrispModel, IsLoadedFromItsWeights) {
  const TemporaryFolder folder;
  PointNetwork network = randomNetwork();
  saveWeights(*network, folder / "w.safetensors");
  const CrispManifest manifest = manifestOf(folder / "w.safetensors");
  EXPECT_EQ(loadSmallCrisp(manifest, "cpu")->predict(viewOfABall(), 1).nocs,
            makeSmallCrisp(network, manifest, "cpu")->predict(viewOfABall(), 1).nocs);
  CrispManifest wider = manifest;
  wider.encoder_dim = 64;
  EXPECT_THAT(messageOf<InputError>([&] { loadSmallCrisp(wider, "cpu"); }),
              ::testing::HasSubstr("the network expects"));
}

}  // namespace
}  // namespace hydrabench
