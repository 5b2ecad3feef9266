// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kSlat = 0.034;  ///< [m] thickness of every board

Material weatheredWood(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kWood;
  material.color = parameters.color(
      {{166, 116, 72}, {138, 92, 58}, {158, 146, 130}, {112, 78, 54}, {86, 108, 82}});
  material.second_color = darker(material.color, 0.72);
  material.pattern_size_m = parameters.range(0.08, 0.16);
  material.gloss = 0.1;
  return material;
}

Material castIron(Parameters& parameters) {
  return plain(parameters.color({{42, 44, 48}, {40, 62, 54}, {70, 72, 76}, {58, 46, 40}}), 0.35);
}

Material concrete(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kNoise;
  material.color = parameters.color({{186, 182, 174}, {160, 158, 154}, {202, 196, 184}});
  material.second_color = darker(material.color, 0.82);
  material.pattern_size_m = 0.07;
  return material;
}

/// Boards have many narrow edges: a grid finer than their thickness asks for.
ShapeInstance finishBench(InstanceBuilder& builder, double thinnest_m, int yaw_symmetry = 1) {
  ShapeInstance bench = builder.finish(thinnest_m, yaw_symmetry);
  bench.max_pitch_m = 0.010;
  return bench;
}

/// A board along y whose cross-section is centred at (x, z) and turned by `tilt` from level.
SdfPtr board(double x, double z, double width, double length, double tilt) {
  return turned(roundedBox({0, 0, 0}, {width, length, kSlat}, 0.008), Vector3d::UnitY(), tilt,
                {x, 0, z});
}

/// Boards side by side along a line of the x-z plane, with equal gaps; the line runs through their
/// middle.
void addBoards(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int count, double gap,
               double length, std::vector<SdfPtr>& boards) {
  const Eigen::Vector2d along = to - from;
  const double width = (along.norm() - (count - 1) * gap) / count;
  const double tilt = std::atan2(-along.y(), along.x());
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d at = from + (i + 0.5) / count * along;
    boards.push_back(board(at.x(), at.y(), width, length, tilt));
  }
}

/// Sheet of an outline in the x-z plane, centred at y.
SdfPtr sideFrame(const Polyline& line, double half_width, double y, double thickness) {
  return moved(extrusion(strokeProfile(line, half_width), Axis::kY, thickness, 0.006), {0, y, 0});
}

