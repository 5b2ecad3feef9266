// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/material.h"

#include <set>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

TEST(Srgb, SurvivesTheWayToLinearLightAndBack) {
  for (int c = 16; c < 256; ++c) {  // the darkest levels lie closer than the table's steps
    const auto level = static_cast<std::uint8_t>(c);
    EXPECT_EQ(srgbFromLinear(linearFromSrgb({level, level, level})), (Rgb{level, level, level}));
  }
  EXPECT_EQ(srgbFromLinear({-1, 0, 2}), (Rgb{0, 0, 255}));
}

TEST(Material, PlainIsItsColourEverywhere) {
  const Material material{{200, 100, 50}, {0, 0, 0}, Material::Pattern::kPlain, 0.1, 0};
  EXPECT_EQ(evaluate(material, {1, 2, 3}, {0, 0, 1}), linearFromSrgb({200, 100, 50}));
}

TEST(Material, PatternsStayBetweenTheirColoursAndVary) {
  using enum Material::Pattern;
  for (Material::Pattern pattern : {kNoise, kWood, kStripes, kTiles, kLeaves, kFabric, kScreen}) {
    const Material material{{40, 80, 120}, {240, 200, 160}, pattern, 0.1, 0};
    const Vector3f low = linearFromSrgb(material.color);
    const Vector3f high = linearFromSrgb(material.second_color);
    Random random(4);
    std::set<float> reds;
    for (int i = 0; i < 2000; ++i) {
      const Vector3f p(static_cast<float>(random.uniform(-1, 1)),
                       static_cast<float>(random.uniform(-1, 1)),
                       static_cast<float>(random.uniform(-1, 1)));
      const Vector3f n = Vector3f::Unit(static_cast<int>(random.index(3)));
      const Vector3f color = evaluate(material, p, n);
      ASSERT_TRUE((color.array() >= low.array() - 1e-6f).all() &&
                  (color.array() <= high.array() + 1e-6f).all());
      EXPECT_EQ(color, evaluate(material, p, n));
      reds.insert(color.x());
    }
    EXPECT_GE(reds.size(), 2u);
  }
}

TEST(ValueNoise, IsContinuousAcrossCells) {
  for (float x : {-3.0f, 0.0f, 1.0f, 5.0f}) {
    const float before = valueNoise({x - 1e-4f, 0.3f, 0.7f});
    const float after = valueNoise({x + 1e-4f, 0.3f, 0.7f});
    EXPECT_NEAR(before, after, 1e-4f);
  }
}

}  // namespace
}  // namespace hydrabench
