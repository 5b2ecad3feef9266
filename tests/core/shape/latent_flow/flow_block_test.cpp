// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/flow_block.h"

#include <gtest/gtest.h>

#include "core/shape/crisp/torch_runtime.h"

namespace hydrabench {
namespace {

constexpr int kDim = 24;

double difference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>();
}

class FlowLayers : public ::testing::Test {
 protected:
  FlowLayers() {
    keepTorchOnThisThread();
    torch::manual_seed(4);
  }
  torch::NoGradGuard no_grad_;
};

TEST_F(FlowLayers, ABlockIsTheIdentityAtFirst) {
  FlowBlock block(kDim, 4);
  const torch::Tensor tokens = torch::randn({2, 5, kDim});
  EXPECT_EQ(difference(block(tokens, torch::randn({2, kDim})), tokens), 0);
}

TEST_F(FlowLayers, ABlockKnowsItsTokensByNothingButTheirValues) {
  FlowBlock block(kDim, 4);
  for (torch::Tensor& value : block->parameters()) value.normal_(0, 0.2);
  const torch::Tensor tokens = torch::randn({1, 5, kDim});
  const torch::Tensor modulation = torch::randn({1, kDim});
  const torch::Tensor order = torch::tensor({3, 0, 4, 1, 2});
  EXPECT_LE(difference(block(tokens.index_select(1, order), modulation),
                       block(tokens, modulation).index_select(1, order)),
            1e-4);
  EXPECT_GE(difference(block(tokens, modulation), block(tokens, -modulation)), 0.1);
}

TEST_F(FlowLayers, ABlockAttendsToItsContextInAnyOrder) {
  FlowBlock block(kDim, 4, 16);
  for (torch::Tensor& value : block->parameters()) value.normal_(0, 0.2);
  const torch::Tensor tokens = torch::randn({1, 3, kDim});
  const torch::Tensor modulation = torch::randn({1, kDim});
  const torch::Tensor context = torch::randn({1, 7, 16});
  const torch::Tensor out = block(tokens, modulation, context);
  EXPECT_LE(difference(out, block(tokens, modulation, context.flip({1}))), 1e-4);
  EXPECT_GE(difference(out, block(tokens, modulation, context + 1)), 0.05);
  EXPECT_GE(difference(out, block(tokens, modulation)), 0.05);
}

TEST_F(FlowLayers, AContextServesItsNeighbours) {
  CrossAttention attention(kDim, 16, 4);
  const torch::Tensor tokens = torch::randn({6, 3, kDim});
  const torch::Tensor context = torch::randn({2, 7, 16});
  EXPECT_LE(
      difference(attention(tokens, context), attention(tokens, context.repeat_interleave(3, 0))),
      1e-5);
}

TEST_F(FlowLayers, AHeadSaysNothingAtFirst) {
  FlowHead head(kDim, 6);
  const torch::Tensor out = head(torch::randn({2, 5, kDim}), torch::randn({2, kDim}));
  EXPECT_EQ(out.sizes(), (std::vector<std::int64_t>{2, 5, 6}));
  EXPECT_EQ(out.abs().max().item<double>(), 0);
}

TEST_F(FlowLayers, TimesAreToldApart) {
  TimeEmbedding embedding(kDim);
  const torch::Tensor features = embedding(torch::tensor({0.0f, 0.02f, 0.5f, 1.0f}));
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < i; ++k) EXPECT_GE(difference(features[i], features[k]), 1e-2) << i << k;
  }
}

}  // namespace
}  // namespace hydrabench