ShapeInstance buildParkBench(Parameters& parameters) {
  InstanceBuilder builder("bench_park");
  const double length = parameters.range(1.25, 1.95);
  const double seat = parameters.range(0.42, 0.47);
  const double depth = parameters.range(0.40, 0.50);
  const double top = parameters.range(0.78, 0.92);
  const double lean = parameters.range(0.12, 0.22);  ///< of the back's top behind its foot
  const double gap = parameters.range(0.020, 0.028);
  const double x = 0.5 * (depth + lean);  ///< of the seat's front edge
  const Eigen::Vector2d front(x, seat - 0.5 * kSlat);
  const Eigen::Vector2d rear(x - depth, seat - 0.5 * kSlat - parameters.range(0.0, 0.035));
  const Eigen::Vector2d back_top(rear.x() - lean, top);
  const Eigen::Vector2d up = (back_top - rear).normalized();

  std::vector<SdfPtr> boards;
  addBoards(front, rear + Eigen::Vector2d(0.03, 0), parameters.count(4, 6), gap, length, boards);
  const double free = parameters.range(0.09, 0.16);  ///< between the seat and the lowest back board
  addBoards(rear + free * up, back_top, parameters.count(3, 5), gap, length, boards);
  const Material timber = weatheredWood(parameters);

  // The frame runs just below and behind the boards.
  constexpr double kHalf = 0.021;
  const double under = 0.5 * kSlat + kHalf - 0.006;
  const Eigen::Vector2d out(-up.y(), up.x());  // behind the back
  const Eigen::Vector2d low(0, -under);
  const double arm = seat + parameters.range(0.19, 0.24);
  const Eigen::Vector2d arm_rear = rear + (arm - rear.y()) / up.y() * up + under * out;
  const bool curved = parameters.chance(0.6);
  const double splay = parameters.range(0.01, 0.05);
  const Polyline spine = {back_top + under * out, rear + free * up + under * out, rear + low};
  const Polyline front_leg = {{x + splay, kHalf}, {x - 0.05, 0.55 * seat}, front + low};
  const Polyline rear_leg = {
      {rear.x() - 0.6 * lean - splay, kHalf}, {rear.x() + 0.03, 0.55 * seat}, rear + low};
  const Polyline rest = {arm_rear,
                         {x - 0.12, arm + 0.012},
                         {x - 0.03, arm - 0.02},
                         {x - 0.02, 0.5 * (arm + seat)},
                         front + low};
  const auto line = [&](const Polyline& points) {
    return curved ? smoothCurve(points, 4) : points;
  };
  const double y = 0.5 * length - parameters.range(0.06, 0.16);
  std::vector<double> places = {-y, y};
  if (length > 1.6) places.push_back(0);
  std::vector<SdfPtr> iron;
  std::vector<SdfPtr> rests;
  const bool wooden_rest = parameters.chance(0.4);
  for (const double at : places) {
    iron.push_back(sideFrame(line(spine), kHalf, at, 0.05));
    iron.push_back(sideFrame({rear + low, front + low}, kHalf, at, 0.05));
    iron.push_back(sideFrame(line(front_leg), kHalf, at, 0.05));
    iron.push_back(sideFrame(line(rear_leg), kHalf, at, 0.05));
    for (const double foot : {front_leg[0].x(), rear_leg[0].x()}) {
      iron.push_back(standingBox({foot, at, 0}, {0.09, 0.07, 0.024}, 0.008));
    }
    if (at == 0) continue;  // the middle frame has no armrest
    iron.push_back(sideFrame(line(rest), 0.018, at, 0.05));
    if (wooden_rest) {
      rests.push_back(roundedBox({0.5 * (arm_rear.x() + x) - 0.04, at, arm + 0.026},
                                 {x - arm_rear.x() - 0.12, 0.075, 0.032}, 0.010));
    }
  }
  boards.insert(boards.end(), rests.begin(), rests.end());
  builder.add(boards, timber);
  builder.add(iron, castIron(parameters));
  return finishBench(builder, 0.03);
}

/// Low, without a back: a slab of concrete, or boards on steel frames or blocks.
ShapeInstance buildSlabBench(Parameters& parameters) {
  InstanceBuilder builder("bench_slab");
  const double length = parameters.range(1.2, 2.2);
  const double depth = parameters.range(0.38, 0.56);
  const double seat = parameters.range(0.41, 0.48);
  const double y = 0.5 * length - parameters.range(0.16, 0.32);
  const int style = parameters.choice(3);
  if (style == 1) {  // all of concrete
    const double slab = parameters.range(0.08, 0.13);
    const Material material = concrete(parameters);
    const Vector3d foot(depth - parameters.range(0.06, 0.14), parameters.range(0.12, 0.22),
                        seat - slab + 0.01);
    builder.add({standingBox({0, 0, seat - slab}, {depth, length, slab}, 0.016),
                 standingBox({0, -y, 0}, foot, 0.012), standingBox({0, y, 0}, foot, 0.012)},
                material);
    return builder.finish(0.08, 2);
  }
  std::vector<SdfPtr> boards;
  const double z = seat - 0.5 * kSlat;
  const double gap = parameters.range(0.020, 0.03);
  addBoards({0.5 * depth, z}, {-0.5 * depth, z}, parameters.count(4, 6), gap, length, boards);
  builder.add(boards, weatheredWood(parameters));
  const double under = seat - kSlat + 0.006;
  const double block = parameters.range(0.16, 0.3);
  std::vector<SdfPtr> feet;
  for (const double side : {-1.0, 1.0}) {
    if (style == 0) {  // frames of flat steel
      const double x = 0.5 * depth - 0.04;
      feet.push_back(
          sideFrame({{-x, 0.02}, {x, 0.02}, {x, under - 0.02}, {-x, under - 0.02}, {-x, 0.02}},
                    0.02, side * y, 0.08));
    } else {
      feet.push_back(standingBox({0, side * y, 0}, {depth - 0.07, block, under}, 0.012));
    }
  }
  if (style == 0) feet.push_back(standingBox({0, 0, under - 0.034}, {0.05, 2 * y, 0.034}, 0.006));
  builder.add(feet, style == 0 ? castIron(parameters) : concrete(parameters));
  return finishBench(builder, kSlat, 2);
}

