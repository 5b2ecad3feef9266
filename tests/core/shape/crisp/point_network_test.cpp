// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/point_network.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/crisp/torch_weights.h"
#include "tests/core/shape/crisp/toy_points.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

PointNetworkImpl::Options smallOptions() {
  return {.dim = 32, .depth = 2, .heads = 2, .code = 24, .decoder = {.layers = 2, .width = 16}};
}

PointNetwork smallNetwork(std::uint64_t seed) {
  keepTorchOnThisThread();
  torch::manual_seed(seed);
  return PointNetwork(smallOptions());
}

std::vector<PointInput> someInputs(std::uint64_t count) {
  std::vector<PointInput> inputs;
  for (std::uint64_t i = 0; i < count; ++i) {
    inputs.push_back(*makePointInput(toyPoints(300, i), i));
  }
  return inputs;
}

double largestDifference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>();
}

TEST(PointNetwork, HasTheShapesItPromises) {
  const torch::NoGradGuard no_grad;
  PointNetwork network = smallNetwork(1);
  const auto output = network->forward(makePointBatch(someInputs(3)));
  EXPECT_EQ(output.nocs.sizes(), (std::vector<std::int64_t>{3, PointInput::kObjectPoints, 3}));
  EXPECT_EQ(output.code.sizes(), (std::vector<std::int64_t>{3, 24}));
  EXPECT_EQ(output.direct.sizes(), (std::vector<std::int64_t>{3, 6}));
  const torch::Tensor sdf = network->sdf(torch::rand({3, 7, 3}), output.code);
  EXPECT_EQ(sdf.sizes(), (std::vector<std::int64_t>{3, 7}));
  for (const torch::Tensor& t : {output.nocs, output.code, output.direct, sdf}) {
    EXPECT_TRUE(torch::isfinite(t).all().item<bool>());
    EXPECT_EQ(t.scalar_type(), torch::kFloat32);
  }
}

TEST(PointNetwork, ViewsOfABatchDoNotTouchEachOther) {
  const torch::NoGradGuard no_grad;
  PointNetwork network = smallNetwork(1);
  const std::vector<PointInput> inputs = someInputs(3);
  const auto together = network->forward(makePointBatch(inputs));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto alone = network->forward(makePointBatch({&inputs[i], 1}));
    const auto index = static_cast<std::int64_t>(i);
    EXPECT_LT(largestDifference(together.nocs[index], alone.nocs[0]), 1e-5);
    EXPECT_LT(largestDifference(together.code[index], alone.code[0]), 1e-5);
    EXPECT_LT(largestDifference(together.direct[index], alone.direct[0]), 1e-5);
  }
}

TEST(PointNetwork, NocsOfAPointAreTheUprightSimilarityOfItsVote) {
  const torch::NoGradGuard no_grad;
  PointNetwork network = smallNetwork(1);
  // All vote alike: a turn by 90 degrees and a scale of 2 in the plane, a centre, 3 vertically.
  auto parameters = network->named_parameters();
  parameters["dense.4.weight"].zero_();
  parameters["dense.4.bias"].copy_(torch::tensor({0.0f, 2.0f, 0.1f, 0.2f, 0.3f, 2.0f}));
  const std::vector<PointInput> inputs = someInputs(1);
  const torch::Tensor nocs = network->forward(makePointBatch(inputs)).nocs[0];
  for (std::int64_t i = 0; i < PointInput::kObjectPoints; i += 29) {
    const float* p = &inputs[0].points[static_cast<std::size_t>(i) * PointInput::kFeatures];
    EXPECT_NEAR(nocs[i][0].item<float>(), 2 * (p[1] - 0.2f), 1e-5);
    EXPECT_NEAR(nocs[i][1].item<float>(), -2 * (p[0] - 0.1f), 1e-5);
    EXPECT_NEAR(nocs[i][2].item<float>(), 3 * (p[2] - 0.3f), 1e-5);
  }
}

