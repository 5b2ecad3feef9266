// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kGoldenAngle = 2.399963;  ///< [rad] spreads branches and lumps evenly
/// Leaves are drawn as lumps of half a metre: nothing in a tree is finer than its branches.
constexpr double kTreePitch = 0.04;

Material foliage(Rgb color, double size) {
  Material material;
  material.pattern = Material::Pattern::kLeaves;
  material.color = color;
  material.second_color = darker(color, 0.55);
  material.pattern_size_m = size;
  return material;
}

Material bark(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kNoise;
  material.color = parameters.color({{112, 92, 74}, {92, 78, 66}, {136, 122, 106}});
  material.second_color = darker(material.color, 0.6);
  material.pattern_size_m = 0.10;
  return material;
}

/// Trunk, branches, and a crown of round lumps: some around the crown's middle, the others over the
/// upper part of its outline.
ShapeInstance buildBroadleafTree(Parameters& parameters) {
  InstanceBuilder builder("tree_broadleaf");
  const double height = parameters.range(4.2, 6.8);
  const double trunk = parameters.range(0.09, 0.16);
  const double clear = height * parameters.range(0.32, 0.42);  ///< below the crown
  const Vector3d crown(parameters.range(-0.2, 0.2), parameters.range(-0.2, 0.2),
                       0.5 * (height + clear));
  const double half_height = 0.5 * (height - clear);
  const double half_width = half_height * parameters.range(0.72, 0.95);
  const Vector3d fork(0.6 * crown.x(), 0.6 * crown.y(), clear + 0.1);
  std::vector<SdfPtr> wood = {
      frustum({0, 0, 0}, 1.5 * trunk, 1.05 * trunk, 0.3, 0.02),
      tube({{0, 0, 0.2}, {-0.3 * crown.x(), 0.4 * crown.y(), 0.55 * clear}, fork, crown},
           {1.12 * trunk, trunk, 0.85 * trunk, 0.5 * trunk})};
  std::vector<SdfPtr> lumps;
  const int count = parameters.count(13, 18);
  for (int i = 0; i < count; ++i) {
    // Points over the sphere (Fibonacci's), from the top down to well below the equator.
    const double z = 0.95 - 1.6 * (i + 0.5) / count;
    const double yaw = i * kGoldenAngle + parameters.range(-0.25, 0.25);
    const double across = std::sqrt(1 - z * z);
    const double size = half_width * parameters.range(0.34, 0.46);
    const Vector3d out(across * std::cos(yaw), across * std::sin(yaw), z);
    const Vector3d at =
        crown + Vector3d((half_width - size) * out.x(), (half_width - size) * out.y(),
                         (half_height - size) * out.z());
    lumps.push_back(sphere(at, size));
    if (i % 3 == 2) wood.push_back(taperedCapsule(fork, at, 0.5 * trunk, 0.04));
  }
  lumps.push_back(ellipsoid(crown, {0.7 * half_width, 0.7 * half_width, 0.75 * half_height}));
  builder.add(wood, bark(parameters));
  const Rgb leaf = parameters.color(
      {{84, 124, 56}, {66, 104, 50}, {112, 140, 62}, {76, 112, 70}, {168, 128, 52}});
  builder.add(lumps, foliage(leaf, parameters.range(0.25, 0.4)));
  ShapeInstance tree = builder.finish(0.08);
  tree.max_pitch_m = kTreePitch;
  return tree;
}

/// Tiers of drooping branches, each a cone.
ShapeInstance buildConifer(Parameters& parameters) {
  InstanceBuilder builder("tree_conifer");
  const double height = parameters.range(3.8, 7.2);
  const double trunk = parameters.range(0.08, 0.13);
  const double clear = parameters.range(0.35, 0.8);
  const double base = (height - clear) * parameters.range(0.24, 0.34);  ///< radius at the bottom
  builder.add({taperedCapsule({0, 0, 1.1 * trunk}, {0, 0, height - 0.4}, trunk, 0.05),
               cylinder({0, 0, 0}, {0, 0, 0.25}, 1.25 * trunk, 0.03)},
              bark(parameters));
  std::vector<SdfPtr> tiers;
  const int count = std::clamp(static_cast<int>(std::lround((height - clear) / 0.8)), 4, 8);
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / count;
    const double bottom = clear + share * (height - clear);
    const double rise = i + 1 == count ? height - bottom : 1.75 * (height - clear) / count;
    const double radius = base * (1 - 0.86 * share) * parameters.range(0.94, 1.06);
    // A cone whose rim hangs a little.
    const double inner = 0.55 * radius;
    const Polyline outline = {{-inner, 0.14 * rise}, {inner, 0.14 * rise},
                              {radius - 0.05, 0.05}, {0.62 * radius, 0.36 * rise},
                              {0.05, rise - 0.05},   {-0.05, rise - 0.05}};
    const double lean = parameters.range(0.0, 0.06);
    tiers.push_back(turned(revolution(polygonProfile(outline), 0.05),
                           Vector3d(std::cos(i * kGoldenAngle), std::sin(i * kGoldenAngle), 0),
                           lean, {0, 0, bottom}));
  }
  const Rgb needles = parameters.color({{52, 86, 58}, {44, 76, 62}, {70, 98, 62}, {86, 112, 104}});
  builder.add(tiers, foliage(needles, parameters.range(0.2, 0.32)));
  ShapeInstance tree = builder.finish(0.08);
  tree.max_pitch_m = kTreePitch;
  return tree;
}

}  // namespace

std::vector<ShapeFamily> treeFamilies() {
  return {makeFamily<buildBroadleafTree>("tree_broadleaf", "tree"),
          makeFamily<buildConifer>("tree_conifer", "tree")};
}

}  // namespace hydrabench
