// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_losses.h"

#include <gtest/gtest.h>

#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/latent_flow/flow_sampler.h"
#include "tests/eval/training/toy_flow.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

TEST(FlowTarget, LiesBetweenNoiseAndDataAndPointsFromTheOneToTheOther) {
  const torch::Tensor data = torch::randn({64, 3, 2});
  const FlowTarget target = drawFlowTarget(data, Random(1));
  const torch::Tensor t = target.time.view({64, 1, 1});
  EXPECT_GT(t.min().item<double>(), 0);
  EXPECT_LT(t.max().item<double>(), 1);
  // From x_t, the rest of the way at the target's velocity ends at the data, and back at the noise.
  EXPECT_LE((target.x + (1 - t) * target.velocity - data).abs().max().item<double>(), 1e-5);
  const torch::Tensor noise = target.x - t * target.velocity;
  EXPECT_NEAR(noise.mean().item<double>(), 0, 0.15);
  EXPECT_NEAR(noise.std().item<double>(), 1, 0.15);
}

TEST(MakeGrids, MapsBytesToPlusMinusOne) {
  ShapeGrid grid;
  grid.values.assign(kGridSide * kGridSide * kGridSide, 0);
  grid.values[0] = 127;
  grid.values[1] = -127;
  const torch::Tensor grids = makeGrids({&grid});
  EXPECT_EQ(grids[0][0].item<float>(), 1);
  EXPECT_EQ(grids[0][1].item<float>(), -1);
  EXPECT_EQ(grids[0][2].item<float>(), 0);
}

/// The flows learn what the toys allow, and the sampler gives it back.
class LearnedFlows : public ::testing::Test {
 protected:
  LearnedFlows() {
    keepTorchOnThisThread();
    torch::manual_seed(1);
    cacheToyFlowWorlds(folder_.path(), config_);
  }
  FlowPool pool() const {
    return {config_, InstanceSplit::kTraining, folder_.path(), [](int, int) { return true; }};
  }
  LatentFlowTrainingConfig config_ = toyFlowTraining();
  TemporaryFolder folder_;
};

TEST_F(LearnedFlows, GiveBackTheOneShapeTheyWereShown) {
  const FlowPool pool = this->pool();
  ShapeFlow network(shapeFlowOptions(config_.network));
  const torch::Tensor shape = torch::randn({1, kShapeTokens, 4});
  std::vector<LatentSample> samples;
  for (std::uint64_t i = 0; i < 8; ++i) {
    samples.push_back(pool.drawLatent(false, Random(i)));
    samples.back().latent = 0;
  }
  torch::optim::Adam optimizer(network->parameters(), 1e-2);
  for (int step = 0; step < 300; ++step) {
    optimizer.zero_grad();
    shapeFlowLoss(network, samples, shape, 0.1, Random(static_cast<std::uint64_t>(step)))
        .total.backward();
    optimizer.step();
  }
  const torch::NoGradGuard no_grad;
  const torch::Tensor cells =
      torch::tensor(samples[0].view.cells).view({1, kShapeTokens, ViewGrid::kBlockFeatures});
  const torch::Tensor globals = torch::tensor(std::vector<float>(samples[0].view.globals.begin(),
                                                                 samples[0].view.globals.end()))
                                    .view({1, -1});
  for (const float given : {1.0f, 0.0f}) {
    const torch::Tensor drawn = followFlow(
        [&](const torch::Tensor& x, double t) {
          return network->forward(x, torch::full({1}, t), cells, globals, torch::tensor({given}));
        },
        normalNoise({1, kShapeTokens, 4}, 3), 25);
    EXPECT_LE((drawn - shape).square().mean().item<double>(), 0.15) << given;
  }
}

TEST_F(LearnedFlows, FallWithTraining) {
  const FlowPool pool = this->pool();
  PoseFlow pose(poseFlowOptions(config_.network));
  ShapeAutoencoder autoencoder(autoencoderOptions(config_.network));
  const auto train = [](auto& network, const auto& loss) {
    torch::optim::Adam optimizer(network->parameters(), 5e-3);
    double first = 0;
    double last = 0;
    constexpr int kSteps = 60;
    for (int step = 0; step < kSteps; ++step) {
      optimizer.zero_grad();
      const torch::Tensor value = loss(network, Random(static_cast<std::uint64_t>(step)));
      value.backward();
      optimizer.step();
      if (step < 10) first += value.template item<double>();
      if (step >= kSteps - 10) last += value.template item<double>();
    }
    return last / first;
  };
  const double pose_share = train(pose, [&](PoseFlow& network, Random random) {
    std::vector<PoseSample> samples;
    for (std::uint64_t i = 0; i < 8; ++i) samples.push_back(pool.drawPose(true, random.fork(i)));
    return poseFlowLoss(network, samples, random.fork(99)).total;
  });
  EXPECT_LE(pose_share, 0.8);
  const double field_share = train(autoencoder, [&](ShapeAutoencoder& network, Random random) {
    std::vector<FieldSample> samples;
    for (std::uint64_t i = 0; i < 8; ++i) samples.push_back(pool.drawField(64, random.fork(i)));
    return autoencoderLoss(config_.autoencoder, network, samples, random.fork(99)).total;
  });
  EXPECT_LE(field_share, 0.7);
}

}  // namespace
}  // namespace hydrabench
