// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/semantic_fusion.h"

#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

std::unique_ptr<SemanticBlock> blockOf(const std::string& type, int first_k = 5,
                                       int num_labels = 64) {
  return makeSemanticBlock({type, num_labels, first_k}, 8);
}

class EverySemanticBlock : public testing::TestWithParam<const char*> {};

TEST_P(EverySemanticBlock, KnowsNothingBeforeTheFirstMeasurement) {
  const auto block = blockOf(GetParam());
  EXPECT_EQ(block->label(3), std::nullopt);
  EXPECT_EQ(block->share(3, 1), std::nullopt);
  block->fuse(4, 1, 1);
  EXPECT_EQ(block->label(3), std::nullopt);
  EXPECT_EQ(block->share(3, 1), std::nullopt);
  EXPECT_EQ(block->label(4), 1);
}
INSTANTIATE_TEST_SUITE_P(AllTypes, EverySemanticBlock,
                         testing::Values("single_label", "mle", "first_k", "binary"),
                         [](const auto& test) { return std::string(test.param); });

TEST(SemanticFusion, NoneKeepsNothing) { EXPECT_EQ(blockOf("none"), nullptr); }

TEST(SemanticFusion, NamesAnUnknownType) { EXPECT_THROW(blockOf("median"), InputError); }

TEST(SingleLabel, IsWornDownByOtherLabels) {
  const auto block = blockOf("single_label");
  block->fuse(0, 7, 3);  // 7 with 3
  block->fuse(0, 8, 2);  // 7 with 1
  EXPECT_EQ(block->label(0), 7);
  block->fuse(0, 7, 1);  // 7 with 2
  block->fuse(0, 8, 1);  // 7 with 1
  EXPECT_EQ(block->label(0), 7);
  block->fuse(0, 8, 4);  // 8 with 3
  EXPECT_EQ(block->label(0), 8);
  block->fuse(0, 9, 3);  // equal: 9 with 0
  EXPECT_EQ(block->label(0), 9);
  EXPECT_EQ(block->share(0, 9), 1.0f);
  EXPECT_EQ(block->share(0, 8), 0.0f);
}

TEST(SingleLabel, PassesOverTheUnknownLabel) {
  const auto block = blockOf("single_label");
  block->fuse(0, kUnknownLabel, 100);
  EXPECT_EQ(block->label(0), std::nullopt);
  block->fuse(0, 7, 1);
  block->fuse(0, kUnknownLabel, 100);
  EXPECT_EQ(block->label(0), 7);
}

TEST(Mle, MultipliesLikelihoodsPerHit) {
  const auto block = blockOf("mle", 5, 3);
  block->fuse(0, 1, 1);
  // Three labels: 0.9 against 0.1 and 0.1.
  EXPECT_NEAR(*block->share(0, 1), 0.9 / 1.1, 1e-6);
  EXPECT_NEAR(*block->share(0, 0), 0.1 / 1.1, 1e-6);
  block->fuse(0, 2, 5);
  block->fuse(0, 1, 0.1f);  // the weight of a hit has no say
  // 0.9 * 0.1 * 0.9, 0.1 * 0.9 * 0.1, 0.1 * 0.1 * 0.1.
  EXPECT_NEAR(*block->share(0, 1), 0.081 / 0.091, 1e-6);
  EXPECT_NEAR(*block->share(0, 2), 0.009 / 0.091, 1e-6);
  EXPECT_EQ(block->label(0), 1);
  block->fuse(0, 2, 1);  // two each: the lowest
  EXPECT_EQ(block->label(0), 1);
  block->fuse(0, 2, 1);
  EXPECT_EQ(block->label(0), 2);
}

TEST(Mle, SurvivesThousandsOfHitsAndPassesOverLabelsOutOfRange) {
  const auto block = blockOf("mle", 5, 3);
  block->fuse(0, 3, 1);
  block->fuse(0, -1, 1);
  EXPECT_EQ(block->label(0), std::nullopt);
  for (int i = 0; i < 5000; ++i) block->fuse(0, 2, 1);
  EXPECT_EQ(block->share(0, 2), 1.0f);
  EXPECT_EQ(block->share(0, 1), 0.0f);
}

TEST(FirstK, CountsOnlyTheFirstLabels) {
  const auto block = blockOf("first_k", 2);
  block->fuse(0, 7, 1);
  block->fuse(0, 8, 1);
  EXPECT_EQ(block->label(0), 7);  // one each: the first met
  block->fuse(0, 8, 1);
  for (int i = 0; i < 9; ++i) block->fuse(0, 9, 1);  // the third label finds no room
  EXPECT_EQ(block->label(0), 8);
  EXPECT_FLOAT_EQ(*block->share(0, 8), 2.0f / 3);
  EXPECT_EQ(block->share(0, 9), 0.0f);
  block->fuse(1, 9, 1);
  EXPECT_EQ(block->label(1), 9);
}

TEST(Binary, CountsTheObjectAgainstEverythingElse) {
  const auto block = blockOf("binary");
  block->fuse(0, 1, 0.2f);
  block->fuse(0, 0, 5);  // the unknown label is not the object
  block->fuse(0, 4, 5);
  EXPECT_FLOAT_EQ(*block->share(0, 1), 1.0f / 3);
  EXPECT_FLOAT_EQ(*block->share(0, 0), 2.0f / 3);
  EXPECT_EQ(block->label(0), 0);
  block->fuse(0, 1, 1);  // 2 of 4
  EXPECT_EQ(block->label(0), 1);
}

}  // namespace
}  // namespace hydrabench
