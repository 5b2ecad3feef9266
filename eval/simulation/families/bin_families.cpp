// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

/// Open wastebasket: a sheet of constant thickness, bent up from the floor.
ShapeInstance buildSmallBin(Parameters& parameters) {
  InstanceBuilder builder("bin_small");
  const double height = parameters.range(0.26, 0.40);
  const double top = parameters.range(0.115, 0.165);
  const double bottom = top * parameters.range(0.70, 0.95);
  constexpr double kHalfWall = 0.005;
  Material material = plain(parameters.color({{58, 60, 64},
                                              {40, 84, 140},
                                              {150, 154, 158},
                                              {188, 52, 44},
                                              {226, 226, 222},
                                              {70, 120, 80}}),
                            0.3);
  const int style = parameters.choice(3);
  if (style == 2) {  // rounded box
    const double x = 2 * top * parameters.range(0.7, 0.8);
    const double y = 2 * top;
    const auto block = [&](double inset, double z) {
      return moved(extrusion(rectangleProfile({0, 0}, {x - 2 * inset, y - 2 * inset}, 0.045),
                             Axis::kZ, height, 0.004),
                   {0, 0, 0.5 * height + z});
    };
    builder.add({subtract(block(0, 0), block(2 * kHalfWall, 2 * kHalfWall)),
                 subtract(moved(extrusion(rectangleProfile({0, 0}, {x + 0.02, y + 0.02}, 0.05),
                                          Axis::kZ, 0.024, 0.006),
                                {0, 0, height - 0.012}),
                          block(0.009, 0.01))},
                material);
    return builder.finish(2 * kHalfWall, 2);
  }
  const Polyline sheet = {{-bottom, kHalfWall}, {bottom, kHalfWall}, {top, height - kHalfWall}};
  std::vector<SdfPtr> pieces = {revolution(strokeProfile(sheet, kHalfWall)),
                                torus({0, 0, height - 0.009}, top, 0.009)};
  if (style == 1) {  // wire mesh with a solid foot ring
    material.pattern = Material::Pattern::kTiles;
    material.second_color = darker(material.color, 0.45);
    material.pattern_size_m = 0.014;
    pieces.push_back(torus({0, 0, 0.009}, bottom, 0.009));
  }
  builder.add(pieces, material);
  if (parameters.chance(0.4)) {  // liner turned over the rim
    const Polyline bag = {{top - 0.012, height - 0.10},
                          {top - 0.006, height + 0.004},
                          {top + 0.017, height + 0.002},
                          {top + 0.016, height - 0.05}};
    builder.add({revolution(strokeProfile(smoothCurve(bag, 3), 0.0055))},
                plain({212, 216, 222}, 0.3));
  }
  return builder.finish(2 * kHalfWall, 0);
}

/// Round step bin with a pedal and a domed lid.
void addPedalBin(Parameters& parameters, InstanceBuilder& builder) {
  const double height = parameters.range(0.56, 0.72);
  const double radius = parameters.range(0.145, 0.19);
  const bool steel = parameters.chance(0.6);
  const Material body =
      steel ? plain({188, 190, 194}, 0.7)
            : plain(parameters.color({{52, 54, 58}, {222, 222, 220}, {160, 44, 42}}), 0.4);
  const double lid = height - 0.06;
  builder.add({cylinder({0, 0, 0.03}, {0, 0, lid - 0.012}, radius, 0.006)}, body);
  builder.add({cylinder({0, 0, 0}, {0, 0, 0.045}, radius + 0.006, 0.008),
               cylinder({0, 0, lid - 0.03}, {0, 0, lid - 0.004}, radius - 0.006, 0.004),
               roundedBox({radius + 0.03, 0, 0.024}, {0.10, 0.075, 0.022}, 0.008),
               roundedBox({-radius - 0.008, 0, lid - 0.02}, {0.05, 0.09, 0.06}, 0.012)},
              blackPlastic());
  const SdfPtr dome = intersect(ellipsoid({0, 0, lid}, {radius + 0.004, radius + 0.004, 0.06}),
                                standingBox({0, 0, lid - 0.008}, {2, 2, 1}, 0));
  builder.add(
      {unite({dome, cylinder({0, 0, lid - 0.01}, {0, 0, lid + 0.012}, radius + 0.005, 0.005)})},
      body);
}

/// Box with a pitched lid whose front flap swings.
void addSwingBin(Parameters& parameters, InstanceBuilder& builder) {
  const double height = parameters.range(0.62, 0.84);
  const double x = parameters.range(0.27, 0.34);
  const double y = parameters.range(0.34, 0.44);
  const double lid = height - parameters.range(0.16, 0.20);
  const Material body =
      plain(parameters.color({{60, 62, 66}, {220, 220, 216}, {120, 124, 128}}), 0.3);
  const Material top =
      plain(parameters.color({{40, 42, 46}, {44, 92, 150}, {66, 128, 74}, {206, 168, 44}}), 0.35);
  builder.add({moved(extrusion(rectangleProfile({0, 0}, {x, y}, 0.04), Axis::kZ, lid, 0.008),
                     {0, 0, 0.5 * lid})},
              body);
  const double h = height - lid;
  const double r = 0.5 * x + 0.008;
  const SdfPtr roof = moved(
      extrusion(polygonProfile({{-r, 0}, {r, 0}, {r, 0.05}, {0.045, h}, {-0.045, h}, {-r, 0.05}}),
                Axis::kY, y + 0.016, 0.010),
      {0, 0, lid - 0.01});
  builder.add({roof}, top);
  // The flap, a panel proud of the slope at the front.
  const double slope = std::atan2(h - 0.05, r - 0.045);
  builder.add(
      {turned(
          roundedBox({0, 0, 0}, {0.62 * std::hypot(h - 0.05, r - 0.045), 0.7 * y, 0.022}, 0.006),
          Vector3d::UnitY(), slope, {0.5 * (r + 0.045), 0, lid - 0.01 + 0.5 * (h + 0.05)})},
      plain(darker(top.color, 0.7), 0.4));
}

