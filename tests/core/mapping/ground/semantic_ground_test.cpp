// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/semantic_ground.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;

const LabelSpace kSpace{{{9, "road", {}, false, false},
                         {3, "grass", {}, false, false},
                         {4, "building", {}, false, false}}};

std::string faultOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SemanticGround, TakesTheNamedClasses) {
  SemanticGround ground({{"road", "grass"}}, kSpace);
  const std::vector<Eigen::Vector3f> points{
      {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}};
  const std::vector<Label> labels{3, 9, 4, kUnknownLabel, 9};
  const GroundMask mask = ground.segment({0, points, {}, {}, labels, 1});
  EXPECT_THAT(mask.classes,
              ElementsAre(GroundClass::kGround, GroundClass::kGround, GroundClass::kNonGround,
                          GroundClass::kNotJudged, GroundClass::kNotJudged));
  EXPECT_EQ(mask.num_invalid, 1u);
}

TEST(SemanticGround, NamesTheClassThatTheDatasetDoesNotHave) {
  EXPECT_EQ(faultOf([] {
              SemanticGround({{"road", "gras"}}, kSpace);
            }),
            "ground 'semantic', labels: 'gras' is no class of the dataset; did you mean 'grass'?");
  EXPECT_EQ(faultOf([] { SemanticGround({{"pavement"}}, kSpace); }),
            "ground 'semantic', labels: 'pavement' is no class of the dataset; expected some of: "
            "road, grass, building");
}

TEST(SemanticGround, NeedsLabels) {
  SemanticGround ground({{"road"}}, kSpace);
  const std::vector<Eigen::Vector3f> points{{1, 0, 0}};
  EXPECT_EQ(faultOf([&] {
              ground.segment({42, points, {}, {}, {}, 1});
            }),
            "the scan at 42 ns has no labels; expected 1, one per point: ground 'semantic' goes by "
            "them");
}

}  // namespace
}  // namespace hydrabench
