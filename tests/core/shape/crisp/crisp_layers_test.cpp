// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Single layers against values worked out by hand: these need no other program and never skip.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "core/shape/crisp/dpt_head.h"
#include "core/shape/crisp/film_sdf.h"
#include "core/shape/crisp/vit.h"

namespace hydrabench {
namespace {

/// Sets a parameter by name, in row order.
void put(torch::nn::Module& module, const std::string& name, const std::vector<float>& values) {
  const torch::NoGradGuard no_grad;
  torch::Tensor target = module.named_parameters()[name];
  ASSERT_EQ(target.numel(), static_cast<std::int64_t>(values.size())) << name;
  target.copy_(torch::tensor(values).view(target.sizes()));
}
void fill(torch::nn::Module& module, const std::string& name, double value) {
  const torch::NoGradGuard no_grad;
  module.named_parameters()[name].fill_(value);
}
/// A convolution that hands its input on.
void putIdentity(torch::nn::Module& module, const std::string& name) {
  const torch::NoGradGuard no_grad;
  torch::Tensor weight = module.named_parameters()[name];
  weight.zero_();
  for (std::int64_t c = 0; c < weight.size(0); ++c) {
    weight[c][c][weight.size(2) / 2][weight.size(3) / 2] = 1;
  }
}
std::vector<float> row(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().flatten().contiguous();
  return {flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel()};
}

constexpr DptOptions kOneChannel = {.dim = 2,
                                    .tap_channels = {1, 1, 1, 1},
                                    .channels = 1,
                                    .head_channels = 1,
                                    .last_channels = 1,
                                    .norm_groups = 1};

TEST(SelfAttention, OfOneHeadIsTheSoftmaxOfScaledProducts) {
  SelfAttention attention(2, 1);
  put(*attention, "qkv.weight", {1, 0, 0, 1, 2, 0, 0, 2, 0, 1, 1, 0});  // q = x, k = 2 x, v swaps
  fill(*attention, "qkv.bias", 0);
  put(*attention, "proj.weight", {1, 0, 0, 1});
  put(*attention, "proj.bias", {10, 20});
  Eigen::MatrixXd x(3, 2);
  x << 1, 0, 0, 1, 0.5, -1;
  const Eigen::MatrixXd score = 2 * x * x.transpose() / std::sqrt(2.0);
  Eigen::MatrixXd weight = score.array().exp();
  weight.array().colwise() /= weight.rowwise().sum().array().eval();
  const Eigen::MatrixXd y = weight * x.rowwise().reverse();
  const std::vector<float> result =
      row(attention->forward(torch::tensor({1.0f, 0.0f, 0.0f, 1.0f, 0.5f, -1.0f}).view({1, 3, 2})));
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(result[static_cast<std::size_t>(2 * i)], y(i, 0) + 10, 2e-6);
    EXPECT_NEAR(result[static_cast<std::size_t>(2 * i + 1)], y(i, 1) + 20, 2e-6);
  }
}

TEST(TransformerBlock, LayerScaleWeighsEachBranch) {
  TransformerBlock block(2, 1);
  fill(*block, "attn.proj.weight", 0);
  put(*block, "attn.proj.bias", {1, 2});
  fill(*block, "mlp.fc2.weight", 0);
  put(*block, "mlp.fc2.bias", {100, 200});
  put(*block, "ls1.gamma", {0.5f, 3});
  put(*block, "ls2.gamma", {0.25f, -1});
  const torch::Tensor x = torch::tensor({7.0f, 9.0f}).view({1, 1, 2});
  EXPECT_EQ(row(block->forward(x)), (std::vector<float>{7 + 0.5f + 25, 9 + 6 - 200}));
}

TEST(TransformerBlock, HiddenLayerIsExactGeluOfTheNormalisedInput) {
  TransformerBlock block(2, 1);
  fill(*block, "ls1.gamma", 0);
  fill(*block, "mlp.fc1.weight", 0);
  put(*block, "mlp.fc1.bias", {-1, 0, 0, 0, 0, 0, 0, 0});
  put(*block, "mlp.fc1.weight", {2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  put(*block, "mlp.fc2.weight", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  fill(*block, "mlp.fc2.bias", 0);
  // LayerNorm takes (8, 4) to (1, -1); the hidden value is 2 - 1 = 1; gelu(1) = Phi(1) = 0.841345.
  const std::vector<float> y = row(block->forward(torch::tensor({8.0f, 4.0f}).view({1, 1, 2})));
  EXPECT_NEAR(y[0], 8.841345, 2e-6);
  EXPECT_FLOAT_EQ(y[1], 4);
}

/// Cubic convolution with a = -3/4 of a ramp, at a fraction t between two samples. (Only a = -1/2
/// would give t.)
double cubicOfRamp(double t) { return t + 0.5 * t * (1 - t) * (1 - 2 * t); }

TEST(Vit, PositionEmbeddingIsResampledWithDinosScaleFactor) {
  Vit vit(VitImpl::Options{.dim = 2, .depth = 0, .heads = 1});
  std::vector<float> ramp = {-5, -6};  // of the class token
  for (int i = 0; i < 37 * 37; ++i) {
    ramp.push_back(static_cast<float>(i % 37));
    ramp.push_back(static_cast<float>(i / 37));
  }
  put(*vit, "pos_embed", ramp);
  const std::vector<float> small = row(vit->positionEmbedding(30, 30));
  ASSERT_EQ(small.size(), 2u * 901);
  EXPECT_EQ(small[0], -5);
  EXPECT_EQ(small[1], -6);
  for (const int column : {1, 14, 20, 28}) {
    const double position = (column + 0.5) * 37 / 30.1 - 0.5;
    const double expected = std::floor(position) + cubicOfRamp(position - std::floor(position));
    const auto at = [&](int r, int c, int channel) {
      return small[static_cast<std::size_t>(2 * (1 + 30 * r + c) + channel)];
    };
    EXPECT_NEAR(at(3, column, 0), expected, 1e-4) << column;
    EXPECT_NEAR(at(column, 3, 1), expected, 1e-4) << column;
  }
  EXPECT_EQ(row(vit->positionEmbedding(37, 37)), ramp);
}

TEST(Vit, TapsShowPatchesInRowOrderAndTheClassToken) {
  Vit vit(VitImpl::Options{.dim = 2, .depth = 1, .heads = 1, .patch = 1, .grid = 2, .channels = 1});
  fill(*vit, "pos_embed", 0);
  put(*vit, "cls_token", {50, 60});
  put(*vit, "patch_embed.proj.weight", {1, 10});
  fill(*vit, "patch_embed.proj.bias", 0);
  fill(*vit, "blocks.0.ls1.gamma", 0);
  fill(*vit, "blocks.0.ls2.gamma", 0);
  const torch::Tensor image = torch::tensor({1.0f, 2.0f, 3.0f, 4.0f}).view({1, 1, 2, 2});
  const std::vector<VitImpl::Tap> taps = vit->forward(image, {0});
  EXPECT_EQ(row(taps[0].patches), (std::vector<float>{1, 2, 3, 4, 10, 20, 30, 40}));
  EXPECT_EQ(row(taps[0].cls), (std::vector<float>{50, 60}));
}

TEST(Vit, RegistersDoNotShowInTheTaps) {
  Vit vit(VitImpl::Options{
      .dim = 2, .depth = 1, .heads = 1, .patch = 1, .grid = 2, .channels = 1, .registers = 4});
  fill(*vit, "register_tokens", 99);
  fill(*vit, "pos_embed", 0);
  put(*vit, "patch_embed.proj.weight", {1, 10});
  fill(*vit, "patch_embed.proj.bias", 0);
  fill(*vit, "blocks.0.ls1.gamma", 0);
  fill(*vit, "blocks.0.ls2.gamma", 0);
  const torch::Tensor image = torch::tensor({1.0f, 2.0f, 3.0f, 4.0f}).view({1, 1, 2, 2});
  EXPECT_EQ(row(vit->forward(image, {0})[0].patches),
            (std::vector<float>{1, 2, 3, 4, 10, 20, 30, 40}));
}

TEST(DptResidualUnit, NormalisesByGroupBetweenConvolutions) {
  DptResidualUnit unit(kOneChannel);
  putIdentity(*unit, "conv1.weight");
  putIdentity(*unit, "conv2.weight");
  // (1, 1, 3, 7) has mean 3 and variance 6: norm and relu give (0, 0, 0, 4 / sqrt 6), the second
  // norm
  // (-1, -1, -1, 3) / sqrt 3, up to eps.
  const torch::Tensor x = torch::tensor({1.0f, 1.0f, 3.0f, 7.0f});
  const std::vector<float> y = row(unit->forward(x.view({1, 1, 1, 4})));
  const double unit_length = 1 / std::sqrt(3.0);
  EXPECT_NEAR(y[0], 1 - unit_length, 1e-4);
  EXPECT_NEAR(y[1], 1 - unit_length, 1e-4);
  EXPECT_NEAR(y[2], 3 - unit_length, 1e-4);
  EXPECT_NEAR(y[3], 7 + 3 * unit_length, 1e-4);
}

TEST(DptFusion, DeepestBlockHasNoFirstUnitAndAlignsCorners) {
  DptFusion fusion(kOneChannel, /*has_skip=*/false);
  EXPECT_FALSE(fusion->named_parameters().contains("res_conv_unit1.conv1.weight"));
  fill(*fusion, "res_conv_unit2.bn2.weight", 0);  // the unit hands its input on
  putIdentity(*fusion, "project.weight");
  put(*fusion, "project.bias", {100});
  const torch::Tensor x = torch::tensor({0.0f, 3.0f}).view({1, 1, 1, 2});
  const std::vector<float> y = row(fusion->forward(x, {}));
  EXPECT_EQ(y, (std::vector<float>{100, 101, 102, 103, 100, 101, 102, 103}));
}

TEST(DptFusion, FinerMapOfAnotherSizeIsResizedWithoutAlignedCorners) {
  DptFusion fusion(kOneChannel, /*has_skip=*/true);
  fill(*fusion, "res_conv_unit1.bn2.weight", 0);
  fill(*fusion, "res_conv_unit2.bn2.weight", 0);
  putIdentity(*fusion, "project.weight");
  fill(*fusion, "project.bias", 0);
  const torch::Tensor skip = torch::tensor({0.0f, 4.0f}).view({1, 1, 1, 2});
  const std::vector<float> y = row(fusion->forward(torch::zeros({1, 1, 1, 4}), skip));
  // (0, 4) becomes (0, 1, 3, 4), which is then read at i * 3 / 7.
  const std::array<double, 4> wide = {0, 1, 3, 4};
  for (std::size_t i = 0; i < 7; ++i) {
    const double position = static_cast<double>(i) * 3 / 7;
    const auto low = static_cast<std::size_t>(position);
    const double t = position - static_cast<double>(low);
    EXPECT_NEAR(y[i], (1 - t) * wide[low] + t * wide[low + 1], 1e-5);
  }
  EXPECT_FLOAT_EQ(y[7], 4);
}

TEST(FilmSdf, CodeOfCrispIsTheGainItselfThenTheShift) {
  FilmSdf decoder(FilmSdfImpl::Options{.layers = 2, .width = 1, .residual_gain = false});
  put(*decoder, "filmed_sdf.0.0.layer.weight", {1, -2, 3});
  put(*decoder, "filmed_sdf.0.0.layer.bias", {0.5f});
  put(*decoder, "filmed_sdf.1.0.layer.weight", {4});
  put(*decoder, "filmed_sdf.1.0.layer.bias", {-1});
  put(*decoder, "final_layer.weight", {3});
  put(*decoder, "final_layer.bias", {0.125f});
  const torch::Tensor code = torch::tensor({2.0f, 0.25f, -0.5f, 0.75f}).view({1, 4});
  const torch::Tensor point = torch::tensor({0.1f, 0.2f, 0.3f}).view({1, 1, 3});
  const double first = std::sin(2 * (0.1 - 0.4 + 0.9 + 0.5) + 0.25);
  const double second = std::sin(-0.5 * (4 * first - 1) + 0.75);
  EXPECT_NEAR(row(decoder->forward(point, code))[0], 3 * second + 0.125, 2e-6);
}

}  // namespace
}  // namespace hydrabench
