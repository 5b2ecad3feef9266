// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kChain = 0.008;  ///< [m] radius; the thinnest part there is

/// Cast iron under many coats of paint.
Material paint(Rgb color) {
  Material material = plain(color, 0.4);
  material.pattern = Material::Pattern::kNoise;
  material.second_color = darker(color, 0.8);
  material.pattern_size_m = 0.09;
  return material;
}

/// Paint of barrel and of caps; the second tells a fire brigade the flow, or is the first again.
struct Paints {
  Material body;
  Material caps;
};
Paints drawPaints(Parameters& parameters) {
  const Rgb body = parameters.color({{186, 36, 32},
                                     {226, 178, 38},
                                     {206, 84, 36},
                                     {204, 206, 206},
                                     {42, 84, 150},
                                     {46, 118, 70}});
  const Rgb caps = parameters.color(
      {{212, 214, 214}, {40, 42, 46}, {58, 122, 176}, {60, 132, 78}, {214, 110, 40}, body});
  return {paint(body), paint(caps)};
}

/// Prism around z that stands at `bottom`: the nut a hydrant key fits.
SdfPtr nut(const Vector3d& bottom, int sides, double radius, double height) {
  Polyline corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return moved(extrusion(polygonProfile(corners), Axis::kZ, height, 0.003),
               bottom + Vector3d(0, 0, 0.5 * height));
}

/// Two discs bolted together around z, the lower one from `bottom`.
void addFlange(double bottom, double thickness, double radius, int bolts,
               std::vector<SdfPtr>& pieces) {
  pieces.push_back(cylinder({0, 0, bottom}, {0, 0, bottom + thickness}, radius, 0.006));
  for (int i = 0; i < bolts; ++i) {
    const double angle = 2 * kPi * (i + 0.5) / bolts;
    const double at = radius - 0.022;
    pieces.push_back(nut({at * std::cos(angle), at * std::sin(angle), bottom + thickness - 0.004},
                         6, 0.015, 0.020));
  }
}

/// Where a hose is screwed on.
struct Outlet {
  double yaw;    ///< [rad] from the front
  double pitch;  ///< [rad] upwards
  double height;
  double radius;
  double reach;  ///< of the cap's end, from the axis
};

/// Neck, cap with a rim and a nut on it.
void addOutlet(const Outlet& outlet, std::vector<SdfPtr>& body, std::vector<SdfPtr>& caps) {
  // Built along z, then laid down to the front, raised and turned.
  const auto laid = [&](SdfPtr piece) {
    const SdfPtr forward = turned(std::move(piece), Vector3d::UnitY(), 0.5 * kPi - outlet.pitch);
    return turned(forward, Vector3d::UnitZ(), outlet.yaw, {0, 0, outlet.height});
  };
  const double r = outlet.radius;
  const double cap = outlet.reach - 0.9 * r;
  body.push_back(laid(cylinder({0, 0, 0}, {0, 0, cap + 0.01}, r, 0.004)));
  body.push_back(laid(cylinder({0, 0, cap - 0.034}, {0, 0, cap - 0.012}, 1.2 * r, 0.004)));
  caps.push_back(laid(cylinder({0, 0, cap}, {0, 0, outlet.reach - 0.35 * r}, 1.22 * r, 0.008)));
  caps.push_back(laid(cylinder({0, 0, cap}, {0, 0, cap + 0.022}, 1.22 * r + 0.008, 0.004)));
  caps.push_back(laid(nut({0, 0, outlet.reach - 0.36 * r - 0.004}, 5, 0.023, 0.36 * r + 0.004)));
}

/// A cap's chain, which hangs from the cap to the barrel.
SdfPtr chain(const Outlet& outlet, double barrel, double drop) {
  const Vector3d out(std::cos(outlet.yaw), std::sin(outlet.yaw), 0);
  const Vector3d side(-out.y(), out.x(), 0);
  const Vector3d up = Vector3d::UnitZ() * outlet.height;
  const Vector3d from =
      (outlet.reach - 0.62 * outlet.radius) * out - 1.1 * outlet.radius * Vector3d::UnitZ() + up;
  const Vector3d to = 0.92 * barrel * (0.8 * out + 0.6 * side) + up - drop * Vector3d::UnitZ();
  std::vector<Vector3d> points;
  constexpr int kLinks = 7;
  for (int i = 0; i <= kLinks; ++i) {
    const double t = static_cast<double>(i) / kLinks;
    points.push_back(from + t * (to - from) - 1.4 * drop * t * (1 - t) * Vector3d::UnitZ());
  }
  return tube(points, std::vector<double>(points.size(), kChain));
}

