// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Material paintedSteel(Parameters& parameters) {
  return plain(
      parameters.color({{92, 96, 100}, {44, 46, 50}, {150, 154, 158}, {38, 62, 52}, {70, 84, 96}}),
      0.4);
}

ShapeInstance buildBollard(Parameters& parameters) {
  InstanceBuilder builder("bollard");
  const double height = parameters.range(0.72, 1.1);
  const bool slim = parameters.chance(0.6);
  const double r = slim ? parameters.range(0.048, 0.068) : parameters.range(0.085, 0.12);
  const Material body = paintedSteel(parameters);
  const Material band =
      plain(parameters.color({{232, 234, 234}, {222, 182, 44}, {196, 46, 40}}), 0.5);
  std::vector<SdfPtr> pieces = {cylinder({0, 0, 0}, {0, 0, 0.02}, 1.5 * r, 0.006)};
  if (parameters.chance(0.5)) {  // dome
    pieces.push_back(cylinder({0, 0, 0}, {0, 0, height - 0.6 * r}, r, 0.002));
    pieces.push_back(intersect(ellipsoid({0, 0, height - 0.6 * r - 0.01}, {r, r, 0.6 * r + 0.01}),
                               standingBox({0, 0, height - 0.6 * r - 0.03}, {1, 1, 1}, 0)));
  } else {  // neck and head
    pieces.push_back(cylinder({0, 0, 0}, {0, 0, height - 0.05}, r, 0.010));
    pieces.push_back(cylinder({0, 0, height - 0.1}, {0, 0, height - 0.02}, 0.7 * r, 0.004));
    pieces.push_back(cylinder({0, 0, height - 0.034}, {0, 0, height}, 1.08 * r, 0.010));
  }
  builder.add(pieces, body);
  const int bands = parameters.count(1, 2);
  std::vector<SdfPtr> rings;
  for (int i = 0; i < bands; ++i) {
    const double z = height - 0.2 - 0.16 * i;
    rings.push_back(cylinder({0, 0, z - 0.04}, {0, 0, z + 0.04}, r + 0.003, 0.002));
  }
  builder.add(rings, band);
  return builder.finish(0.02, 0);
}

/// Street lamp with one arm to the front; or a lantern on a post.
ShapeInstance buildLampPole(Parameters& parameters) {
  InstanceBuilder builder("lamp_pole");
  const Material steel = paintedSteel(parameters);
  const Material light = plain({250, 244, 220}, 0.6);
  const double foot = parameters.range(0.085, 0.11);
  if (parameters.chance(0.65)) {
    const double height = parameters.range(4.6, 6.6);
    const double reach = parameters.range(0.7, 1.3);
    const double bend = parameters.range(0.5, 0.8);  ///< height of the curved part
    std::vector<Vector3d> points = {{0, 0, 0.0}, {0, 0, height - bend}};
    std::vector<double> radii = {0.8 * foot, 0.6 * foot};
    constexpr int kSteps = 6;
    for (int i = 1; i <= kSteps; ++i) {
      const double angle = 0.5 * kPi * i / kSteps;
      points.push_back(
          {0.7 * reach * (1 - std::cos(angle)), 0, height - bend + bend * std::sin(angle) - 0.045});
      radii.push_back((0.6 - 0.02 * i) * foot);
    }
    points.push_back({reach, 0, height - 0.045});
    radii.push_back(0.47 * foot);
    const double head = parameters.range(0.55, 0.8);
    builder.add(
        {intersect(tube(points, radii), standingBox({0, 0, 0}, {9, 1, 9}, 0)),
         cylinder({0, 0, 0}, {0, 0, parameters.range(0.7, 1.2)}, foot, 0.01),
         cylinder({0, 0, 0}, {0, 0, 0.03}, 1.7 * foot, 0.008),
         intersect(ellipsoid({reach + 0.4 * head, 0, height - 0.08}, {0.5 * head, 0.15, 0.08}),
                   standingBox({reach, 0, height - 0.095}, {4, 1, 0.5}, 0))},
        steel);
    builder.add(
        {roundedBox({reach + 0.42 * head, 0, height - 0.098}, {0.6 * head, 0.2, 0.03}, 0.01)},
        light);
    return builder.finish(0.03);
  }
  const double height = parameters.range(3.2, 4.2);
  const double lantern = parameters.range(0.40, 0.52);
  const double r = parameters.range(0.15, 0.2);
  const double under = height - lantern;
  std::vector<SdfPtr> post = {frustum({0, 0, 0}, 0.62 * foot, 0.42 * foot, under + 0.02, 0.002),
                              cylinder({0, 0, 0}, {0, 0, 0.6}, foot, 0.012),
                              cylinder({0, 0, 0}, {0, 0, 0.04}, 1.6 * foot, 0.01),
                              frustum({0, 0, under - 0.03}, 0.05, 0.75 * r, 0.06, 0.008)};
  if (parameters.chance(0.5)) {  // globe
    builder.add({sphere({0, 0, under + 0.5 * lantern}, 0.5 * lantern)}, light);
  } else {
    builder.add({frustum({0, 0, under + 0.02}, 0.68 * r, r, lantern - 0.12, 0.008)}, light);
    post.push_back(frustum({0, 0, height - 0.11}, 1.3 * r, 0.3 * r, 0.11, 0.01));
  }
  builder.add(post, steel);
  return builder.finish(0.03, 0);
}