/// Recycling station: box with a coloured lid and a slot.
void addRecyclingBin(Parameters& parameters, InstanceBuilder& builder) {
  const double height = parameters.range(0.66, 0.86);
  const double x = parameters.range(0.36, 0.44);
  const double y = parameters.range(0.32, 0.42);
  const Material body =
      plain(parameters.color({{176, 178, 180}, {74, 78, 84}, {232, 232, 228}}), 0.35);
  const Material top =
      plain(parameters.color({{38, 96, 168}, {64, 132, 66}, {216, 178, 40}, {170, 50, 46}}), 0.4);
  builder.add({standingBox({0, 0, 0.02}, {x, y, height - 0.09}, 0.018)}, body);
  builder.add({standingBox({0, 0, 0}, {x - 0.03, y - 0.03, 0.05}, 0.008)}, blackPlastic());
  const SdfPtr lid = standingBox({0, 0, height - 0.08}, {x + 0.016, y + 0.016, 0.08}, 0.024);
  const SdfPtr opening = parameters.chance(0.5)
                             ? cylinder({0, 0, height - 0.05}, {0, 0, height + 0.1}, 0.085, 0.0)
                             : roundedBox({0, 0, height}, {0.09, 0.72 * y, 0.1}, 0.03);
  builder.add({subtract(lid, opening)}, top);
  builder.add(
      {standingBox({0.5 * x - 0.004, 0, 0.48 * height}, {0.02, 0.5 * y, 0.22 * height}, 0.006)},
      top);
}

ShapeInstance buildLargeBin(Parameters& parameters) {
  InstanceBuilder builder("bin_large");
  switch (parameters.choice(3)) {
    case 0:
      addPedalBin(parameters, builder);
      break;
    case 1:
      addSwingBin(parameters, builder);
      break;
    default:
      addRecyclingBin(parameters, builder);
  }
  return builder.finish(0.02);
}

ShapeInstance buildWaterDispenser(Parameters& parameters) {
  InstanceBuilder builder("water_dispenser");
  const double height = parameters.range(0.88, 1.02);  ///< of the cabinet
  const double x = parameters.range(0.29, 0.34);
  const double y = parameters.range(0.28, 0.34);
  const double front = 0.5 * x;
  const Material body =
      plain(parameters.color({{236, 236, 234}, {206, 210, 214}, {70, 74, 80}}), 0.4);
  const double niche_top = height - parameters.range(0.09, 0.13);
  const double niche = parameters.range(0.24, 0.30);
  const SdfPtr cabinet = standingBox({0, 0, 0}, {x, y, height}, 0.022);
  const SdfPtr recess =
      roundedBox({front, 0, niche_top - 0.5 * niche}, {0.20, y - 0.07, niche}, 0.02);
  builder.add({subtract(cabinet, recess)}, body);
  // Drip tray, taps and their colour marks.
  const double floor_z = niche_top - niche;
  builder.add({roundedBox({front - 0.03, 0, floor_z + 0.008}, {0.13, y - 0.10, 0.024}, 0.006)},
              blackPlastic());
  const double tap_x = front - 0.055;
  const double tap_z = niche_top - 0.055;
  for (const double side : {-1.0, 1.0}) {
    const double tap_y = side * 0.055;
    builder.add(
        {cylinder({front - 0.11, tap_y, tap_z}, {tap_x + 0.012, tap_y, tap_z}, 0.014, 0.003),
         cylinder({tap_x, tap_y, tap_z + 0.012}, {tap_x, tap_y, tap_z - 0.045}, 0.0125, 0.003)},
        plain({232, 232, 230}, 0.5));
    builder.add({roundedBox({tap_x + 0.010, tap_y, tap_z + 0.022}, {0.05, 0.03, 0.022}, 0.006)},
                plain(side < 0 ? Rgb{44, 96, 190} : Rgb{196, 48, 44}, 0.4));
  }
  // Bottle, upside down, its neck in the collar.
  const double r = parameters.range(0.125, 0.14);
  const double bottle = parameters.range(0.34, 0.42);
  const double z = height + 0.012;
  const Polyline outline = {{-0.04, z - 0.05},
                            {0.032, z - 0.05},
                            {0.034, z + 0.02},
                            {0.6 * r, z + 0.045},
                            {r, z + 0.10},
                            {r, z + 0.45 * bottle},
                            {0.95 * r, z + 0.5 * bottle},
                            {r, z + 0.55 * bottle},
                            {r, z + bottle - 0.035},
                            {0.82 * r, z + bottle},
                            {-0.82 * r, z + bottle},
                            {-r, z + bottle - 0.035},
                            {-r, z + 0.1}};
  builder.add({revolution(polygonProfile(outline), 0.006)}, plain({124, 178, 220}, 0.8));
  builder.add({frustum({0, 0, height - 0.012}, 0.12, 0.075, 0.040, 0.006)},
              plain({60, 96, 150}, 0.4));
  return builder.finish(0.022);
}

}  // namespace

std::vector<ShapeFamily> binFamilies() {
  return {makeFamily<buildSmallBin>("bin_small", "bin"),
          makeFamily<buildLargeBin>("bin_large", "bin"),
          makeFamily<buildWaterDispenser>("water_dispenser", "bin")};
}

}  // namespace hydrabench