/// A dome of the given height on a cylinder, by the upper half of an ellipsoid.
SdfPtr dome(double bottom, double radius, double height) {
  return intersect(ellipsoid({0, 0, bottom}, {radius, radius, height}),
                   standingBox({0, 0, bottom - 0.01}, {1, 1, 1}, 0));
}

/// The valve is below ground: two hose outlets at the sides, a large one for the pumper in front, a
/// bonnet with the operating nut on top. North America.
ShapeInstance buildDryBarrel(Parameters& parameters) {
  InstanceBuilder builder("hydrant_dry_barrel");
  const double height = parameters.range(0.68, 1.0);
  const double r = parameters.range(0.085, 0.112);
  const double bonnet = height - parameters.range(1.5, 1.9) * r;  ///< height of its flange
  const double ground = parameters.range(0.06, 0.16);             ///< height of the lower flange
  const auto [paint, cap_paint] = drawPaints(parameters);
  const int bolts = 2 * parameters.count(3, 4);

  std::vector<SdfPtr> body = {
      cylinder({0, 0, 0}, {0, 0, ground}, 1.12 * r, 0.006),
      frustum({0, 0, ground - 0.01}, 1.06 * r, 0.96 * r, bonnet - ground + 0.01, 0.004)};
  addFlange(0, 0.03, 1.7 * r, 0, body);
  addFlange(ground, 0.052, 1.72 * r, bolts, body);
  const double outlets = bonnet - parameters.range(1.35, 1.7) * r;
  body.push_back(cylinder({0, 0, outlets - 1.35 * r}, {0, 0, outlets + 1.05 * r}, 1.16 * r, 0.016));
  addFlange(bonnet - 0.026, 0.05, 1.5 * r, bolts, body);

  std::vector<SdfPtr> caps;
  const Outlet pumper = {0, 0, outlets - 0.25 * r, 0.74 * r, parameters.range(2.2, 2.45) * r};
  const double hose = parameters.range(0.48, 0.58) * r;
  const double reach = parameters.range(2.05, 2.3) * r;
  std::vector<Outlet> sides = {{0.5 * kPi, 0, outlets, hose, reach},
                               {-0.5 * kPi, 0, outlets, hose, reach}};
  addOutlet(pumper, body, caps);
  for (const Outlet& side : sides) addOutlet(side, body, caps);

  const double dome_height = parameters.range(0.75, 1.05) * r;
  std::vector<SdfPtr> top = {
      dome(bonnet + 0.02, 1.22 * r, dome_height),
      cylinder({0, 0, bonnet + 0.02}, {0, 0, height - 0.045}, 0.4 * r, 0.008)};
  for (int i = 0; i < 6; ++i) {  // ribs
    const double angle = kPi * i / 3;
    top.push_back(taperedCapsule(
        {1.12 * r * std::cos(angle), 1.12 * r * std::sin(angle), bonnet + 0.025},
        {0.3 * r * std::cos(angle), 0.3 * r * std::sin(angle), bonnet + 0.01 + dome_height}, 0.012,
        0.0125));
  }
  top.push_back(nut({0, 0, height - 0.05}, 5, 0.026, 0.05));
  builder.add(body, paint);
  builder.add(top, parameters.chance(0.7) ? cap_paint : paint);
  builder.add(caps, cap_paint);
  const bool chains = parameters.chance(0.7);
  if (chains) {
    builder.add({chain(pumper, 1.16 * r, 0.05), chain(sides[0], 1.16 * r, 0.05),
                 chain(sides[1], 1.16 * r, 0.05)},
                plain({86, 88, 92}, 0.5));
  }
  return builder.finish(chains ? 2 * kChain : 0.024);
}

