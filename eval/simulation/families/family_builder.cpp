// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/families/family_builder.h"

#include <algorithm>
#include <cmath>

namespace hydrabench {

ShapeInstance InstanceBuilder::finish(double thinnest_m, int yaw_symmetry) {
  ShapeInstance instance;
  instance.family = std::move(family_);
  std::vector<SdfPtr> children;
  for (const ShapePart& part : parts_) children.push_back(part.sdf);
  instance.parts = std::move(parts_);
  instance.sdf = unite(std::move(children));
  instance.yaw_symmetry = yaw_symmetry;
  instance.thinnest_m = thinnest_m;
  return instance;
}

Rgb darker(Rgb color, double factor) {
  const auto scale = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(c * factor), 0L, 255L));
  };
  return {scale(color.r), scale(color.g), scale(color.b)};
}

Material plain(Rgb color, double gloss) {
  Material material;
  material.color = color;
  material.second_color = color;
  material.gloss = gloss;
  return material;
}

Material metal(Parameters& parameters) {
  return plain(parameters.color({{176, 180, 184}, {200, 202, 204}, {46, 47, 50}}), 0.6);
}

Material wood(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kWood;
  material.color = parameters.color(
      {{196, 152, 104}, {214, 180, 136}, {150, 104, 66}, {108, 72, 48}, {224, 204, 172}});
  material.second_color = darker(material.color, 0.74);
  material.pattern_size_m = parameters.range(0.07, 0.14);
  material.gloss = 0.25;
  return material;
}

Material fabric(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kFabric;
  material.color = parameters.color({{62, 66, 74},
                                     {38, 40, 44},
                                     {52, 84, 128},
                                     {138, 48, 50},
                                     {72, 104, 84},
                                     {120, 122, 126},
                                     {190, 120, 50},
                                     {42, 110, 120}});
  material.second_color = darker(material.color, 0.7);
  material.pattern_size_m = 0.008;
  return material;
}

Material blackPlastic() { return plain({34, 35, 38}, 0.35); }

}  // namespace hydrabench
