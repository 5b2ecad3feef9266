// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

Material screen(Parameters& parameters) {
  if (parameters.chance(0.25)) return plain({18, 20, 24}, 0.8);  // switched off
  Material material;
  material.pattern = Material::Pattern::kScreen;
  material.color = parameters.color({{28, 62, 112}, {30, 34, 44}, {22, 88, 96}, {70, 50, 104}});
  material.second_color = {226, 232, 240};
  material.pattern_size_m = parameters.range(0.09, 0.13);
  material.gloss = 0.5;
  return material;
}

Material keyMaterial(Rgb color) {
  Material material = plain(color, 0.2);
  material.pattern = Material::Pattern::kTiles;
  material.second_color = darker(color, 0.3);
  material.pattern_size_m = 0.019;
  return material;
}

/// Flat display that stands on z and faces x: housing, and the screen a little proud of it.
void addDisplay(double width, double height, double depth, double bezel, double chin, double x,
                double z, double tilt, const Material& housing, const Material& picture,
                InstanceBuilder& builder) {
  const auto lean = [&](SdfPtr sdf) {
    return turned(std::move(sdf), Vector3d::UnitY(), -tilt, {x, 0, z});
  };
  builder.add({lean(standingBox({0, 0, 0}, {depth, width, height}, 0.007))}, housing);
  const double screen_height = height - bezel - chin;
  builder.add({lean(roundedBox({0.5 * depth - 0.008, 0, chin + 0.5 * screen_height},
                               {0.020, width - 2 * bezel, screen_height}, 0.002))},
              picture);
}

ShapeInstance buildMonitor(Parameters& parameters) {
  InstanceBuilder builder("monitor");
  const double width = parameters.range(0.48, 0.72);
  const double height = width * (width > 0.64 ? 0.46 : parameters.range(0.57, 0.64));
  const double bottom = parameters.range(0.09, 0.16);
  const double depth = parameters.range(0.026, 0.040);
  const double tilt = parameters.range(0.0, 0.10);
  const Material housing =
      plain(parameters.color({{30, 31, 34}, {196, 198, 200}, {56, 58, 62}}), 0.3);
  const Material stand = parameters.chance(0.5) ? plain({168, 170, 174}, 0.5) : housing;
  addDisplay(width, height, depth, parameters.range(0.010, 0.016), parameters.range(0.014, 0.026),
             0.02, bottom, tilt, housing, screen(parameters), builder);
  const double neck_top = bottom + 0.5 * height;
  std::vector<SdfPtr> pieces = {
      capsule({-0.035, 0, 0.024}, {-0.035 - 0.5 * tilt * height, 0, neck_top},
              parameters.range(0.016, 0.022)),
      roundedBox({-0.012 - 0.5 * tilt * height, 0, neck_top}, {0.05, 0.12, 0.12}, 0.012)};
  const int foot = parameters.choice(3);
  if (foot == 0) {
    pieces.push_back(moved(
        extrusion(rectangleProfile(
                      {0, 0}, {parameters.range(0.17, 0.22), parameters.range(0.20, 0.28)}, 0.03),
                  Axis::kZ, 0.016, 0.005),
        {0.0, 0, 0.008}));
  } else if (foot == 1) {
    pieces.push_back(cylinder({0, 0, 0}, {0, 0, 0.016}, parameters.range(0.10, 0.125), 0.005));
  } else {
    for (const double side : {-1.0, 1.0}) {
      pieces.push_back(
          taperedCapsule({-0.045, 0, 0.012}, {0.12, side * 0.16, 0.0085}, 0.012, 0.0085));
    }
    pieces.push_back(taperedCapsule({-0.03, 0, 0.012}, {-0.10, 0, 0.0085}, 0.012, 0.0085));
  }
  builder.add(pieces, stand);
  return builder.finish(0.016);
}

ShapeInstance buildLaptop(Parameters& parameters) {
  InstanceBuilder builder("laptop");
  const double width = parameters.range(0.30, 0.38);
  const double depth = width * parameters.range(0.66, 0.72);
  const double base = parameters.range(0.015, 0.020);
  const double opening = parameters.range(0.15, 0.52);  ///< of the lid beyond the vertical
  constexpr double kLid = 0.011;
  const Material housing =
      plain(parameters.color({{190, 192, 196}, {60, 62, 68}, {36, 38, 42}, {222, 206, 190}}), 0.5);
  builder.add(
      {moved(extrusion(rectangleProfile({0, 0}, {depth, width}, 0.014), Axis::kZ, base, 0.004),
             {0, 0, 0.5 * base})},
      housing);
  // Keys towards the lid, touch pad towards the user, both barely proud.
  builder.add(
      {roundedBox({-0.14 * depth, 0, base - 0.002}, {0.46 * depth, 0.86 * width, 0.008}, 0.001)},
      keyMaterial({34, 35, 38}));
  builder.add(
      {roundedBox({0.30 * depth, 0, base - 0.003}, {0.26 * depth, 0.32 * width, 0.008}, 0.001)},
      plain(darker(housing.color, 0.82), 0.4));
  const double height = 0.97 * depth;
  const auto onLid = [&](SdfPtr sdf) {
    return turned(std::move(sdf), Vector3d::UnitY(), -opening,
                  {-0.5 * depth + 0.007, 0, base - 0.004});
  };
  builder.add({onLid(moved(extrusion(rectangleProfile({0, 0.5 * height}, {width, height}, 0.012),
                                     Axis::kX, kLid, 0.003),
                           {0, 0, 0})),
               capsule({-0.5 * depth + 0.007, -0.36 * width, base - 0.002},
                       {-0.5 * depth + 0.007, 0.36 * width, base - 0.002}, 0.0065)},
              housing);
  builder.add({onLid(roundedBox({0.5 * kLid - 0.003, 0, 0.53 * height},
                                {0.009, width - 0.020, height - 0.036}, 0.001))},
              screen(parameters));
  return builder.finish(kLid);
}

