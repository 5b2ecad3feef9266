// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/torch_weights.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

/// Parameters linear.{weight,bias}, norm.{weight,bias}; buffers norm.running_*, and an int64 count.
torch::nn::Sequential smallModule(int inputs = 3) {
  return torch::nn::Sequential(
      {{"linear", torch::nn::Linear(inputs, 4).ptr()}, {"norm", torch::nn::BatchNorm1d(4).ptr()}});
}

TEST(TorchWeights, ComeBackAsTheyWereSaved) {
  const TemporaryFolder folder;
  auto a = smallModule();
  a->forward(torch::randn({8, 3}));  // moves the running mean and the count
  saveWeights(*a, folder / "w", {{"steps", "10"}});
  auto b = smallModule();
  loadWeights(*b, folder / "w");
  for (const auto& item : a->named_parameters()) {
    EXPECT_TRUE(torch::equal(item.value(), b->named_parameters()[item.key()])) << item.key();
  }
  for (const auto& item : a->named_buffers()) {
    EXPECT_TRUE(torch::equal(item.value(), b->named_buffers()[item.key()])) << item.key();
  }
  EXPECT_EQ(SafetensorsFile::read(folder / "w").metadata().at("steps"), "10");
}

TEST(TorchWeights, HalfTheBytesKeepThreeDigits) {
  const TemporaryFolder folder;
  auto a = smallModule();
  saveWeights(*a, folder / "w", {}, TensorType::kF16);
  auto b = smallModule();
  loadWeights(*b, folder / "w");
  const torch::Tensor before = a->named_parameters()["linear.weight"];
  const torch::Tensor after = b->named_parameters()["linear.weight"];
  EXPECT_EQ(after.scalar_type(), torch::kFloat32);
  EXPECT_TRUE(torch::equal(after, before.to(torch::kFloat16).to(torch::kFloat32)));
  EXPECT_EQ(SafetensorsFile::read(folder / "w").tensors().at("linear.weight").bytes.size(), 24u);
}

TEST(TorchWeights, WhatDoesNotFitNamesFileTensorAndShapes) {
  const TemporaryFolder folder;
  auto module = smallModule();
  const torch::Tensor before = module->named_parameters()["linear.weight"].clone();
  const auto complaint = [&] {
    const std::string message = messageOf<InputError>([&] { loadWeights(*module, folder / "w"); });
    EXPECT_THAT(message, HasSubstr((folder / "w").string()));
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_TRUE(torch::equal(before, module->named_parameters()["linear.weight"]));
    return message;
  };
  EXPECT_THAT(complaint(), HasSubstr("w"));  // there is no file

  saveWeights(*smallModule(5), folder / "w");
  EXPECT_THAT(complaint(), EndsWith(": linear.weight: shape [4, 5], the network expects [4, 3]"));

  torch::nn::Sequential fewer({{"linear", torch::nn::Linear(3, 4).ptr()}});
  saveWeights(*fewer, folder / "w");
  EXPECT_THAT(complaint(), EndsWith(": norm.bias: missing, the network expects it with shape [4]"));

  auto more = smallModule();
  more->push_back("extra", torch::nn::Linear(4, 2));
  saveWeights(*more, folder / "w");
  EXPECT_THAT(complaint(), EndsWith(": extra.bias: shape [2], but the network has no such tensor"));

  auto broken = smallModule();
  {
    const torch::NoGradGuard no_grad;
    broken->named_parameters()["linear.bias"][1] = std::numeric_limits<float>::quiet_NaN();
  }
  saveWeights(*broken, folder / "w");
  EXPECT_THAT(complaint(), HasSubstr(": linear.bias: has numbers that are not finite"));

  saveWeights(*module, folder / "w");
  const std::string whole = readText(folder / "w");
  writeText(folder / "w", std::string_view(whole).substr(0, whole.size() - 5));
  EXPECT_THAT(complaint(), HasSubstr("expected within the"));
}

}  // namespace
}  // namespace hydrabench
