// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/families/car_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kTyre = 0.21;      ///< [m] width
constexpr double kArchGap = 0.055;  ///< [m] between tyre and wheel arch
constexpr double kWide = 4;         ///< [m] wider than any car
/// How far a region of another colour stands off the panel it lies on: enough to win, too little to
/// see.
constexpr double kFilm = 0.0015;

Material glass() { return plain({34, 42, 50}, 0.9); }
Material blackTrim() { return plain({40, 41, 44}, 0.2); }

/// The part of a panel that lies within a region, in a colour of its own.
SdfPtr film(const SdfPtr& panel, SdfPtr region) {
  return intersect(inflated(panel, kFilm), std::move(region));
}

SdfPtr mirrored(const Vector3d& center, const Vector3d& dimensions, double rounding) {
  const Vector3d other(center.x(), -center.y(), center.z());
  return unite({roundedBox(center, dimensions, rounding), roundedBox(other, dimensions, rounding)});
}

/// x of windscreen and rear window at a height.
double screenAt(const CarSize& size, double z) {
  return size.screen_foot +
         (z - size.belt) / (size.height - 0.05 - size.belt) * (size.screen_top - size.screen_foot);
}
double rearAt(const CarSize& size, double z) {
  return size.rear_foot +
         (z - size.belt) / (size.height - 0.06 - size.belt) * (size.roof_rear - size.rear_foot);
}

/// Outline of the plan, as far inside the bumpers as said.
SdfPtr fromAbove(const CarSize& size, double inset) {
  return moved(extrusion(rectangleProfile({0, 0}, {size.length - 2 * inset, size.width}, 0.45),
                         Axis::kZ, size.height + 1, 0),
               {0, 0, 0.5 * size.height});
}

SdfPtr tub(const CarSize& size) {
  const double h = 0.5 * size.length;
  const double c = size.clearance;
  const double w = 0.5 * size.width;
  const double foot = size.screen_foot;
  const double bonnet = 0.5 * (foot + h - 0.28);
  const Polyline side = {{-h + 0.14, c},
                         {-h + 0.01, c + 0.13},
                         {-h, 0.55 * size.deck},
                         {-h + 0.05, size.deck - 0.13},
                         {-h + 0.13, size.deck},
                         {-h + 0.50, size.deck + 0.01},
                         {foot + 0.06, size.belt + 0.01},
                         {bonnet, 0.45 * size.belt + 0.55 * size.nose + 0.03},
                         {h - 0.28, size.nose},
                         {h - 0.07, size.nose - 0.11},
                         {h, 0.5 * size.nose + 0.16},
                         {h - 0.01, c + 0.12},
                         {h - 0.16, c}};
  const double waist = 0.55 * size.belt + 0.1;
  const Polyline section = {{-0.93 * w, c},
                            {-w, c + 0.16},
                            {-w, waist},
                            {-0.93 * w, size.belt + 0.1},
                            {0.93 * w, size.belt + 0.1},
                            {w, waist},
                            {w, c + 0.16},
                            {0.93 * w, c}};
  SdfPtr body =
      smoothIntersection(smoothIntersection(extrusion(convexProfile(side), Axis::kY, size.width, 0),
                                            fromAbove(size, 0), 0.14),
                         extrusion(convexProfile(section), Axis::kX, size.length + 1, 0), 0.10);
  std::vector<SdfPtr> arches;
  for (const double axle : {size.front_axle, size.rear_axle}) {
    for (const double s : {-1.0, 1.0}) {
      arches.push_back(cylinder({axle, s * (w - kTyre - 0.09), size.wheel},
                                {axle, s * (w + 0.2), size.wheel}, size.wheel + kArchGap, 0.02));
    }
  }
  return subtract(std::move(body), unite(std::move(arches)));
}

SdfPtr cabin(const CarSize& size) {
  const double low = size.belt - 0.14;  // inside the tub
  const double roof = size.height;
  const double front = size.screen_top;
  const double rear = size.roof_rear;
  const Polyline side = {{rearAt(size, low), low},
                         {rearAt(size, low), size.belt - 0.12},
                         {rear, roof - 0.05},
                         {rear + 0.22 * (front - rear), roof - 0.008},
                         {rear + 0.60 * (front - rear), roof},
                         {front, roof - 0.045},
                         {screenAt(size, low), low}};
  const double w = 0.5 * size.width - 0.035;
  const double top = w - size.tumblehome;
  const Polyline section = {{-w, low},          {-w, size.belt},   {-top - 0.02, roof - 0.08},
                            {-0.7 * top, roof}, {0.7 * top, roof}, {top + 0.02, roof - 0.08},
                            {w, size.belt},     {w, low}};
  return smoothIntersection(
      smoothIntersection(extrusion(convexProfile(side), Axis::kY, size.width, 0),
                         extrusion(convexProfile(section), Axis::kX, size.length + 1, 0), 0.13),
      fromAbove(size, 0.02), 0.10);
}