TEST(PointNetwork, ReadsTheHeightAndTheBordersOfTheMask) {
  const torch::NoGradGuard no_grad;
  PointNetwork network = smallNetwork(1);
  std::vector<PointInput> inputs(3, someInputs(1)[0]);
  inputs[1].globals[5] = 1;
  for (std::size_t i = 0; i < PointInput::kPoints; ++i) {
    inputs[2].points[i * PointInput::kFeatures + 3] += 1;
  }
  const torch::Tensor code = network->forward(makePointBatch(inputs)).code;
  EXPECT_GT(largestDifference(code[1], code[0]), 1e-4);
  EXPECT_GT(largestDifference(code[2], code[0]), 1e-4);
}

TEST(PointNetwork, SavedAndLoadedItSaysTheSameToHalfPrecision) {
  const torch::NoGradGuard no_grad;
  const TemporaryFolder folder;
  PointNetwork saved = smallNetwork(1);
  saveWeights(*saved, folder / "w.safetensors", {}, TensorType::kF16);
  PointNetwork loaded = smallNetwork(2);
  const PointBatch batch = makePointBatch(someInputs(2));
  const auto expected = saved->forward(batch);
  EXPECT_GT(largestDifference(loaded->forward(batch).nocs, expected.nocs), 0.1);
  loadWeights(*loaded, folder / "w.safetensors");
  const auto output = loaded->forward(batch);
  EXPECT_LT(largestDifference(output.nocs, expected.nocs), 5e-3);
  EXPECT_LT(largestDifference(output.code, expected.code), 5e-3);
  EXPECT_LT(largestDifference(output.direct, expected.direct), 5e-3);
  const torch::Tensor points = torch::rand({2, 9, 3});
  EXPECT_LT(largestDifference(loaded->sdf(points, output.code), saved->sdf(points, expected.code)),
            5e-3);
}

TEST(PointNetwork, IsTheSameForAnyNumberOfThreads) {
  PointNetwork network = smallNetwork(1);
  const std::vector<PointInput> inputs = someInputs(6);
  const auto allWith = [&](int threads) {
    setNumThreads(threads);
    std::vector<torch::Tensor> nocs(inputs.size());
    parallelFor(inputs.size(), [&](std::size_t i) {
      keepTorchOnThisThread();
      const torch::NoGradGuard no_grad;
      nocs[i] = network->forward(makePointBatch({&inputs[i], 1})).nocs;
    });
    setNumThreads(0);
    return torch::cat(nocs);
  };
  EXPECT_TRUE(torch::equal(allWith(1), allWith(2)));
}

TEST(PointNetwork, HasAsManyWeightsAsItsLayersSay) {
  const auto linear = [](std::int64_t in, std::int64_t out) { return (in + 1) * out; };
  const std::int64_t d = 192;
  const std::int64_t tokens = linear(8, 64) + linear(64, 128) + linear(128, 128) + linear(256, d) +
                              linear(4, 64) + linear(64, d) + linear(10, 128) + linear(128, d) +
                              3 * d;
  const std::int64_t norms_and_gains = 6 * d;
  const std::int64_t block =
      norms_and_gains + linear(d, 3 * d) + linear(d, d) + linear(d, 4 * d) + linear(4 * d, d);
  const std::int64_t dense =
      2 * d + linear(5, 64) + linear(2 * d + 64, d) + linear(d, 96) + linear(96, 6);
  const std::int64_t shape = linear(3 * d, 512) + 1024 + linear(512, 512) + 1024 + linear(512, 256);
  const std::int64_t direct = linear(3 * d, 256) + linear(256, 6);
  const std::int64_t decoder =
      linear(3, 128) + 3 * linear(128, 128) + linear(128, 1) + linear(256, 4 * 2 * 128);
  PointNetwork network(PointNetworkImpl::Options{});
  std::int64_t count = 0;
  for (const torch::Tensor& p : network->parameters()) count += p.numel();
  EXPECT_EQ(count, tokens + 6 * block + dense + shape + direct + decoder);
}

}  // namespace
}  // namespace hydrabench
