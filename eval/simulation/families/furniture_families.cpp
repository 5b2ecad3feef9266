// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

Material tableTop(Parameters& parameters) {
  if (parameters.chance(0.6)) return wood(parameters);
  return plain(parameters.color({{232, 230, 226}, {200, 202, 204}, {72, 74, 78}}), 0.3);
}

/// x is the side on which a person sits.
ShapeInstance buildDesk(Parameters& parameters) {
  InstanceBuilder builder("desk");
  const double width = parameters.range(1.20, 1.70);
  const double depth = parameters.range(0.62, 0.80);
  const double height = parameters.range(0.71, 0.76);
  const double top = parameters.range(0.025, 0.034);
  const Material top_material = tableTop(parameters);
  builder.add({standingBox({0, 0, height - top}, {depth, width, top}, 0.005)}, top_material);
  const double under = height - top + 0.004;
  const Material frame = metal(parameters);
  std::vector<SdfPtr> legs;
  const int style = parameters.choice(3);
  const double y = 0.5 * width - 0.06;
  if (style == 0) {  // T feet
    for (const double side : {-1.0, 1.0}) {
      legs.push_back(standingBox({-0.05, side * y, 0.02}, {0.09, 0.05, under - 0.02}, 0.008));
      legs.push_back(standingBox({0, side * y, 0}, {depth - 0.06, 0.06, 0.032}, 0.010));
      legs.push_back(standingBox({0, side * y, under - 0.035}, {depth - 0.12, 0.05, 0.035}, 0.006));
    }
    legs.push_back(standingBox({-0.05, 0, under - 0.09}, {0.03, 2 * y, 0.06}, 0.006));
  } else if (style == 1) {  // four legs
    const double x = 0.5 * depth - 0.05;
    for (const double side : {-1.0, 1.0}) {
      for (const double end : {-1.0, 1.0}) {
        legs.push_back(standingBox({end * x, side * y, 0}, {0.045, 0.045, under}, 0.006));
      }
      legs.push_back(standingBox({0, side * y, under - 0.045}, {2 * x, 0.03, 0.045}, 0.005));
    }
    legs.push_back(standingBox({-x, 0, under - 0.06}, {0.03, 2 * y, 0.06}, 0.005));
  } else {  // side panels and a modesty panel
    for (const double side : {-1.0, 1.0}) {
      legs.push_back(
          standingBox({0, side * (0.5 * width - 0.03), 0}, {depth - 0.05, 0.026, under}, 0.004));
    }
    legs.push_back(
        standingBox({-0.5 * depth + 0.10, 0, 0.30}, {0.022, width - 0.06, under - 0.30}, 0.004));
  }
  builder.add(legs, style == 2 ? top_material : frame);
  if (parameters.chance(0.6)) {  // drawers under one end
    const double side = parameters.chance(0.5) ? 1.0 : -1.0;
    const double w = 0.40;
    const double d = depth - 0.10;
    const double at = side * (0.5 * width - 0.5 * w - (style == 2 ? 0.03 : 0.09));
    const Material body =
        plain(parameters.color({{214, 214, 210}, {92, 94, 98}, {238, 238, 236}}), 0.3);
    builder.add({standingBox({0, at, 0.03}, {d, w, under - 0.03}, 0.006),
                 standingBox({0, at, 0}, {d - 0.08, w - 0.08, 0.05}, 0.004)},
                body);
    std::vector<SdfPtr> fronts;
    std::vector<SdfPtr> grips;
    const double h = (under - 0.05) / 3;
    for (int i = 0; i < 3; ++i) {
      const double z = 0.04 + i * h;
      fronts.push_back(standingBox({0.5 * d, at, z + 0.006}, {0.028, w - 0.016, h - 0.022}, 0.004));
      grips.push_back(roundedBox({0.5 * d + 0.018, at, z + 0.72 * h}, {0.026, 0.12, 0.020}, 0.007));
    }
    builder.add(fronts, body);
    builder.add(grips, plain({70, 72, 76}, 0.5));
  }
  return builder.finish(0.022);
}