/// Pane in the plane through two points of the x-z plane, with lower and upper width.
SdfPtr screenRegion(const Eigen::Vector2d& foot, const Eigen::Vector2d& top, double foot_width,
                    double top_width) {
  constexpr double kCorner = 0.04;
  const Eigen::Vector2d along = top - foot;
  const double from = 0.09 * along.norm() + kCorner;
  const double to = 0.92 * along.norm() - kCorner;
  const double a = 0.5 * foot_width - kCorner;
  const double b = 0.5 * top_width - kCorner;
  const SdfPtr pane = inflated(
      extrusion(polygonProfile({{from, -a}, {to, -b}, {to, b}, {from, a}}), Axis::kZ, 0.2, 0),
      kCorner);
  return turned(pane, Vector3d::UnitY(), std::atan2(-along.y(), along.x()),
                {foot.x(), 0, foot.y()});
}

}  // namespace

Vector3d surfacePoint(const Sdf& sdf, Vector3d p, const Vector3d& direction) {
  for (int step = 0; step < 200 && sdf.value(p) > 1e-5; ++step) p += sdf.value(p) * direction;
  assert(sdf.value(p) <= 1e-5 && "the ray misses the shape");
  return p;
}

CarBody carBody(const CarSize& size) { return {tub(size), cabin(size)}; }

void addSidePanes(const CarSize& size, const CarBody& body, const std::vector<double>& pillars,
                  double last_pane_to, InstanceBuilder& builder) {
  constexpr double kCorner = 0.025;
  constexpr double kHalfPillar = 0.04;
  const double low = size.belt + 0.04 + kCorner;
  const double high = size.height - 0.12 - kCorner;
  std::vector<SdfPtr> panes;
  for (std::size_t i = 0; i <= pillars.size(); ++i) {
    const auto frontAt = [&](double z) {
      return (i == 0 ? screenAt(size, z) - 0.17 : pillars[i - 1] - kHalfPillar) - kCorner;
    };
    const auto rearEndAt = [&](double z) {
      const double last = std::max(last_pane_to, rearAt(size, z) + 0.15);
      return (i == pillars.size() ? last : pillars[i] + kHalfPillar) + kCorner;
    };
    if (frontAt(low) - rearEndAt(low) < 0.1) continue;
    panes.push_back(inflated(extrusion(polygonProfile({{frontAt(low), low},
                                                       {frontAt(high), high},
                                                       {rearEndAt(high), high},
                                                       {rearEndAt(low), low}}),
                                       Axis::kY, kWide, 0),
                             kCorner));
  }
  for (SdfPtr& pane : panes) pane = film(body.cabin, pane);
  builder.add(std::move(panes), glass());
}

void addScreens(const CarSize& size, const CarBody& body, bool rear, InstanceBuilder& builder) {
  const double w = size.width - 0.07;
  const double lean = 2 * size.tumblehome;
  std::vector<SdfPtr> screens = {film(
      body.cabin, screenRegion({size.screen_foot, size.belt}, {size.screen_top, size.height - 0.05},
                               w - 0.16, w - lean - 0.14))};
  if (rear) {
    screens.push_back(film(
        body.cabin, screenRegion({size.rear_foot, size.belt}, {size.roof_rear, size.height - 0.06},
                                 w - 0.22, w - lean - 0.2)));
  }
  builder.add(std::move(screens), glass());
}

