// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "eval/training/distance_loss.h"
#include "tests/eval/training/toy_samples.h"

namespace hydrabench {
namespace {

CrispTrainingConfig onlyNocs() {
  CrispTrainingConfig config = toyTraining();
  config.joint.nocs_weight = 1;
  config.joint.sdf_weight = 0;
  config.joint.direct_weight = 0;
  config.joint.code_weight = 0;
  return config;
}

/// A batch whose targets are what the network says, to be moved by known amounts.
class ExactBatch : public ::testing::Test {
 protected:
  ExactBatch() {
    torch::manual_seed(2);
    network_ = PointNetwork(networkOptions(toyTraining()));
    const torch::NoGradGuard no_grad;
    batch_ = makeTrainingBatch(toySamples(2), {});
    output_ = network_->forward(batch_.input);
    batch_.nocs = output_.nocs.unsqueeze(1).repeat({1, TrainingSample::kPoses, 1, 1});
    batch_.direct = output_.direct.unsqueeze(1).repeat({1, TrainingSample::kPoses, 1});
    batch_.distances = network_->sdf(batch_.points, output_.code).clone();
    batch_.weights.fill_(1);
  }
  CrispLoss loss(const CrispTrainingConfig& config, const ShapeCodes& codes = {}) {
    const torch::NoGradGuard no_grad;
    return crispLoss(config, network_, batch_, codes);
  }