ShapeInstance buildTable(Parameters& parameters, bool round) {
  InstanceBuilder builder(round ? "table_round" : "table_rectangular");
  const double height = parameters.range(0.71, 0.76);
  const double top = parameters.range(0.026, 0.036);
  const double under = height - top + 0.004;
  const Material top_material = tableTop(parameters);
  std::vector<SdfPtr> legs;
  if (round) {
    const double radius = parameters.range(0.42, 0.65);
    builder.add({cylinder({0, 0, height - top}, {0, 0, height}, radius, 0.008)}, top_material);
    if (parameters.chance(0.6)) {  // column on a disc
      legs = {cylinder({0, 0, 0.01}, {0, 0, under}, 0.045, 0.005),
              frustum({0, 0, 0}, 0.56 * radius, 0.50 * radius, 0.026, 0.008),
              frustum({0, 0, under - 0.05}, 0.05, 0.16, 0.05, 0.005)};
    } else {
      for (int i = 0; i < 4; ++i) {
        const double angle = (i + 0.5) * std::numbers::pi / 2;
        const Vector3d out(std::cos(angle), std::sin(angle), 0);
        legs.push_back(taperedCapsule(0.72 * radius * out + Vector3d(0, 0, 0.014),
                                      0.55 * radius * out + Vector3d(0, 0, under - 0.02), 0.014,
                                      0.024));
      }
      legs.push_back(cylinder({0, 0, under - 0.03}, {0, 0, under}, 0.62 * radius, 0.005));
    }
    builder.add(legs, parameters.chance(0.6) ? metal(parameters) : top_material);
    return builder.finish(0.026, 4);
  }
  const double depth = parameters.range(0.75, 1.20);
  const double width = depth * parameters.range(1.4, 2.2);
  builder.add(
      {moved(extrusion(rectangleProfile({0, 0}, {depth, width}, parameters.range(0.01, 0.10)),
                       Axis::kZ, top, 0.006),
             {0, 0, height - 0.5 * top})},
      top_material);
  const double leg = parameters.range(0.045, 0.075);
  const double x = 0.5 * depth - 0.07;
  const double y = 0.5 * width - 0.10;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      legs.push_back(standingBox({sx * x, sy * y, 0}, {leg, leg, under}, 0.008));
    }
    legs.push_back(standingBox({sx * x, 0, under - 0.07}, {0.026, 2 * y, 0.07}, 0.005));
    legs.push_back(standingBox({0, sx * y, under - 0.07}, {2 * x, 0.026, 0.07}, 0.005));
  }
  builder.add(legs, parameters.chance(0.5) ? metal(parameters) : top_material);
  return builder.finish(0.026, 2);
}

ShapeInstance buildRoundTable(Parameters& parameters) { return buildTable(parameters, true); }
ShapeInstance buildRectangularTable(Parameters& parameters) {
  return buildTable(parameters, false);
}

ShapeInstance buildCoffeeTable(Parameters& parameters) {
  InstanceBuilder builder("coffee_table");
  const double height = parameters.range(0.36, 0.46);
  const double depth = parameters.range(0.48, 0.62);
  const double width = parameters.range(0.80, 1.15);
  const Material top = tableTop(parameters);
  builder.add(
      {moved(extrusion(rectangleProfile({0, 0}, {depth, width}, parameters.range(0.01, 0.2)),
                       Axis::kZ, 0.03, 0.008),
             {0, 0, height - 0.015})},
      top);
  std::vector<SdfPtr> legs;
  const double x = 0.5 * depth - 0.09;
  const double y = 0.5 * width - 0.12;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      legs.push_back(taperedCapsule({sx * (x + 0.03), sy * (y + 0.03), 0.013},
                                    {sx * x, sy * y, height - 0.03}, 0.013, 0.021));
    }
  }
  const bool lower_shelf = parameters.chance(0.5);
  if (lower_shelf) {
    builder.add({standingBox({0, 0, 0.13}, {2 * x + 0.04, 2 * y + 0.04, 0.022}, 0.006)}, top);
  }
  builder.add(legs, wood(parameters));
  return builder.finish(0.022, 2);
}

/// Books in one shelf bay; they lean on each other, so that nothing stands alone.
void addBooks(Parameters& parameters, double y_from, double y_to, double z, double depth,
              double space, std::vector<std::vector<SdfPtr>>& by_color) {
  double y = y_from;
  const double fill = parameters.range(0.45, 1.0);
  while (y < y_from + fill * (y_to - y_from) - 0.06) {
    const double thickness = parameters.range(0.026, 0.052);
    const double height = space * parameters.range(0.62, 0.90);
    const double d = depth * parameters.range(0.62, 0.84);
    by_color[static_cast<std::size_t>(parameters.choice(static_cast<int>(by_color.size())))]
        .push_back(standingBox({-0.5 * depth + 0.5 * d, y + 0.5 * thickness, z - 0.003},
                               {d, thickness, height}, 0.004));
    y += thickness - 0.002;
  }
}

