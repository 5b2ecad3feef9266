// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/sharded.h"

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/point_network.h"
#include "core/shape/crisp/torch_runtime.h"
#include "eval/training/half_precision.h"
#include "tests/eval/training/toy_samples.h"

namespace hydrabench {
namespace {

using Linear = torch::nn::Linear;

TEST(Shards, ShareTheValuesOfTheMaster) {
  Linear master(2, 1);
  Shards<Linear> shards(master, 2, [] { return Linear(2, 1); });
  {
    const torch::NoGradGuard no_grad;
    master->weight.fill_(3);
  }
  ASSERT_EQ(shards.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(torch::equal(shards[k]->weight, master->weight));
    EXPECT_TRUE(torch::equal(shards[k]->bias, master->bias));
  }
}

TEST(Shards, GiveTheMeanOfTheirGradientsAndStartAnew) {
  Linear master(1, 1);
  Shards<Linear> shards(master, 2, [] { return Linear(1, 1); });
  for (int round = 0; round < 2; ++round) {
    // d/dw of w x + b is x, of b it is 1.
    shards[0]->forward(torch::full({1, 1}, 4.0f)).sum().backward();
    shards[1]->forward(torch::full({1, 1}, 10.0f)).sum().backward();
    shards.collectGradients();
    EXPECT_EQ(master->weight.grad().item<float>(), 7) << "round " << round;
    EXPECT_EQ(master->bias.grad().item<float>(), 1);
    EXPECT_EQ(shards[0]->weight.grad().item<float>(), 0);
  }
}

TEST(Shards, AWeightThatWasNotUsedHasNoGradient) {
  Linear master(1, 1);
  Shards<Linear> shards(master, 2, [] { return Linear(1, 1); });
  shards[1]->bias.sum().backward();
  shards.collectGradients();
  EXPECT_FALSE(master->weight.grad().defined());
  EXPECT_EQ(master->bias.grad().item<float>(), 0.5f);  // the mean over both
}

TEST(Shards, HaveTheGradientOfOneBatchForAnyNumberOfThreads) {
  keepTorchOnThisThread();
  const CrispTrainingConfig config = toyTraining();
  torch::manual_seed(1);
  PointNetwork network(networkOptions(config));
  const std::vector<TrainingSample> samples = toySamples(4);
  const auto gradientOf = [&](std::size_t count) {
    Shards<PointNetwork> shards(network, static_cast<int>(count),
                                [&] { return PointNetwork(networkOptions(config)); });
    const std::size_t part = samples.size() / count;
    parallelFor(count, [&](std::size_t k) {
      keepTorchOnThisThread();
      const std::span<const TrainingSample> own(&samples[k * part], part);
      crispLoss(config, shards[k], makeTrainingBatch(own, {}), {}).total.backward();
    });
    network->zero_grad();
    shards.collectGradients();
    std::vector<torch::Tensor> gradients;
    for (const torch::Tensor& p : network->parameters()) {
      if (p.requires_grad()) gradients.push_back(p.grad().clone());
    }
    return gradients;
  };
  const std::vector<torch::Tensor> whole = gradientOf(1);
  setNumThreads(2);
  const std::vector<torch::Tensor> halves = gradientOf(2);
  setNumThreads(1);
  const std::vector<torch::Tensor> halves_in_turn = gradientOf(2);
  setNumThreads(0);
  double largest = 0;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    EXPECT_LT((whole[k] - halves[k]).abs().max().item<double>(),
              1e-6 * (1 + whole[k].abs().max().item<double>()));
    EXPECT_TRUE(torch::equal(halves[k], halves_in_turn[k]));
    largest = std::max(largest, whole[k].abs().max().item<double>());
  }
  EXPECT_GT(largest, 0.1);
}

TEST(WantsHalfPrecision, IsWhatTheConfigSaysUnlessAuto) {
  EXPECT_TRUE(wantsHalfPrecision("bf16"));
  EXPECT_FALSE(wantsHalfPrecision("fp32"));
}

TEST(Autocast, IsHalfPrecisionInItsScopeOnly) {
  const torch::Tensor a = torch::ones({2, 2});
  {
    const Autocast autocast(true);
    EXPECT_EQ(torch::mm(a, a).scalar_type(), torch::kBFloat16);
  }
  EXPECT_EQ(torch::mm(a, a).scalar_type(), torch::kFloat32);
  const Autocast off(false);
  EXPECT_EQ(torch::mm(a, a).scalar_type(), torch::kFloat32);
}

}  // namespace
}  // namespace hydrabench
