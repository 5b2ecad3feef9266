// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Five legs on castors around a gas column that ends at `top`.
void addStarBase(Parameters& parameters, double top, InstanceBuilder& builder) {
  const double reach = parameters.range(0.28, 0.34);
  const double wheel = parameters.range(0.027, 0.032);
  const double first_angle = parameters.range(0, 2 * kPi / 5);
  const double hub = 2 * wheel + parameters.range(0.035, 0.06);
  const bool bright = parameters.chance(0.4);
  std::vector<SdfPtr> star;
  std::vector<SdfPtr> castors;
  for (int leg = 0; leg < 5; ++leg) {
    const double angle = first_angle + leg * 2 * kPi / 5;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d tip = reach * out + Vector3d(0, 0, 2 * wheel + 0.018);
    star.push_back(taperedCapsule(Vector3d(0, 0, hub), tip, 0.026, 0.016));
    // Castors trail at an angle of their own.
    const double swivel = angle + parameters.range(-1.2, 1.2);
    const Vector3d axle(-std::sin(swivel), std::cos(swivel), 0);
    const Vector3d center =
        tip - Vector3d(0, 0, tip.z() - wheel) + 0.012 * Vector3d(axle.y(), -axle.x(), 0);
    castors.push_back(cylinder(center - 0.026 * axle, center + 0.026 * axle, wheel, 0.007));
    castors.push_back(capsule(tip, Vector3d(tip.x(), tip.y(), wheel + 0.01), 0.0105));
  }
  star.push_back(cylinder({0, 0, hub - 0.035}, {0, 0, hub + 0.045}, 0.036, 0.01));
  builder.add(star, bright ? plain({188, 190, 194}, 0.6) : blackPlastic());
  builder.add(castors, plain({24, 24, 26}, 0.3));
  const double sleeve_top = hub + 0.55 * (top - hub);
  builder.add({cylinder({0, 0, hub}, {0, 0, sleeve_top}, 0.027, 0.004)}, blackPlastic());
  builder.add({cylinder({0, 0, hub}, {0, 0, top}, 0.017, 0.003)}, plain({190, 192, 196}, 0.8));
}

/// Trapezium with round corners in the (y, z) plane, extruded along x: what is cut out of a back.
SdfPtr roundedOutline(double bottom_width, double top_width, double bottom, double top,
                      double corner) {
  const double low = 0.5 * bottom_width - corner;
  const double high = 0.5 * top_width - corner;
  return inflated(extrusion(polygonProfile({{-low, bottom + corner},
                                            {low, bottom + corner},
                                            {high, top - corner},
                                            {-high, top - corner}}),
                            Axis::kX, 3.0, 0),
                  corner);
}

/// Upholstered back: curved around the sitter; origin at the middle of its lower edge.
/// @param shape  outline: below 1 narrower at the top, above 1 narrower at the bottom
SdfPtr curvedBack(double width, double height, double thickness, double sag, double corner,
                  double shape) {
  const Polyline arc = smoothCurve({{0.5 * sag, -0.5 * width + 0.5 * thickness},
                                    {-0.5 * sag, -0.2 * width},
                                    {-0.5 * sag, 0.2 * width},
                                    {0.5 * sag, 0.5 * width - 0.5 * thickness}},
                                   4);
  const SdfPtr plate =
      extrusion(strokeProfile(arc, 0.5 * thickness), Axis::kZ, height, 0.42 * thickness);
  const SdfPtr outline =
      roundedOutline(width * std::min(1.0, 1 / shape), width * std::min(1.0, shape), -0.5 * height,
                     0.5 * height, corner);
  return moved(smoothIntersection(plate, outline, 0.6 * thickness), {0, 0, 0.5 * height});
}

