// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/fitted_furniture.h"

#include <string>
#include <utility>
#include <vector>

#include "eval/simulation/sdf_operators.h"
#include "eval/simulation/sdf_primitives.h"

namespace hydrabench::fitted {
namespace {

using Pattern = Material::Pattern;

const Material kSteel = {{168, 171, 176}, {168, 171, 176}, Pattern::kPlain, 1, 0.5};
const Material kDark = {{52, 54, 58}, {52, 54, 58}, Pattern::kPlain, 1, 0.2};
const Material kWhite = {{232, 233, 234}, {232, 233, 234}, Pattern::kPlain, 1, 0.3};

Material woodOf(Random& random) {
  static const Rgb kWoods[][2] = {{{190, 152, 108}, {162, 122, 82}},
                                  {{146, 104, 68}, {116, 80, 50}},
                                  {{208, 184, 150}, {186, 158, 122}}};
  const auto& pair = kWoods[random.index(3)];
  return {pair[0], pair[1], Pattern::kWood, 0.18, 0.25};
}

SdfPtr box(double x_low, double x_high, double y_low, double y_high, double z_low, double z_high,
           double rounding = 0.004) {
  return roundedBox({0.5 * (x_low + x_high), 0.5 * (y_low + y_high), 0.5 * (z_low + z_high)},
                    {x_high - x_low, y_high - y_low, z_high - z_low}, rounding);
}

ShapeInstance assemble(std::string name, std::vector<ShapePart> parts, double thinnest_m) {
  ShapeInstance instance;
  instance.family = std::move(name);
  std::vector<SdfPtr> all;
  for (const ShapePart& part : parts) all.push_back(part.sdf);
  instance.sdf = unite(std::move(all));
  instance.parts = std::move(parts);
  instance.thinnest_m = thinnest_m;
  return instance;
}

}  // namespace

ShapeInstance cubicleScreens(int desks, double pitch_m, double reach_m, double height_m,
                             Random random) {
  static const Rgb kFabrics[][2] = {{{122, 140, 158}, {106, 124, 142}},
                                    {{150, 146, 136}, {134, 130, 120}},
                                    {{120, 146, 130}, {104, 130, 114}}};
  const auto& fabric = kFabrics[random.index(3)];
  const Material cloth = {fabric[0], fabric[1], Pattern::kFabric, 0.02, 0};
  constexpr double kHalf = 0.02;
  const double half_length = 0.5 * desks * pitch_m;
  std::vector<SdfPtr> screens = {
      box(-kHalf, kHalf, -half_length, half_length, 0.0, height_m, 0.008)};
  std::vector<SdfPtr> rails = {box(-kHalf - 0.005, kHalf + 0.005, -half_length - 0.005,
                                   half_length + 0.005, height_m - 0.005, height_m + 0.025)};
  for (int i = 0; i <= desks; ++i) {
    const double y = -half_length + i * pitch_m;
    screens.push_back(box(-reach_m, reach_m, y - kHalf, y + kHalf, 0.0, height_m, 0.008));
    rails.push_back(box(-reach_m - 0.005, reach_m + 0.005, y - kHalf - 0.005, y + kHalf + 0.005,
                        height_m - 0.005, height_m + 0.025));
  }
  return assemble("cubicle_screens",
                  {{unite(std::move(screens)), cloth}, {unite(std::move(rails)), kSteel}}, 0.03);
}

ShapeInstance conferenceTable(double length_m, double width_m, Random random) {
  const double height = random.uniform(0.72, 0.76);
  const double x = 0.5 * width_m;
  const double y = 0.5 * length_m;
  std::vector<SdfPtr> legs;
  for (const double sign : {-1.0, 1.0}) {
    const double at = sign * (y - 0.45);
    legs.push_back(box(-0.4 * width_m, 0.4 * width_m, at - 0.03, at + 0.03, 0, 0.05, 0.01));
    legs.push_back(box(-0.12, 0.12, at - 0.025, at + 0.025, 0.02, height - 0.02, 0.01));
  }
  return assemble("conference_table",
                  {{box(-x, x, -y, y, height - 0.035, height, 0.012), woodOf(random)},
                   {unite(std::move(legs)), kDark}},
                  0.035);
}

ShapeInstance kitchenCounter(double length_m, Random random) {
  const double y = 0.5 * length_m;
  const int doors = static_cast<int>(length_m / 0.5);
  const double pitch = length_m / doors;
  std::vector<SdfPtr> fronts;
  std::vector<SdfPtr> handles;
  for (int i = 0; i < doors; ++i) {
    const double low = -y + i * pitch;
    fronts.push_back(box(0.26, 0.30, low + 0.006, low + pitch - 0.006, 0.12, 0.84));
    handles.push_back(box(0.295, 0.325, low + 0.12, low + pitch - 0.12, 0.77, 0.785));
  }
  const SdfPtr top =
      subtract(box(-0.3, 0.32, -y, y, 0.86, 0.90),
               box(-0.18, 0.2, 0.15 * length_m - 0.25, 0.15 * length_m + 0.25, 0.875, 1.0, 0.02));
  const SdfPtr tap = tube({{-0.22, 0.15 * length_m, 0.88},
                           {-0.22, 0.15 * length_m, 1.12},
                           {-0.12, 0.15 * length_m, 1.18},
                           {-0.04, 0.15 * length_m, 1.12}},
                          {0.014, 0.014, 0.014, 0.014});
  const Material front = random.chance(0.5) ? kWhite : woodOf(random);
  const Material worktop = {{112, 108, 104}, {92, 88, 84}, Pattern::kNoise, 0.03, 0.5};
  return assemble("kitchen_counter",
                  {{box(-0.3, 0.27, -y, y, 0.08, 0.87), kWhite},
                   {box(-0.25, 0.22, -y + 0.02, y - 0.02, 0, 0.1), kDark},
                   {unite(std::move(fronts)), front},
                   {top, worktop},
                   {unite({tap, unite(std::move(handles))}), kSteel}},
                  0.015);
}

ShapeInstance receptionDesk(double length_m, Random random) {
  const double y = 0.5 * length_m;
  const Material wood = woodOf(random);
  return assemble(
      "reception_desk",
      {{unite({box(0.30, 0.34, -y, y, 0, 1.08), box(-0.36, 0.32, -y, -y + 0.04, 0, 0.74),
               box(-0.36, 0.32, y - 0.04, y, 0, 0.74)}),
        wood},
       {box(0.16, 0.40, -y - 0.02, y + 0.02, 1.07, 1.11, 0.01), kWhite},
       {box(-0.42, 0.32, -y, y, 0.71, 0.745), kWhite}},
      0.035);
}

ShapeInstance copier(Random random) {
  const double scale = random.uniform(0.94, 1.06);
  const auto part = [&](double xl, double xh, double yl, double yh, double zl, double zh,
                        double rounding) {
    return box(xl * scale, xh * scale, yl * scale, yh * scale, zl * scale, zh * scale, rounding);
  };
  const Material body = {{214, 216, 218}, {214, 216, 218}, Pattern::kPlain, 1, 0.3};
  std::vector<SdfPtr> trays;
  for (int i = 0; i < 3; ++i)
    trays.push_back(part(0.27, 0.315, -0.27, 0.27, 0.10 + 0.18 * i, 0.26 + 0.18 * i, 0.01));
  return assemble(
      "copier",
      {{unite({part(-0.3, 0.3, -0.3, 0.3, 0.05, 0.98, 0.02),
               part(-0.3, 0.27, -0.28, 0.28, 1.0, 1.10, 0.02),
               part(-0.28, 0.24, -0.26, 0.26, 0.97, 1.02, 0.01)}),
        body},
       {unite(std::move(trays)), {{190, 193, 197}, {190, 193, 197}, Pattern::kPlain, 1, 0.2}},
       {unite({part(-0.26, 0.26, -0.26, 0.26, 0, 0.07, 0.005),
               part(0.2, 0.36, 0.02, 0.28, 0.95, 1.0, 0.01)}),
        kDark}},
      0.03);
}

ShapeInstance whiteboard(double width_m, double height_m) {
  const double y = 0.5 * width_m;
  const SdfPtr rim = subtract(box(0, 0.025, -y, y, 0, height_m),
                              box(0.015, 0.06, -y + 0.025, y - 0.025, 0.025, height_m - 0.025));
  return assemble(
      "whiteboard",
      {{box(0.002, 0.018, -y + 0.01, y - 0.01, 0.01, height_m - 0.01),
        {{246, 247, 248}, {246, 247, 248}, Pattern::kPlain, 1, 0.6}},
       {unite({rim, box(0.02, 0.08, -0.3 * width_m, 0.3 * width_m, 0, 0.016)}), kSteel}},
      0.014);
}

}  // namespace hydrabench::fitted