ShapeInstance buildDesktopTower(Parameters& parameters) {
  InstanceBuilder builder("desktop_tower");
  const double depth = parameters.range(0.36, 0.48);
  const double width = parameters.range(0.165, 0.22);
  const double height = parameters.range(0.36, 0.48);
  const double foot = 0.015;
  const Material housing =
      plain(parameters.color({{34, 35, 38}, {204, 204, 200}, {70, 72, 78}}), 0.3);
  const Material front =
      parameters.chance(0.6) ? plain({22, 23, 25}, 0.5) : plain({178, 180, 184}, 0.5);
  builder.add({standingBox({-0.01, 0, foot}, {depth - 0.02, width, height - foot}, 0.007)},
              housing);
  builder.add({standingBox({0.5 * depth - 0.015, 0, foot + 0.004},
                           {0.03, width - 0.006, height - foot - 0.008}, 0.010)},
              front);
  const double x = 0.5 * depth;
  const Material detail = plain({150, 153, 158}, 0.6);
  const int bays = parameters.count(1, 2);
  std::vector<SdfPtr> details;
  for (int i = 0; i < bays; ++i) {
    details.push_back(
        roundedBox({x - 0.004, 0, height - 0.05 - 0.052 * i}, {0.018, 0.74 * width, 0.034}, 0.003));
  }
  const double button_z = height - 0.06 - 0.052 * bays;
  details.push_back(cylinder({x - 0.01, 0, button_z}, {x + 0.006, 0, button_z}, 0.016, 0.003));
  builder.add(details, detail);
  // Air intake.
  Material grille = plain({14, 14, 16});
  grille.pattern = Material::Pattern::kStripes;
  grille.second_color = {92, 94, 98};
  grille.pattern_size_m = 0.016;
  const double grille_height = parameters.range(0.28, 0.42) * height;
  builder.add(
      {standingBox({x - 0.004, 0, foot + 0.03}, {0.018, 0.68 * width, grille_height}, 0.003)},
      grille);
  std::vector<SdfPtr> feet;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      feet.push_back(cylinder({sx * 0.38 * depth, sy * 0.36 * width, 0},
                              {sx * 0.38 * depth, sy * 0.36 * width, foot + 0.01}, 0.015, 0.003));
    }
  }
  builder.add(feet, blackPlastic());
  return builder.finish(0.018);
}

ShapeInstance buildKeyboard(Parameters& parameters) {
  InstanceBuilder builder("keyboard");
  const bool number_block = parameters.chance(0.7);
  const double width = number_block ? parameters.range(0.42, 0.46) : parameters.range(0.28, 0.33);
  const double depth = parameters.range(0.125, 0.16);
  const double front = 0.012;
  const double rear = parameters.range(0.018, 0.030);
  const Rgb color = parameters.color({{32, 33, 36}, {222, 222, 220}, {70, 72, 76}});
  const SdfPtr wedge = extrusion(
      polygonProfile(
          {{-0.5 * depth, 0}, {0.5 * depth, 0}, {0.5 * depth, front}, {-0.5 * depth, rear}}),
      Axis::kY, width, 0.003);
  builder.add({wedge}, plain(color, 0.3));
  const double slope = std::atan2(rear - front, depth);
  const double middle = 0.5 * (front + rear);
  const auto keys = [&](double y, double x, double w, double d) {
    return turned(roundedBox({x, y, 0}, {d, w, 0.011}, 0.002), Vector3d::UnitY(), slope,
                  {0, 0, middle + 0.0015});
  };
  // User at +x: seen from there the number block is on the right, that is at -y.
  const double main = number_block ? 0.62 * width : 0.92 * width;
  const double left = 0.5 * width - 0.012;
  std::vector<SdfPtr> blocks = {keys(left - 0.5 * main, 0.06 * depth, main, 0.68 * depth),
                                keys(left - 0.5 * main, -0.38 * depth, main, 0.13 * depth)};
  if (number_block) {
    const double y = -0.5 * width + 0.012;
    blocks.push_back(keys(y + 0.085 * width, 0.06 * depth, 0.17 * width, 0.68 * depth));
    blocks.push_back(keys(y + 0.245 * width, 0.33 * depth, 0.115 * width, 0.14 * depth));
    blocks.push_back(keys(y + 0.245 * width, -0.12 * depth, 0.115 * width, 0.30 * depth));
  }
  builder.add(blocks, keyMaterial(color.r > 128 ? Rgb{240, 240, 238} : Rgb{58, 60, 64}));
  return builder.finish(0.011);
}