ShapeInstance buildShelf(Parameters& parameters) {
  InstanceBuilder builder("shelf");
  const double width = parameters.range(0.75, 1.05);
  const double depth = parameters.range(0.28, 0.38);
  const double height = parameters.range(1.20, 2.00);
  const int bays = std::max(3, static_cast<int>(std::lround(height / 0.37)));
  constexpr double kBoard = 0.024;
  const double bay = (height - kBoard - 0.05) / bays;
  const Material board = tableTop(parameters);
  std::vector<SdfPtr> boards;
  for (const double side : {-1.0, 1.0}) {
    boards.push_back(
        standingBox({0, side * (0.5 * width - 0.5 * kBoard), 0}, {depth, kBoard, height}, 0.003));
  }
  for (int i = 0; i <= bays; ++i) {
    boards.push_back(standingBox({0, 0, 0.05 + i * bay}, {depth, width - 0.02, kBoard}, 0.003));
  }
  boards.push_back(
      standingBox({-0.5 * depth + 0.012, 0, 0.03}, {0.022, width - 0.02, height - 0.04}, 0.003));
  builder.add(boards, board);
  const Rgb colors[] = {{150, 44, 40}, {40, 76, 120}, {212, 196, 160},
                        {58, 98, 70},  {60, 58, 64},  {196, 132, 50}};
  std::vector<std::vector<SdfPtr>> books(std::size(colors));
  std::vector<SdfPtr> boxes;
  for (int i = 0; i < bays; ++i) {
    const double z = 0.05 + kBoard + i * bay;
    const double space = bay - kBoard;
    const double inner = 0.5 * width - kBoard - 0.004;
    if (parameters.chance(0.68)) {
      addBooks(parameters, -inner, inner, z, depth - 0.03, space, books);
    } else {
      const double w = parameters.range(0.24, 0.34);
      boxes.push_back(standingBox(
          {0.0, parameters.range(-inner + 0.5 * w + 0.02, inner - 0.5 * w - 0.02), z - 0.003},
          {depth - 0.08, w, 0.72 * space}, 0.010));
    }
  }
  for (std::size_t c = 0; c < books.size(); ++c) {
    if (!books[c].empty()) builder.add(books[c], plain(colors[c], 0.2));
  }
  if (!boxes.empty()) builder.add(boxes, plain({186, 150, 108}));
  return builder.finish(0.022);
}

ShapeInstance buildCabinet(Parameters& parameters) {
  InstanceBuilder builder("cabinet");
  const bool drawers = parameters.chance(0.55);
  const double width = drawers ? parameters.range(0.40, 0.50) : parameters.range(0.80, 1.00);
  const double depth = drawers ? parameters.range(0.50, 0.62) : parameters.range(0.40, 0.46);
  const double height = drawers ? parameters.range(0.70, 1.35) : parameters.range(0.75, 1.90);
  const Material body =
      parameters.chance(0.6)
          ? plain(parameters.color(
                      {{206, 208, 208}, {118, 122, 126}, {232, 230, 224}, {96, 112, 120}}),
                  0.35)
          : wood(parameters);
  builder.add({standingBox({0, 0, 0.04}, {depth, width, height - 0.04}, 0.006)}, body);
  builder.add({standingBox({0, 0, 0}, {depth - 0.05, width - 0.05, 0.06}, 0.004)},
              plain({60, 62, 66}));
  Material front = body;
  front.color = darker(body.color, 1.06);
  std::vector<SdfPtr> fronts;
  std::vector<SdfPtr> grips;
  const double x = 0.5 * depth;
  if (drawers) {
    const int count = std::max(2, static_cast<int>(std::lround(height / 0.33)));
    const double h = (height - 0.06) / count;
    for (int i = 0; i < count; ++i) {
      const double z = 0.05 + i * h;
      fronts.push_back(standingBox({x, 0, z + 0.006}, {0.030, width - 0.022, h - 0.024}, 0.005));
      grips.push_back(roundedBox({x + 0.022, 0, z + 0.74 * h}, {0.030, 0.15, 0.022}, 0.008));
    }
  } else {
    for (const double side : {-1.0, 1.0}) {
      fronts.push_back(standingBox({x, side * 0.25 * (width - 0.004), 0.055},
                                   {0.030, 0.5 * width - 0.022, height - 0.075}, 0.005));
      grips.push_back(
          roundedBox({x + 0.024, side * 0.045, 0.05 + 0.55 * height}, {0.030, 0.022, 0.18}, 0.008));
    }
  }
  builder.add(fronts, front);
  builder.add(grips, metal(parameters));
  return builder.finish(0.022);
}