  PointNetwork network_{nullptr};
  TrainingBatch batch_;
  PointNetworkImpl::Output output_;
};

TEST(DistanceLoss, CountsWhatIsFarFromTheSurfaceHalf) {
  // |0.05 - 0.02| counts whole, |0.1 - 0.2| half.
  const torch::Tensor predicted = torch::tensor({0.05f, 0.1f});
  const torch::Tensor target = torch::tensor({0.02f, 0.2f});
  EXPECT_NEAR(distanceLoss(predicted, target, 0.25).item<double>(), (0.03 + 0.5 * 0.1) / 2, 1e-7);
}

TEST(DistanceLoss, IsLeastAtTheQuantile) {
  // A point that is inside in four of ten views that look the same: -0.05 there and 0.05 in the
  // rest.
  torch::Tensor target = torch::full({10}, 0.05f);
  target.narrow(0, 0, 4).fill_(-0.05f);
  const auto loss = [&](double distance, float quantile) {
    return distanceLoss(torch::full({10}, distance), target, 0.25, torch::tensor(quantile))
        .item<double>();
  };
  EXPECT_LT(loss(0.05, 0.5f), loss(-0.05, 0.5f));
  EXPECT_LT(loss(-0.05, 0.35f), loss(0.05, 0.35f));
  EXPECT_NEAR(loss(0.05, 0.35f), 0.4 * 2 * 0.65 * 0.1, 1e-6);
  EXPECT_NEAR(loss(-0.05, 0.35f), 0.6 * 2 * 0.35 * 0.1, 1e-6);
}

TEST(DistanceLoss, ClampsTheTargetAndNotThePrediction) {
  torch::Tensor predicted = torch::tensor({0.9f, -0.9f}).requires_grad_();
  const torch::Tensor loss = distanceLoss(predicted, torch::tensor({0.5f, -0.4f}), 0.25);
  EXPECT_NEAR(loss.item<double>(), 0.5 * 0.65, 1e-6);
  loss.backward();
  EXPECT_NEAR(predicted.grad()[0].item<double>(), 0.25, 1e-6);  // half, over two points
  EXPECT_NEAR(predicted.grad()[1].item<double>(), -0.25, 1e-6);
}

TEST_F(ExactBatch, OfARightNetworkLosesNothing) {
  CrispTrainingConfig config = toyTraining();
  config.target_clamp = 2;  // so that no target is
  EXPECT_NEAR(loss(config).total.item<double>(), 0, 1e-6);
}

TEST_F(ExactBatch, NocsLossIsSquaredBelowATenthAndLinearAbove) {
  // Two of three coordinates of every point are wrong: 0.05^2 / 0.2 + (0.3 - 0.05).
  batch_.nocs.select(3, 0) += 0.05;
  batch_.nocs.select(3, 1) -= 0.3;
  const CrispLoss result = loss(onlyNocs());
  EXPECT_NEAR(result.nocs, 0.0125 + 0.25, 1e-5);
  EXPECT_NEAR(result.total.item<double>(), 0.0125 + 0.25, 1e-5);
  EXPECT_NEAR(result.nocs_error, std::hypot(0.05, 0.3), 1e-5);
}

TEST_F(ExactBatch, OnlyPointsOnTheObjectCount) {
  batch_.nocs.narrow(2, 0, 100) += 5;
  EXPECT_GT(loss(onlyNocs()).nocs, 1);
  batch_.weights.narrow(1, 0, 100).fill_(0);
  EXPECT_NEAR(loss(onlyNocs()).nocs, 0, 1e-6);
}

TEST_F(ExactBatch, TheBetterOfTwoPosesCounts) {
  // View 0: the second pose is wrong, view 1: both are, the first more so.
  batch_.nocs[0][1] += 1;
  batch_.nocs[1][0] += 1;
  batch_.nocs[1][1] += 0.3;
  EXPECT_NEAR(loss(onlyNocs()).nocs, 0.5 * 3 * 0.25, 1e-5);
}

TEST_F(ExactBatch, APoseIsChosenAsAWhole) {
  // Points say pose 0 by far, the direct output slightly pose 1: pose 0 counts for both.
  CrispTrainingConfig config = onlyNocs();
  config.joint.direct_weight = 1;
  batch_.nocs.select(1, 1) += 1;
  batch_.direct.select(1, 0).select(1, 2) += 0.05;
  const CrispLoss result = loss(config);
  EXPECT_NEAR(result.nocs, 0, 1e-6);
  EXPECT_NEAR(result.direct, 0.0125, 1e-5);
}

TEST_F(ExactBatch, DirectLossOfAYawIsHalfTheSquare) {
  CrispTrainingConfig config = onlyNocs();
  config.joint.direct_weight = 3;
  batch_.direct.select(2, 4) += 0.4;
  const CrispLoss result = loss(config);
  EXPECT_NEAR(result.direct, 0.08, 1e-5);
  EXPECT_NEAR(result.total.item<double>(), 0.24, 1e-5);
}

TEST_F(ExactBatch, CodesAreComparedWhereThereAreSome) {
  CrispTrainingConfig config = onlyNocs();
  config.joint.code_weight = 2;
  ShapeCodes codes;
  codes.variance = 0.5;
  codes.codes = torch::stack({torch::zeros_like(output_.code[0]), output_.code[1] + 0.1});
  batch_.code_rows = torch::tensor({std::int64_t{-1}, std::int64_t{1}});
  const CrispLoss result = loss(config, codes);
  EXPECT_NEAR(result.code, 0.01 / 0.5, 1e-5);  // of view 1 alone
  EXPECT_NEAR(result.total.item<double>(), 2 * 0.02, 1e-5);

  batch_.code_rows.fill_(-1);
  EXPECT_EQ(loss(config, codes).code, 0);
  EXPECT_EQ(loss(config).code, 0);
}

TEST(TrainingBatch, FindsTheCodeOfAShapeByItsNumber) {
  std::vector<TrainingSample> samples = toySamples(3);
  samples[0].shape = 1002;
  samples[1].shape = -1;
  samples[2].shape = 7;
  ShapeCodes codes;
  codes.rows = {{7, 0}, {1002, 5}};
  const TrainingBatch batch = makeTrainingBatch(samples, codes);
  EXPECT_TRUE(torch::equal(batch.code_rows,
                           torch::tensor({std::int64_t{5}, std::int64_t{-1}, std::int64_t{0}})));
  EXPECT_EQ(batch.nocs.sizes(), (std::vector<std::int64_t>{3, 2, PointInput::kObjectPoints, 3}));
  EXPECT_EQ(batch.nocs[2][1][5][2].item<float>(), samples[2].nocs[1][17]);
  EXPECT_EQ(batch.direct[1][0][3].item<float>(), samples[1].direct[0][3]);
  EXPECT_EQ(batch.points[2][31][1].item<float>(), samples[2].points[94]);
  EXPECT_EQ(batch.distances[1][3].item<float>(), samples[1].distances[3]);
}

}  // namespace
}  // namespace hydrabench
