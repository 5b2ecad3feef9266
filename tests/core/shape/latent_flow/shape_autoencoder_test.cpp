// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/shape_autoencoder.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/shape/crisp/torch_runtime.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

ShapeAutoencoderImpl::Options small() {
  return {.dim = 48,
          .encoder_depth = 1,
          .decoder_depth = 1,
          .heads = 3,
          .latent = 8,
          .features = 8,
          .hidden = 32};
}

/// A plate, thinner than the distance of two nodes, on a foot.
double plate(const Eigen::Vector3d& p) {
  const auto box = [&](const Eigen::Vector3d& center, const Eigen::Vector3d& half) {
    const Eigen::Vector3d d = (p - center).cwiseAbs() - half;
    return d.cwiseMax(0).norm() + std::min(d.maxCoeff(), 0.0);
  };
  return std::min(box({0, 0, 0.2}, {0.03, 0.8, 0.6}), box({0, 0, -0.7}, {0.3, 0.3, 0.1}));
}

torch::Tensor gridOfThePlate() {
  torch::Tensor grid = torch::empty({1, kGridSide * kGridSide * kGridSide});
  for (int z = 0; z < kGridSide; ++z) {
    for (int y = 0; y < kGridSide; ++y) {
      for (int x = 0; x < kGridSide; ++x) {
        grid.data_ptr<float>()[gridIndex(x, y, z)] =
            static_cast<float>(quantizedDistance(plate(gridNode(x, y, z)))) / 127;
      }
    }
  }
  return grid;
}

TEST(Blocks, AreCutAlongAllAxesAndPutTogetherAgain) {
  const torch::Tensor values = torch::arange(2 * 16 * 16 * 16 * 3).view({2, 4096, 3});
  const torch::Tensor blocks = toBlocks(values, kCellSide);
  ASSERT_EQ(blocks.sizes(), (std::vector<std::int64_t>{2, kShapeTokens, 64 * 3}));
  EXPECT_TRUE(torch::equal(fromBlocks(blocks, kCellSide), values));
  // The cell x = 5, y = 2, z = 9 is in block (1, 0, 2), its cell (1, 2, 1) there.
  const auto cell = 9 * 256 + 2 * 16 + 5;
  EXPECT_TRUE(
      torch::equal(blocks[1][2 * 16 + 0 + 1].view({64, 3})[1 * 16 + 2 * 4 + 1], values[1][cell]));
}

TEST(ShapeAutoencoder, ReadsItsFeaturesWhereTheCellsAre) {
  keepTorchOnThisThread();
  ShapeAutoencoder network(small());
  // Features that are the coordinates of their cell: interpolation gives back any place between.
  torch::Tensor features = torch::zeros({1, 8, kCellSide, kCellSide, kCellSide});
  const torch::Tensor at =
      (torch::arange(kCellSide, torch::kFloat32) + 0.5) * (2 * kGridHalfSide / kCellSide) -
      kGridHalfSide;
  features[0][0] += at.view({1, 1, -1});
  features[0][1] += at.view({1, -1, 1});
  features[0][2] += at.view({-1, 1, 1});
  // A layer that puts out x + 10 y + 100 z of the features, and nothing else.
  const torch::NoGradGuard no_grad;
  for (torch::Tensor& value : network->parameters()) value.zero_();
  auto parameters = network->named_parameters();
  // GELU is the identity for large values: lift by 10000, and take it away at the end.
  parameters["field.0.weight"][0][0] = 1;
  parameters["field.0.weight"][0][1] = 10;
  parameters["field.0.weight"][0][2] = 100;
  parameters["field.0.bias"][0] = 1000;
  parameters["field.2.weight"][0][0] = 1;
  parameters["field.4.weight"][0][0] = 1;
  parameters["field.4.bias"][0] = -1000;
  const torch::Tensor points = torch::tensor({{{0.3f, -0.7f, 0.9f}, {-1.0f, 0.2f, 0.0f}}});
  const torch::Tensor read = network->distance(features, points) / kTruncation;
  EXPECT_NEAR(read[0][0].item<double>(), 0.3 - 7 + 90, 1e-2);
  EXPECT_NEAR(read[0][1].item<double>(), -1 + 2 + 0, 1e-2);
}

TEST(ShapeAutoencoder, LearnsOneShapeByHeartItsThinPartIncluded) {
  keepTorchOnThisThread();
  torch::manual_seed(1);
  ShapeAutoencoder network(small());
  const torch::Tensor grid = gridOfThePlate();
  torch::optim::Adam optimizer(network->parameters(), 4e-3);
  Random random(1);
  const auto draw = [&](int count) {
    torch::Tensor points = torch::empty({1, count, 3});
    torch::Tensor distances = torch::empty({1, count});
    for (int i = 0; i < count; ++i) {
      Eigen::Vector3d p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(-1.1, 1.1);
      if (i % 2) p.x() = random.uniform(-0.1, 0.1);
      for (int axis = 0; axis < 3; ++axis) {
        points.data_ptr<float>()[3 * i + axis] = static_cast<float>(p[axis]);
      }
      distances.data_ptr<float>()[i] =
          static_cast<float>(std::clamp(plate(p), -kTruncation, kTruncation));
    }
    return std::pair(points, distances);
  };
  const auto error = [&](int count) {
    const auto [points, distances] = draw(count);
    return (network->distance(network->decode(network->encode(grid)), points) - distances)
        .abs()
        .mean();
  };
  const double before = error(1000).item<double>();
  for (int step = 0; step < 900; ++step) {
    optimizer.zero_grad();
    error(300).backward();
    optimizer.step();
  }
  const torch::NoGradGuard no_grad;
  EXPECT_LE(error(1000).item<double>(), 0.008);
  EXPECT_GE(before, 0.05);
  const torch::Tensor inside = torch::tensor({{{0.0f, 0.3f, 0.3f}, {0.0f, -0.5f, 0.1f}}});
  const torch::Tensor value = network->distance(network->decode(network->encode(grid)), inside);
  EXPECT_LT(value.max().item<double>(), 0);
}

TEST(ShapeAutoencoder, NormalizesChannelByChannelAndBack) {
  ShapeAutoencoder network(small());
  const torch::Tensor latent = 3 * torch::randn({2, kShapeTokens, 8}) + 5;
  network->setNormalization(latent.flatten(0, 1).mean(0), latent.flatten(0, 1).std(0));
  const torch::Tensor normal = network->normalize(latent);
  EXPECT_LE(normal.mean().abs().item<double>(), 1e-5);
  EXPECT_NEAR(normal.std().item<double>(), 1, 1e-2);
  EXPECT_LE((network->denormalize(normal) - latent).abs().max().item<double>(), 1e-4);
}

TEST(LatentField, IsTheDecodersDistanceAndGrowsBeyondTheCube) {
  keepTorchOnThisThread();
  torch::manual_seed(2);
  ShapeAutoencoder network(small());
  const torch::NoGradGuard no_grad;
  const torch::Tensor features = network->decode(torch::randn({1, kShapeTokens, 8}));
  const SdfField field = makeLatentField(network, features);
  const std::vector<Eigen::Vector3f> points = {{0.1f, 0.2f, -0.3f}, {1.2f, 0, 0}, {1.7f, 0, 0}};
  std::vector<float> values(3);
  field(points, values);
  const torch::Tensor same = network->distance(features, torch::tensor({{{0.1f, 0.2f, -0.3f}}}));
  EXPECT_FLOAT_EQ(values[0], same.item<float>());
  EXPECT_NEAR(values[2], values[1] + 0.5, 1e-5);
}

}  // namespace
}  // namespace hydrabench
