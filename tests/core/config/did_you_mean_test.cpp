// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/config/config_reader.h"

namespace hydrabench {
namespace {

TEST(DidYouMean, FindsTheNearestWord) {
  EXPECT_EQ(didYouMean("sed", {"seed", "speed", "preset"}), "seed");
  EXPECT_EQ(didYouMean("presett", {"seed", "speed", "preset"}), "preset");
}

TEST(DidYouMean, CountsASwapOfNeighboursAsOneSlip) {
  EXPECT_EQ(didYouMean("sede", {"side_view", "seed"}), "seed");
}

TEST(DidYouMean, ForgivesAMissingUnitCaseAndDashes) {
  EXPECT_EQ(didYouMean("max_range", {"min_range_m", "max_range_m"}), "max_range_m");
  EXPECT_EQ(didYouMean("Max-Range-M", {"max_range_m"}), "max_range_m");
}

TEST(DidYouMean, StaysSilentWhenNothingIsNear) {
  EXPECT_EQ(didYouMean("colour", {"seed", "depth_noise"}), "");
  EXPECT_EQ(didYouMean("seed", {}), "");
}

}  // namespace
}  // namespace hydrabench