/// Flat outline in the y-z plane, its face to the front.
SdfPtr plate(const SdfProfilePtr& outline, double x, double thickness, double z) {
  return moved(extrusion(outline, Axis::kX, thickness, 0.002), {x, 0, z});
}

Polyline regularPolygon(int sides, double radius, double first_angle) {
  Polyline corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = first_angle + 2 * kPi * i / sides;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

ShapeInstance buildSignPost(Parameters& parameters) {
  InstanceBuilder builder("sign_post");
  const double height = parameters.range(2.3, 3.0);
  const double post = parameters.range(0.026, 0.036);
  const double r = parameters.range(0.27, 0.38);  ///< of the sign
  const double z = height - r - 0.04;
  builder.add({cylinder({0, 0, 0}, {0, 0, height}, post, 0.004),
               cylinder({0, 0, 0}, {0, 0, 0.1}, 2.2 * post, 0.01)},
              plain({158, 162, 166}, 0.5));
  const Material red = plain({190, 32, 36}, 0.4);
  const Material white = plain({238, 240, 240}, 0.4);
  const Material blue = plain({28, 84, 164}, 0.4);
  constexpr double kThickness = 0.026;
  const double back = post - 0.008;  ///< x of the plate's back: clasped to the post
  // Each layer stands a little before the one below.
  const double step = 0.006;
  const auto layer = [&](const SdfProfilePtr& outline, int level, const Material& material) {
    const double thickness = kThickness + level * step;
    builder.add({plate(outline, back + 0.5 * thickness, thickness, z)}, material);
  };
  switch (parameters.choice(5)) {
    case 0:  // stop
      layer(polygonProfile(regularPolygon(8, r, kPi / 8)), 0, white);
      layer(polygonProfile(regularPolygon(8, 0.92 * r, kPi / 8)), 1, red);
      layer(rectangleProfile({0, 0}, {1.3 * r, 0.34 * r}, 0.01), 2, white);
      break;
    case 1:  // speed limit
      layer(circleProfile({0, 0}, r), 0, red);
      layer(circleProfile({0, 0}, 0.78 * r), 1, white);
      layer(rectangleProfile({-0.26 * r, 0}, {0.3 * r, 0.66 * r}, 0.05), 2, plain({24, 24, 26}));
      layer(rectangleProfile({0.26 * r, 0}, {0.3 * r, 0.66 * r}, 0.05), 2, plain({24, 24, 26}));
      break;
    case 2:  // no entry
      layer(circleProfile({0, 0}, r), 0, red);
      layer(rectangleProfile({0, 0}, {1.4 * r, 0.34 * r}, 0.01), 1, white);
      break;
    case 3:  // parking
      layer(rectangleProfile({0, 0}, {1.7 * r, 1.7 * r}, 0.03), 0, blue);
      layer(strokeProfile({{-0.28 * r, -0.5 * r},
                           {-0.28 * r, 0.5 * r},
                           {0.1 * r, 0.5 * r},
                           {0.32 * r, 0.36 * r},
                           {0.32 * r, 0.16 * r},
                           {0.1 * r, 0.02 * r},
                           {-0.28 * r, 0.02 * r}},
                          0.1 * r),
            1, white);
      break;
    default:  // give way
      layer(polygonProfile(regularPolygon(3, 1.15 * r, -0.5 * kPi)), 0, red);
      layer(polygonProfile(regularPolygon(3, 0.7 * r, -0.5 * kPi)), 1, white);
  }
  return builder.finish(kThickness);
}

}  // namespace

std::vector<ShapeFamily> streetFamilies() {
  return {makeFamily<buildLampPole>("lamp_pole", "pole"),
          makeFamily<buildBollard>("bollard", "bollard"),
          makeFamily<buildSignPost>("sign_post", "sign")};
}

}  // namespace hydrabench