void addArmrests(Parameters& parameters, double seat_top, double seat_width,
                 InstanceBuilder& builder) {
  const double pad_z = seat_top + parameters.range(0.19, 0.25);
  const double pad_length = parameters.range(0.22, 0.30);
  const double pad_width = parameters.range(0.06, 0.09);
  const double y = 0.5 * seat_width + parameters.range(0.02, 0.045);
  const double x = parameters.range(-0.05, 0.02);
  const bool loop = parameters.chance(0.4);
  std::vector<SdfPtr> posts;
  std::vector<SdfPtr> pads;
  for (const double side : {-1.0, 1.0}) {
    const Vector3d root(x, side * (0.5 * seat_width - 0.06), seat_top - 0.075);
    const Vector3d elbow(x, side * y, seat_top - 0.06);
    posts.push_back(capsule(root, elbow, 0.018));
    if (loop) {
      const double half = 0.5 * pad_length;
      const Polyline bow = smoothCurve({{x, elbow.z()},
                                        {x + 0.9 * half, seat_top + 0.03},
                                        {x + half, pad_z - 0.06},
                                        {x + 0.7 * half, pad_z},
                                        {x - 0.7 * half, pad_z},
                                        {x - half, pad_z - 0.06},
                                        {x - 0.9 * half, seat_top + 0.03},
                                        {x, elbow.z()}},
                                       4);
      posts.push_back(
          moved(extrusion(strokeProfile(bow, 0.013), Axis::kY, 0.036, 0.008), {0, side * y, 0}));
    } else {
      posts.push_back(capsule(elbow, {x, side * y, pad_z - 0.01}, 0.019));
      posts.push_back(
          cylinder({x, side * y, elbow.z()}, {x, side * y, seat_top + 0.09}, 0.026, 0.006));
    }
    pads.push_back(moved(
        extrusion(rectangleProfile({0, 0}, {pad_length, pad_width}, 0.026), Axis::kZ, 0.030, 0.012),
        {x, side * y, pad_z + 0.008}));
  }
  builder.add(posts, blackPlastic());
  builder.add(pads, plain({44, 45, 48}, 0.15));
}

ShapeInstance buildOfficeChair(Parameters& parameters, bool arms) {
  InstanceBuilder builder(arms ? "office_chair_arms" : "office_chair");
  const double seat_top = parameters.range(0.44, 0.54);
  const double seat_depth = parameters.range(0.43, 0.50);
  const double seat_width = parameters.range(0.45, 0.52);
  const double seat_thickness = parameters.range(0.06, 0.10);
  const double back_height = arms ? parameters.range(0.48, 0.64) : parameters.range(0.36, 0.52);
  const double back_width = seat_width * parameters.range(0.84, 0.98);
  const double back_bottom = seat_top + parameters.range(0.05, 0.12);
  const double lean = parameters.range(0.08, 0.22);
  const bool net_back = parameters.chance(0.35);
  const bool headrest = arms && parameters.chance(0.3);
  const double thickness = net_back ? 0.026 : parameters.range(0.045, 0.075);
  const double seat_bottom = seat_top - seat_thickness;
  const Material cover = fabric(parameters);
  const Material back_cover =
      net_back ? plain(parameters.color({{96, 99, 104}, {70, 72, 78}, {130, 134, 138}}), 0.1)
               : cover;

  addStarBase(parameters, seat_bottom - 0.01, builder);
  builder.add({standingBox({-0.02, 0, seat_bottom - 0.045}, {0.26, 0.17, 0.06}, 0.012)},
              blackPlastic());

  // Seat: flat cushion with a rolled front edge.
  const SdfPtr cushion = moved(extrusion(rectangleProfile({0, 0}, {seat_depth, seat_width}, 0.11),
                                         Axis::kZ, seat_thickness, 0.42 * seat_thickness),
                               {0.02, 0, seat_bottom + 0.5 * seat_thickness});
  const double roll = 0.55 * seat_thickness;
  const double front = 0.02 + 0.5 * seat_depth - roll - 0.005;
  const SdfPtr front_roll =
      capsule({front, -0.5 * seat_width + 0.12, seat_top - roll - 0.006},
              {front, 0.5 * seat_width - 0.12, seat_top - roll - 0.006}, roll);
  builder.add({smoothUnion(cushion, front_roll, 0.03)}, cover);

  const double back_x = 0.02 - 0.5 * seat_depth + 0.02;
  const auto onBack = [&](SdfPtr sdf) {
    return turned(std::move(sdf), Vector3d::UnitY(), -lean, {back_x, 0, back_bottom});
  };
  const double sag = parameters.range(0.03, 0.06);
  const double shape = net_back ? 1.0 : parameters.range(0.72, 1.28);
  const double corner = net_back ? 0.05 : parameters.range(0.06, 0.15);
  builder.add({onBack(curvedBack(back_width, back_height, thickness, sag, corner, shape))},
              back_cover);
  if (net_back) {  // a tube along the plate's border
    const double w = 0.5 * back_width - 0.5 * thickness;
    const double x = 0.5 * sag;
    const double mid = -0.5 * sag;
    const double low = 0.015;
    const double high = back_height - 0.015;
    builder.add({onBack(tube({{x, -w, low + 0.05},
                              {x, -w, high - 0.05},
                              {0.4 * x, -0.84 * w, high},
                              {mid, -0.4 * w, high},
                              {mid, 0.4 * w, high},
                              {0.4 * x, 0.84 * w, high},
                              {x, w, high - 0.05},
                              {x, w, low + 0.05},
                              {0.4 * x, 0.84 * w, low},
                              {mid, 0.4 * w, low},
                              {mid, -0.4 * w, low},
                              {0.4 * x, -0.84 * w, low},
                              {x, -w, low + 0.05}},
                             std::vector<double>(13, 0.0185)))},
                blackPlastic());
  }
  // Bar that carries the back, from under the seat.
  const double behind = back_x - 0.5 * sag - 0.5 * thickness;
  const double catch_z = back_bottom + 0.42 * back_height;
  const double catch_x = behind - std::tan(lean) * 0.42 * back_height;
  const Polyline bar = smoothCurve({{-0.08, seat_bottom - 0.018},
                                    {behind + 0.03, seat_bottom - 0.018},
                                    {behind - 0.035, seat_top + 0.0},
                                    {behind - 0.025 - std::tan(lean) * 0.1, back_bottom + 0.08},
                                    {catch_x, catch_z}},
                                   5);
  builder.add({extrusion(strokeProfile(bar, 0.012), Axis::kY, parameters.range(0.06, 0.11), 0.008)},
              blackPlastic());
  if (headrest) {
    const double neck = back_height + 0.02;
    builder.add(
        {onBack(moved(roundedBox({-0.3 * sag, 0, neck + 0.085}, {0.07, 0.27, 0.13}, 0.034),
                      {0, 0, 0})),
         onBack(capsule({-0.5 * sag, 0, back_height - 0.08}, {-0.5 * sag, 0, neck + 0.07}, 0.016))},
        back_cover);
  }
  if (arms) addArmrests(parameters, seat_top, seat_width, builder);
  return builder.finish(0.021);
}