/// Fabric wall in a metal frame on two feet; both sides look alike.
ShapeInstance buildCubiclePartition(Parameters& parameters) {
  InstanceBuilder builder("cubicle_partition");
  const double width = parameters.range(1.20, 1.60);
  const double height = parameters.range(1.15, 1.60);
  constexpr double kThickness = 0.05;
  builder.add({standingBox({0, 0, 0.09}, {kThickness - 0.008, width - 0.03, height - 0.11}, 0.008)},
              fabric(parameters));
  const double y = 0.5 * width - 0.02;
  std::vector<SdfPtr> frame = {
      standingBox({0, 0, height - 0.035}, {kThickness, width, 0.035}, 0.008),
      standingBox({0, 0, 0.07}, {kThickness, width, 0.04}, 0.008)};
  for (const double side : {-1.0, 1.0}) {
    frame.push_back(standingBox({0, side * y, 0.02}, {kThickness, 0.04, height - 0.03}, 0.008));
    frame.push_back(standingBox({0, side * (y - 0.08), 0}, {0.40, 0.06, 0.03}, 0.010));
    frame.push_back(standingBox({0, side * (y - 0.08), 0.01}, {0.04, 0.05, 0.10}, 0.008));
  }
  builder.add(frame, metal(parameters));
  return builder.finish(0.03, 2);
}

/// On a rolling stand.
ShapeInstance buildWhiteboard(Parameters& parameters) {
  InstanceBuilder builder("whiteboard");
  const double width = parameters.range(1.20, 1.80);
  const double board = parameters.range(0.85, 1.05);
  const double bottom = parameters.range(0.78, 0.92);
  const double top = bottom + board;
  builder.add({standingBox({0, 0, bottom}, {0.024, width - 0.03, board}, 0.003)},
              plain({246, 247, 248}, 0.5));
  const double y = 0.5 * width - 0.014;
  std::vector<SdfPtr> frame = {
      standingBox({0, 0, bottom - 0.012}, {0.034, width, 0.03}, 0.006),
      standingBox({0, 0, top - 0.012}, {0.034, width, 0.03}, 0.006),
      roundedBox({0.05, 0, bottom + 0.004}, {0.09, 0.5 * width, 0.022}, 0.008)};
  std::vector<SdfPtr> wheels;
  for (const double side : {-1.0, 1.0}) {
    frame.push_back(
        standingBox({0, side * y, bottom - 0.012}, {0.034, 0.028, board + 0.03}, 0.006));
    const double post = y - 0.04;
    frame.push_back(standingBox({-0.028, side * post, 0.07}, {0.036, 0.036, top - 0.10}, 0.006));
    frame.push_back(standingBox({-0.028, side * post, 0.06}, {0.56, 0.044, 0.036}, 0.008));
    for (const double end : {-1.0, 1.0}) {
      const Vector3d hub(-0.028 + end * 0.25, side * post, 0.034);
      wheels.push_back(
          cylinder(hub - Vector3d(0, 0.016, 0), hub + Vector3d(0, 0.016, 0), 0.034, 0.006));
    }
  }
  frame.push_back(standingBox({-0.028, 0, 0.30}, {0.03, 2 * y - 0.08, 0.036}, 0.006));
  builder.add(frame, plain({168, 171, 175}, 0.6));
  builder.add(wheels, blackPlastic());
  // Writing: a few lines and a sketch, pressed flat.
  std::vector<SdfPtr> ink;
  const int lines = parameters.count(3, 5);
  for (int i = 0; i < lines; ++i) {
    const double length = width * parameters.range(0.16, 0.34);
    ink.push_back(roundedBox({0.006, 0.40 * width - 0.5 * length, top - 0.16 - 0.11 * i},
                             {0.022, length, 0.024}, 0.004));
  }
  builder.add(ink, plain(parameters.color({{40, 70, 150}, {30, 30, 34}, {170, 40, 40}})));
  return builder.finish(0.022);
}

}  // namespace

std::vector<ShapeFamily> furnitureFamilies() {
  return {makeFamily<buildDesk>("desk", "desk"),
          makeFamily<buildRectangularTable>("table_rectangular", "table"),
          makeFamily<buildRoundTable>("table_round", "table"),
          makeFamily<buildCoffeeTable>("coffee_table", "table"),
          makeFamily<buildShelf>("shelf", "shelf"),
          makeFamily<buildCabinet>("cabinet", "cabinet"),
          makeFamily<buildCubiclePartition>("cubicle_partition", "cubicle"),
          makeFamily<buildWhiteboard>("whiteboard", "whiteboard")};
}

}  // namespace hydrabench