/// Each outlet has a valve of its own, whose stem looks out opposite to it; the top is a plain cap.
/// Frost-free coasts.
ShapeInstance buildWetBarrel(Parameters& parameters) {
  InstanceBuilder builder("hydrant_wet_barrel");
  const double height = parameters.range(0.72, 0.96);
  const double r = parameters.range(0.078, 0.098);
  const auto [paint, cap_paint] = drawPaints(parameters);
  const double head = height * parameters.range(0.42, 0.5);
  const double head_radius = r * parameters.range(1.2, 1.32);
  std::vector<SdfPtr> body = {cylinder({0, 0, 0}, {0, 0, head + 0.02}, r, 0.004),
                              frustum({0, 0, head - 0.05}, r, head_radius, 0.06, 0.003),
                              cylinder({0, 0, head}, {0, 0, height - 0.5 * r}, head_radius, 0.012)};
  addFlange(0, 0.045, 1.75 * r, 6, body);
  body.push_back(cylinder({0, 0, 0.04}, {0, 0, 0.075}, 1.18 * r, 0.008));

  std::vector<SdfPtr> caps = {
      cylinder({0, 0, height - 0.62 * r}, {0, 0, height - 0.4 * r}, head_radius + 0.014, 0.008),
      dome(height - 0.42 * r, 0.92 * head_radius, 0.42 * r)};
  std::vector<SdfPtr> stems;
  const int outlets = parameters.count(2, 3);
  const double step = (height - 0.9 * r - head) / outlets;
  for (int i = 0; i < outlets; ++i) {
    Outlet outlet{};
    outlet.yaw = i == 0 ? 0 : (i == 1 ? 0.5 * kPi : -0.5 * kPi) * parameters.range(0.8, 1.0);
    outlet.height = head + 0.25 * r + (i + 0.5) * step;
    outlet.radius = (i == 0 ? 0.72 : 0.5) * r;
    if (i == 0) outlet.height = head + 0.85 * r;
    outlet.reach = parameters.range(2.3, 2.5) * r;
    addOutlet(outlet, body, caps);
    const double back = outlet.yaw + kPi;
    const Vector3d out(std::cos(back), std::sin(back), 0);
    const Vector3d at(0, 0, outlet.height);
    body.push_back(cylinder(at, at + (head_radius + 0.022) * out, 0.5 * r, 0.006));
    stems.push_back(
        turned(turned(nut({0, 0, head_radius + 0.01}, 5, 0.02, 0.05), Vector3d::UnitY(), 0.5 * kPi),
               Vector3d::UnitZ(), back, at));
  }
  builder.add(body, paint);
  builder.add(caps, cap_paint);
  builder.add(stems, plain({150, 140, 110}, 0.5));
  return builder.finish(0.024);
}

/// Slim column with a hood and two outlets that look down and to the sides. Europe.
ShapeInstance buildPillar(Parameters& parameters) {
  InstanceBuilder builder("hydrant_pillar");
  const double height = parameters.range(0.78, 1.1);
  const double r = parameters.range(0.07, 0.088);
  const Rgb color = parameters.color({{190, 34, 30}, {176, 44, 38}, {40, 80, 150}, {206, 74, 34}});
  const Material body_paint = paint(color);
  const Material caps_metal = plain(parameters.color({{186, 188, 190}, {60, 62, 66}}), 0.5);
  const double outlets = height * parameters.range(0.66, 0.72);
  const double hood = outlets + parameters.range(1.3, 1.6) * r;
  std::vector<SdfPtr> body = {frustum({0, 0, 0}, 1.12 * r, r, hood, 0.004),
                              cylinder({0, 0, outlets - 1.2 * r}, {0, 0, hood}, 1.2 * r, 0.014)};
  addFlange(0, 0.035, 1.8 * r, 8, body);
  const double spread = parameters.range(0.9, 1.25);  ///< [rad] from the front to each outlet
  const int count = parameters.count(2, 3);
  std::vector<SdfPtr> caps;
  for (int i = 0; i < count; ++i) {
    const double yaw = i == 2 ? 0 : (i == 0 ? spread : -spread);
    const Outlet outlet = {yaw, -parameters.range(0.3, 0.6), i == 2 ? outlets - 0.2 * r : outlets,
                           i == 2 ? 0.62 * r : 0.5 * r, parameters.range(2.25, 2.5) * r};
    addOutlet(outlet, body, caps);
  }
  const bool round_hood = parameters.chance(0.6);
  const double above = height - 0.045 - hood;
  std::vector<SdfPtr> top = {
      cylinder({0, 0, hood - 0.01}, {0, 0, hood + 0.45 * above}, 1.42 * r, 0.01)};
  if (round_hood) {
    top.push_back(dome(hood + 0.42 * above, 1.38 * r, 0.58 * above));
  } else {
    top.push_back(frustum({0, 0, hood + 0.42 * above}, 1.38 * r, 0.6 * r, 0.58 * above, 0.006));
  }
  top.push_back(nut({0, 0, height - 0.06}, 4, 0.026, 0.06));
  builder.add(body, body_paint);
  builder.add(top, parameters.chance(0.5) ? body_paint : paint({204, 206, 206}));
  builder.add(caps, caps_metal);
  // Reflecting band.
  const double band = height * parameters.range(0.3, 0.42);
  builder.add({cylinder({0, 0, band}, {0, 0, band + 0.07}, 1.12 * r, 0.004)},
              plain({236, 238, 238}, 0.5));
  return builder.finish(0.024);
}

}  // namespace

std::vector<ShapeFamily> hydrantFamilies() {
  return {makeFamily<buildDryBarrel>("hydrant_dry_barrel", "fire_hydrant"),
          makeFamily<buildWetBarrel>("hydrant_wet_barrel", "fire_hydrant"),
          makeFamily<buildPillar>("hydrant_pillar", "fire_hydrant")};
}

}  // namespace hydrabench