ShapeInstance buildOfficeChairWithArms(Parameters& parameters) {
  return buildOfficeChair(parameters, true);
}
ShapeInstance buildOfficeChairPlain(Parameters& parameters) {
  return buildOfficeChair(parameters, false);
}

struct TableChairSize {
  double width;
  double depth;
  double seat;  ///< height of the seat's upper side
  double top;   ///< height of the back's upper edge
  double lean;  ///< of the back [m] at the top
};

/// Wooden chair: the rear legs go on as the posts of the back.
void addWoodenChair(Parameters& parameters, const TableChairSize& size, InstanceBuilder& builder) {
  const Material frame = wood(parameters);
  const double leg = parameters.range(0.030, 0.042);
  const double x = 0.5 * size.depth - 0.5 * leg;
  const double y = 0.5 * size.width - 0.5 * leg;
  const double plate = parameters.range(0.024, 0.036);
  std::vector<SdfPtr> pieces;
  const auto postX = [&](double z) {
    return -x - size.lean * std::max(0.0, z - size.seat) / (size.top - size.seat);
  };
  for (const double side : {-1.0, 1.0}) {
    pieces.push_back(standingBox({x, side * y, 0}, {leg, leg, size.seat - 0.5 * plate}, 0.005));
    const Polyline post = {{-x - 0.02, 0.5 * leg},
                           {-x, 0.6 * size.seat},
                           {-x, size.seat},
                           {postX(size.top - 0.015), size.top - 0.015}};
    pieces.push_back(
        moved(extrusion(strokeProfile(post, 0.46 * leg), Axis::kY, leg, 0.005), {0, side * y, 0}));
    pieces.push_back(standingBox({0, side * y, size.seat - plate - 0.05},
                                 {2 * x, 0.5 * leg + 0.006, 0.055}, 0.004));
  }
  for (const double end : {-1.0, 1.0}) {
    pieces.push_back(standingBox({end * x, 0, size.seat - plate - 0.05},
                                 {0.5 * leg + 0.006, 2 * y, 0.055}, 0.004));
  }
  const double low = size.seat + parameters.range(0.10, 0.16);
  const double high = size.top - 0.01;
  const auto rail = [&](double z, double height) {
    return turned(roundedBox({0, 0, 0}, {0.024, 2 * y, height}, 0.007), Vector3d::UnitY(),
                  -std::atan2(size.lean, size.top - size.seat), {postX(z), 0, z});
  };
  const int style = parameters.choice(3);
  const double head = parameters.range(0.06, 0.10);
  pieces.push_back(rail(high - 0.5 * head, head));
  if (style == 0) {
    pieces.push_back(rail(low, 0.045));
    const int slats = parameters.count(3, 5);
    for (int i = 1; i <= slats; ++i) {
      const double s = -y + 2 * y * i / (slats + 1);
      pieces.push_back(capsule({postX(low), s, low}, {postX(high - 0.03), s, high - 0.03}, 0.0115));
    }
  } else if (style == 1) {
    const int rails = parameters.count(2, 3);
    for (int i = 0; i < rails; ++i) {
      pieces.push_back(rail(low + i * (high - head - low) / rails, 0.05));
    }
  } else {
    pieces.push_back(rail(0.5 * (low + high - 0.02), high - low - 0.03));
  }
  builder.add(pieces, frame);
  const bool padded = parameters.chance(0.4);
  const SdfPtr seat =
      moved(extrusion(rectangleProfile({0, 0}, {size.depth + 0.02, size.width + 0.01}, 0.03),
                      Axis::kZ, plate, 0.009),
            {0.012, 0, size.seat - 0.5 * plate});
  builder.add({seat}, frame);
  if (padded) {
    builder.add(
        {moved(extrusion(rectangleProfile({0, 0}, {size.depth - 0.03, size.width - 0.03}, 0.05),
                         Axis::kZ, 0.045, 0.018),
               {0.012, 0, size.seat + 0.008})},
        fabric(parameters));
  }
}