/// Table and two benches on common A-frames.
ShapeInstance buildPicnicBench(Parameters& parameters) {
  InstanceBuilder builder("bench_picnic");
  const double length = parameters.range(1.45, 1.95);
  const double table = parameters.range(0.71, 0.77);
  const double seat = parameters.range(0.42, 0.46);
  const double half_top = 0.5 * parameters.range(0.64, 0.80);
  const double seat_at = half_top + parameters.range(0.28, 0.34);  ///< middle of a seat
  const double half_seat = 0.5 * parameters.range(0.23, 0.29);
  const double gap = parameters.range(0.020, 0.026);
  const double y = 0.5 * length - parameters.range(0.22, 0.34);
  const Material timber = weatheredWood(parameters);
  std::vector<SdfPtr> boards;
  const double top_z = table - 0.5 * kSlat;
  const double seat_z = seat - 0.5 * kSlat;
  addBoards({half_top, top_z}, {-half_top, top_z}, parameters.count(5, 7), gap, length, boards);
  for (const double side : {-1.0, 1.0}) {
    addBoards({side * seat_at + half_seat, seat_z}, {side * seat_at - half_seat, seat_z}, 2, gap,
              length, boards);
  }
  builder.add(boards, timber);
  std::vector<SdfPtr> frame;
  const double spread = parameters.range(0.6, 0.75) * seat_at;  ///< of a leg's foot
  constexpr double kBeam = 0.052;
  constexpr double kLeg = 0.042;
  for (const double end : {-1.0, 1.0}) {
    const double at = end * y;
    const double z = seat - kSlat - 0.039;
    frame.push_back(roundedBox({0, at, z}, {2 * (seat_at + half_seat) - 0.06, kBeam, 0.09}, 0.008));
    frame.push_back(
        roundedBox({0, at, table - kSlat - 0.039}, {2 * half_top - 0.05, kBeam, 0.09}, 0.008));
    for (const double side : {-1.0, 1.0}) {
      const double inner = 0.45 * half_top;
      const Polyline leg = {{side * (spread + 0.1), 0.0}, {side * inner, table - kSlat - 0.02}};
      // Cut level at the ground.
      frame.push_back(intersect(sideFrame(leg, 0.045, at, kLeg),
                                standingBox({0, at, 0}, {4, 1, table - kSlat + 0.004}, 0)));
    }
    // A brace from the middle of the seat's beam to the table.
    frame.push_back(taperedCapsule({0, at, z}, {0, 0.3 * at, table - kSlat - 0.02}, 0.024, 0.0245));
  }
  frame.push_back(roundedBox({0, 0, table - kSlat - 0.03}, {0.09, 2 * y, 0.05}, 0.008));
  builder.add(frame, parameters.chance(0.7) ? timber : castIron(parameters));
  return finishBench(builder, kSlat, 2);
}

}  // namespace

std::vector<ShapeFamily> benchFamilies() {
  return {makeFamily<buildParkBench>("bench_park", "bench"),
          makeFamily<buildSlabBench>("bench_slab", "bench"),
          makeFamily<buildPicnicBench>("bench_picnic", "bench")};
}

}  // namespace hydrabench