void addWheels(const CarSize& size, int spokes, const Material& rim, InstanceBuilder& builder) {
  const double r = size.wheel;
  const double outer = 0.5 * size.width - 0.015;
  std::vector<SdfPtr> tyres;
  std::vector<SdfPtr> rims;
  for (const double axle : {size.front_axle, size.rear_axle}) {
    for (const double s : {-1.0, 1.0}) {
      const auto at = [&](double y) { return Vector3d(axle, s * y, r); };
      tyres.push_back(subtract(cylinder(at(outer - kTyre), at(outer), r, 0.04),
                               cylinder(at(outer - 0.06), at(outer + 0.1), 0.68 * r, 0.005)));
      tyres.push_back(cylinder(at(0.25 * size.width), at(outer - 0.1), 0.1, 0.01));
      rims.push_back(turned(torus({0, 0, 0}, 0.66 * r, 0.026), Vector3d::UnitX(), 0.5 * kPi,
                            at(outer - 0.014)));
      rims.push_back(cylinder(at(outer - 0.08), at(outer - 0.012), 0.2 * r, 0.012));
      for (int i = 0; i < spokes; ++i) {
        const double angle = 2 * kPi * (i + 0.25) / spokes;
        const Vector3d out(0.66 * r * std::cos(angle), 0, 0.66 * r * std::sin(angle));
        rims.push_back(taperedCapsule(at(outer - 0.035), at(outer - 0.04) + out, 0.034, 0.028));
      }
    }
  }
  builder.add(std::move(tyres), plain({30, 30, 32}));
  builder.add(std::move(rims), rim);
}

void addTrim(const CarSize& size, const CarBody& body, TailLights tail_lights,
             InstanceBuilder& builder) {
  const double h = 0.5 * size.length;
  const double w = 0.5 * size.width;
  const double c = size.clearance;
  builder.add({film(body.tub, mirrored({h - 0.16, 0.72 * w, size.nose - 0.12},
                                       {0.52, 0.42 * w, 0.13}, 0.045))},
              plain({170, 184, 194}, 0.9));
  const bool wide = tail_lights == TailLights::kWide;
  const bool slim = tail_lights == TailLights::kSlim;
  builder.add({film(body.tub, mirrored({-h + 0.10, (slim ? 0.98 : 0.80) * w,
                                        size.deck - (wide ? 0.18 : 0.22)},
                                       {0.5, (slim ? 0.16 : 0.36) * w, wide ? 0.15 : 0.30}, 0.04))},
              plain({168, 22, 26}, 0.8));
  std::vector<SdfPtr> dark = {
      film(body.tub, roundedBox({h, 0, size.nose - 0.13}, {0.5, 0.84 * w, 0.10}, 0.03)),
      film(body.tub, roundedBox({h, 0, c + 0.17}, {0.4, 1.3 * w, 0.13}, 0.04)),
      film(body.tub, roundedBox({-h, 0, c + 0.10}, {0.5, 1.5 * w, 0.12}, 0.03)),
      film(body.tub, standingBox({0, 0, 0}, {2 * kWide, kWide, c + 0.07}, 0.0))};
  for (const double axle : {size.front_axle, size.rear_axle}) {
    for (const double s : {-1.0, 1.0}) {
      dark.push_back(film(
          body.tub, cylinder({axle, s * (w - kTyre - 0.15), size.wheel},
                             {axle, s * (w - 0.05), size.wheel}, size.wheel + kArchGap + 0.03, 0)));
    }
  }
  builder.add(std::move(dark), blackTrim());
  const auto plateAt = [&](double end, double z) {
    const Vector3d at = surfacePoint(*body.tub, {end * (h + 0.5), 0, z}, {-end, 0, 0});
    return roundedBox(at, {0.05, 0.50, 0.11}, 0.008);
  };
  builder.add({plateAt(1, c + 0.27), plateAt(-1, wide ? size.deck - 0.2 : 0.60 * size.deck)},
              plain({232, 232, 226}, 0.3));
}

void addMirrorsAndHandles(const CarSize& size, const CarBody& body, const Material& paint,
                          const std::vector<double>& handles, InstanceBuilder& builder) {
  std::vector<SdfPtr> pieces;
  const double z = size.belt + 0.06;
  const double x = screenAt(size, z) - 0.24;
  for (const double s : {-1.0, 1.0}) {
    const double y = s * (0.5 * size.width + 0.085);
    pieces.push_back(roundedBox({x, y, z + 0.05}, {0.10, 0.19, 0.13}, 0.04));
    pieces.push_back(capsule({x, y, z + 0.01}, {x, s * (0.5 * size.width - 0.16), z}, 0.028));
    for (const double handle : handles) {
      const Vector3d at =
          surfacePoint(*body.tub, {handle, s * size.width, size.belt - 0.13}, {0, -s, 0});
      pieces.push_back(capsule(at - Vector3d(0.07, 0, 0), at + Vector3d(0.07, 0, 0), 0.018));
    }
  }
  builder.add(std::move(pieces), paint);
}

}  // namespace hydrabench
