// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

Material upholstery(Parameters& parameters) {
  if (parameters.chance(0.3)) {  // leather
    Material material =
        plain(parameters.color({{92, 54, 36}, {40, 36, 36}, {214, 204, 188}, {126, 74, 44}}), 0.45);
    material.pattern = Material::Pattern::kNoise;
    material.second_color = darker(material.color, 0.86);
    material.pattern_size_m = 0.05;
    return material;
  }
  Material material;
  material.pattern = Material::Pattern::kFabric;
  material.color = parameters.color({{120, 124, 132},
                                     {178, 168, 150},
                                     {74, 92, 116},
                                     {92, 112, 92},
                                     {150, 82, 66},
                                     {196, 160, 84},
                                     {84, 80, 84}});
  material.second_color = darker(material.color, 0.76);
  material.pattern_size_m = 0.010;
  return material;
}

/// Arm with a box or rolled top; `y` is the side towards the seat, `side` which side it is.
SdfPtr arm(double side, double y, double width, double depth, double bottom, double top,
           bool rolled) {
  const double middle = side * (y + 0.5 * width);
  if (!rolled) {
    return standingBox({0, middle, bottom}, {depth, width, top - bottom},
                       std::min(0.045, 0.4 * width));
  }
  const double radius = 0.62 * width;
  const double z = top - radius;
  return smoothUnion(
      standingBox({0, middle, bottom}, {depth - 0.02, 0.8 * width, z - bottom}, 0.02),
      cylinder({-0.5 * depth, middle, z}, {0.5 * depth, middle, z}, radius, 0.03), 0.03);
}

constexpr const char* kNames[] = {"couch_1_seat", "couch_2_seats", "couch_3_seats"};

ShapeInstance buildCouch(Parameters& parameters, int seats) {
  InstanceBuilder builder(kNames[seats - 1]);
  const double seat_width = parameters.range(0.54, 0.68);
  const double depth = parameters.range(0.78, 0.95);
  const double seat_top = parameters.range(0.40, 0.47);
  const double back_top = parameters.range(0.74, 0.94);
  const double arm_width = parameters.range(0.10, 0.22);
  const double arm_top = seat_top + parameters.range(0.12, 0.24);
  const double foot = parameters.range(0.05, 0.15);
  const double cushion = parameters.range(0.13, 0.18);
  const double back_thickness = parameters.range(0.12, 0.18);
  const double puff = parameters.range(0.035, 0.06);
  const bool rolled = parameters.chance(0.35);
  const bool high_back = parameters.chance(0.5);  ///< cushions stand above the back
  const double inner = seats * seat_width;
  const double base_top = seat_top - 0.7 * cushion;
  const double rear = -0.5 * depth;
  const Material cover = upholstery(parameters);
  Material cushions = cover;
  cushions.color = darker(cover.color, 1.08);

  // Frame: plinth, back and arms.
  std::vector<SdfPtr> frame = {
      standingBox({0, 0, foot}, {depth - 0.01, inner + 0.04, base_top - foot}, 0.02)};
  const double frame_top = high_back ? back_top - 0.10 : back_top;
  const double back_lean = parameters.range(0.03, 0.12);
  frame.push_back(intersect(
      turned(standingBox({0.5 * back_thickness, 0, -0.1},
                         {back_thickness, inner + 0.04, frame_top - foot + 0.1}, 0.04),
             Vector3d::UnitY(), -back_lean, {rear + back_lean * (frame_top - foot), 0, foot}),
      standingBox({0, 0, foot}, {3, inner + 0.04, 2}, 0)));
  for (const double side : {-1.0, 1.0}) {
    frame.push_back(arm(side, 0.5 * inner, arm_width, depth, foot, arm_top, rolled));
  }
  builder.add(frame, cover);

  // One seat and one back cushion for every seat; their rounded edges make the seams.
  const double cushion_depth = depth - back_thickness - 0.5 * back_lean * 0.5;
  const double front = 0.5 * depth + parameters.range(-0.01, 0.03);
  std::vector<SdfPtr> soft;
  const double pillow = parameters.range(0.11, 0.16);
  for (int i = 0; i < seats; ++i) {
    const double y = (i - 0.5 * (seats - 1)) * seat_width;
    const SdfPtr block =
        standingBox({front - 0.5 * cushion_depth, y, seat_top - cushion},
                    {cushion_depth, seat_width + 0.002, cushion}, std::min(puff, 0.4 * cushion));
    // A slight crown.
    const SdfPtr crown = ellipsoid({front - 0.5 * cushion_depth, y, seat_top - 0.02},
                                   {0.42 * cushion_depth, 0.42 * seat_width, 0.035});
    soft.push_back(smoothUnion(block, crown, 0.03));
    const double height = back_top - seat_top + 0.02;
    const SdfPtr back =
        smoothUnion(roundedBox({0, 0, 0.5 * height}, {pillow, seat_width - 0.01, height},
                               std::min(0.05, 0.45 * pillow)),
                    ellipsoid({0.5 * pillow - 0.02, 0, 0.48 * height},
                              {0.04, 0.38 * seat_width, 0.36 * height}),
                    0.03);
    soft.push_back(
        turned(back, Vector3d::UnitY(), -back_lean - 0.08,
               {rear + back_thickness + back_lean * (frame_top - foot) * 0.8 + 0.4 * pillow, y,
                seat_top - 0.02}));
  }
  builder.add(soft, cushions);

  std::vector<SdfPtr> feet;
  const double fx = 0.5 * depth - 0.08;
  const double fy = 0.5 * inner + 0.5 * arm_width - 0.03;
  const bool round_feet = parameters.chance(0.6);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const Vector3d at(sx * fx, sy * fy, 0);
      feet.push_back(round_feet ? frustum(at, 0.016, 0.026, foot + 0.03, 0.004)
                                : standingBox(at, {0.06, 0.06, foot + 0.03}, 0.005));
    }
  }
  builder.add(feet, parameters.chance(0.6) ? wood(parameters) : metal(parameters));
  return builder.finish(0.032);
}

template <int kSeats>
ShapeInstance build(Parameters& parameters) {
  return buildCouch(parameters, kSeats);
}

}  // namespace

std::vector<ShapeFamily> couchFamilies() {
  return {makeFamily<build<1>>(kNames[0], "couch"), makeFamily<build<2>>(kNames[1], "couch"),
          makeFamily<build<3>>(kNames[2], "couch")};
}

}  // namespace hydrabench
