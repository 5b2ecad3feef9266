// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/class_mask.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(ClassMask, NamesThatTheLabelSpaceDoesNotHaveArePassedOver) {
  const LabelSpace space{{{3, "floor", {}, false, false}, {20, "human", {}, false, false}}};
  EXPECT_THAT(labelsNamed({"dog", "human"}, space), testing::ElementsAre(20));
}

TEST(ClassMask, AddsThePixelsOfTheClasses) {
  Image<Label> labels(3, 2, 3);
  labels(1, 0) = 20;
  labels(2, 1) = 21;
  Image<std::uint8_t> mask(3, 2);
  mask(0, 1) = 7;
  maskClasses(labels, {}, mask);
  EXPECT_THAT(std::vector(mask.begin(), mask.end()), testing::ElementsAre(0, 0, 0, 7, 0, 0));
  maskClasses(labels, {20, 21}, mask);
  EXPECT_THAT(std::vector(mask.begin(), mask.end()), testing::ElementsAre(0, 255, 0, 7, 0, 255));
}

}  // namespace
}  // namespace hydrabench