ShapeInstance buildAllInOne(Parameters& parameters) {
  InstanceBuilder builder("all_in_one");
  const double width = parameters.range(0.52, 0.64);
  const double height = width * parameters.range(0.66, 0.74);
  const double bottom = parameters.range(0.07, 0.11);
  const double tilt = parameters.range(0.03, 0.12);
  const Material housing =
      plain(parameters.color({{206, 208, 212}, {238, 238, 236}, {60, 62, 68}}), 0.5);
  addDisplay(width, height, 0.030, 0.013, parameters.range(0.065, 0.09), 0.0, bottom, tilt, housing,
             screen(parameters), builder);
  // Stand of one bent sheet.
  const double stand = parameters.range(0.15, 0.20);
  const double grip = bottom + 0.45 * height;
  const Polyline sheet = smoothCurve({{0.09, 0.0075},
                                      {-0.06, 0.0075},
                                      {-0.115, 0.018},
                                      {-0.11, 0.06},
                                      {-0.006 - tilt * 0.45 * height, grip}},
                                     5);
  builder.add({intersect(extrusion(strokeProfile(sheet, 0.0075), Axis::kY, stand, 0.003),
                         standingBox({0, 0, 0}, {1, 1, 1}, 0))},
              housing);
  return builder.finish(0.015);
}

ShapeInstance buildPrinter(Parameters& parameters) {
  InstanceBuilder builder("printer");
  const double width = parameters.range(0.40, 0.50);
  const double depth = parameters.range(0.36, 0.46);
  const double height = parameters.range(0.24, 0.38);
  const Material light =
      plain(parameters.color({{226, 226, 222}, {70, 72, 78}, {196, 198, 202}}), 0.35);
  const Material dark = plain({46, 47, 52}, 0.4);
  const double front = 0.5 * depth;
  const double lid = height - 0.06;
  // Body with the mouth where paper comes out.
  const double mouth = parameters.range(0.34, 0.44) * lid;
  builder.add(
      {subtract(standingBox({0, 0, 0.012}, {depth, width, lid - 0.012}, 0.018),
                roundedBox({front, 0, 0.62 * lid}, {0.42 * depth, 0.72 * width, mouth}, 0.012))},
      light);
  std::vector<SdfPtr> black = {
      standingBox({0, 0, 0}, {depth - 0.06, width - 0.06, 0.03}, 0.006),
      roundedBox({0, 0, lid}, {depth - 0.03, width - 0.03, 0.03}, 0.006),
      // Output tray and the grip of the paper drawer.
      roundedBox({front - 0.01, 0, 0.62 * lid - 0.5 * mouth + 0.004}, {0.16, 0.54 * width, 0.014},
                 0.004),
      roundedBox({front - 0.004, 0, 0.18 * lid}, {0.022, 0.36 * width, 0.024}, 0.006)};
  builder.add(black, dark);
  builder.add({standingBox({-0.01, 0, lid + 0.006}, {depth - 0.02, width, 0.05}, 0.014)}, light);
  // Control panel, tilted towards the user, with a little screen.
  const double y = -0.22 * width;
  const auto onPanel = [&](SdfPtr sdf) {
    return turned(std::move(sdf), Vector3d::UnitY(), 0.6, {front - 0.004, y, lid + 0.008});
  };
  builder.add({onPanel(roundedBox({0, 0, 0}, {0.10, 0.46 * width, 0.03}, 0.008))}, dark);
  builder.add({onPanel(roundedBox({0, 0, 0.012}, {0.055, 0.20 * width, 0.014}, 0.002))},
              plain({90, 150, 200}, 0.6));
  // A sheet of paper lies in the tray.
  builder.add({roundedBox({front - 0.02, 0, 0.62 * lid - 0.5 * mouth + 0.012},
                          {0.17, 0.42 * width, 0.014}, 0.003)},
              plain({248, 248, 246}));
  return builder.finish(0.014);
}

}  // namespace

std::vector<ShapeFamily> computerFamilies() {
  return {makeFamily<buildMonitor>("monitor", "computer"),
          makeFamily<buildLaptop>("laptop", "computer"),
          makeFamily<buildDesktopTower>("desktop_tower", "computer"),
          makeFamily<buildKeyboard>("keyboard", "computer"),
          makeFamily<buildAllInOne>("all_in_one", "computer"),
          makeFamily<buildPrinter>("printer", "computer")};
}

}  // namespace hydrabench