/// One-piece shell on splayed legs or on a tubular frame.
void addShellChair(Parameters& parameters, const TableChairSize& size, InstanceBuilder& builder) {
  const double front = 0.5 * size.depth;
  const double bend = -0.5 * size.depth + 0.05;
  const Polyline side = smoothCurve({{front, size.seat - 0.03},
                                     {front - 0.06, size.seat},
                                     {0, size.seat - 0.015},
                                     {bend, size.seat},
                                     {bend - 0.05, size.seat + 0.10},
                                     {bend - 0.05 - 0.5 * size.lean, 0.5 * (size.seat + size.top)},
                                     {bend - 0.05 - size.lean, size.top - 0.01}},
                                    4);
  const double sheet = parameters.range(0.020, 0.024);
  const SdfPtr body = extrusion(strokeProfile(side, 0.5 * sheet), Axis::kY, size.width, 0.008);
  // Seen from the front the shell narrows towards its rounded top.
  const double narrow = parameters.range(0.70, 0.98) * size.width;
  const double corner = std::min(parameters.range(0.05, 0.16), 0.45 * narrow);
  const SdfPtr outline =
      roundedOutline(size.width + 0.12, narrow, size.seat - 0.35, size.top, corner);
  const Material shell_material = parameters.chance(0.6)
                                      ? plain(parameters.color({{228, 228, 224},
                                                                {196, 60, 48},
                                                                {50, 52, 56},
                                                                {60, 120, 150},
                                                                {222, 176, 60},
                                                                {120, 150, 110}}),
                                              0.4)
                                      : wood(parameters);
  builder.add({smoothIntersection(body, outline, 0.6 * sheet)}, shell_material);

  const bool wooden = parameters.chance(0.5);
  const double foot = wooden ? 0.013 : 0.0115;
  const double head = wooden ? 0.020 : 0.0115;
  const double splay = parameters.range(0.02, 0.07);
  const double under = size.seat - 0.02;
  const double x = 0.32 * size.depth;
  const double y = 0.34 * size.width;
  std::vector<SdfPtr> legs;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      legs.push_back(taperedCapsule({sx * (x + splay), sy * (y + splay), foot},
                                    {sx * x, sy * y, under - 0.015}, foot, head + 1e-4));
    }
    legs.push_back(capsule({sx * x, -y, under - 0.015}, {sx * x, y, under - 0.015}, 0.0115));
    legs.push_back(capsule({-x, sx * y, under - 0.015}, {x, sx * y, under - 0.015}, 0.0115));
  }
  builder.add(legs, wooden ? wood(parameters) : metal(parameters));
}

ShapeInstance buildTableChair(Parameters& parameters) {
  TableChairSize size{};
  size.width = parameters.range(0.39, 0.48);
  size.depth = parameters.range(0.39, 0.46);
  size.seat = parameters.range(0.43, 0.48);
  size.top = parameters.range(0.78, 0.98);
  size.lean = parameters.range(0.03, 0.10);
  InstanceBuilder builder("table_chair");
  if (parameters.choice(5) < 3) {
    addWoodenChair(parameters, size, builder);
  } else {
    addShellChair(parameters, size, builder);
  }
  return builder.finish(0.02);
}

}  // namespace

std::vector<ShapeFamily> chairFamilies() {
  return {makeFamily<buildOfficeChairWithArms>("office_chair_arms", "chair"),
          makeFamily<buildOfficeChairPlain>("office_chair", "chair"),
          makeFamily<buildTableChair>("table_chair", "chair")};
}

}  // namespace hydrabench
