// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kGoldenAngle = 2.399963;  ///< [rad] between successive leaves of most plants

Material leafMaterial(Parameters& parameters) {
  Material material;
  material.pattern = Material::Pattern::kLeaves;
  material.color =
      parameters.color({{58, 112, 52}, {44, 92, 48}, {84, 136, 60}, {70, 124, 78}, {104, 146, 62}});
  material.second_color =
      parameters.chance(0.25) ? Rgb{168, 190, 110} : darker(material.color, 0.6);
  material.pattern_size_m = parameters.range(0.05, 0.11);
  material.gloss = 0.2;
  return material;
}

Material potMaterial(Parameters& parameters) {
  return plain(parameters.color({{176, 92, 60},
                                 {224, 222, 216},
                                 {66, 68, 72},
                                 {132, 126, 118},
                                 {62, 96, 110},
                                 {198, 160, 110}}),
               0.25);
}

struct Pot {
  double soil_z;
  double soil_radius;
};

/// Round and tapered, or square; filled with soil to just below the rim.
Pot addPot(Parameters& parameters, double radius, double height, InstanceBuilder& builder) {
  const Material material = potMaterial(parameters);
  const Material soil = plain({62, 46, 36});
  const double soil_z = 0.9 * height;
  const double wall = std::max(0.009, 0.07 * radius);
  if (parameters.chance(0.75)) {
    const double foot = radius * parameters.range(0.66, 0.95);
    const SdfPtr body = frustum({0, 0, 0}, foot, radius, height, 0.004);
    const SdfPtr hollow = frustum({0, 0, soil_z}, radius - wall, radius - wall, height, 0.004);
    std::vector<SdfPtr> pieces = {subtract(body, hollow)};
    if (parameters.chance(0.4)) pieces.push_back(torus({0, 0, height - wall}, radius, wall));
    builder.add(pieces, material);
    builder.add(
        {cylinder({0, 0, 0.5 * height}, {0, 0, soil_z + 0.004},
                  0.82 * std::min(radius, foot + 0.8 * (radius - foot)), 0.002),
         frustum({0, 0, soil_z - 0.03}, radius - 1.2 * wall, radius - 0.6 * wall, 0.034, 0.002)},
        soil);
    return {soil_z, radius - wall};
  }
  const double side = 1.8 * radius;
  const SdfPtr body = standingBox({0, 0, 0}, {side, side, height}, 0.01);
  const SdfPtr hollow =
      standingBox({0, 0, soil_z}, {side - 2 * wall, side - 2 * wall, height}, 0.006);
  builder.add({subtract(body, hollow)}, material);
  builder.add({standingBox({0, 0, soil_z - 0.02}, {side - wall, side - wall, 0.024}, 0.002)}, soil);
  return {soil_z, 0.5 * side - wall};
}

/// Thickness of the thinnest leaf edge as a share of the leaf's thickness: rims must be wide enough
/// for the mesh to catch them.
constexpr double kRim = 0.8;

/// Flat ellipsoid with a rounded rim that starts at `root`, points along `along` and shows its face
/// towards `up`.
SdfPtr leaf(const Vector3d& root, const Vector3d& along, const Vector3d& up, double length,
            double width, double thickness) {
  const Vector3d x = along.normalized();
  const Vector3d y = up.cross(x).normalized();
  Transform T = Transform::Identity();
  T.linear().col(0) = x;
  T.linear().col(1) = y;
  T.linear().col(2) = x.cross(y);
  T.translation() = root + 0.42 * length * x;
  const double rim = 0.5 * kRim * thickness;
  return placed(
      T,
      inflated(ellipsoid({0, 0, 0}, {0.5 * length - rim, 0.5 * width - rim, 0.5 * thickness - rim}),
               rim));
}

/// Long leaf that rises and bends over, pointed at both ends; starts at the origin towards x.
SdfPtr archingBlade(double length, double width, double thickness, double rise, double droop) {
  const Polyline spine = smoothCurve({{0, 0},
                                      {0.28 * length, rise * length},
                                      {0.68 * length, (1.35 * rise - 0.2 * droop) * length},
                                      {length, (rise - droop) * length}},
                                     3);
  Polyline outline;
  constexpr int kSteps = 7;
  for (int i = 0; i < 2 * kSteps; ++i) {
    const double t = static_cast<double>(i < kSteps ? i : 2 * kSteps - i) / kSteps;
    const double half =
        0.5 * width * (0.25 + 0.75 * std::sin(kPi * std::pow(t, 0.75))) * (1 - t * t * t);
    outline.push_back({-0.02 + t * (length + 0.03), i < kSteps ? half : -half});
  }
  return smoothIntersection(
      extrusion(strokeProfile(spine, 0.5 * thickness), Axis::kY, width + 0.02, 0),
      inflated(extrusion(polygonProfile(outline), Axis::kZ, 3 * length, 0), 0.5 * thickness),
      0.5 * thickness);
}

/// Stem from the soil that leaves upright and bends outward; its points.
std::vector<Vector3d> stemPoints(const Vector3d& root, double yaw, double height, double reach) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= 4; ++i) {
    const double t = i / 4.0;
    points.push_back(
        root + Vector3d(reach * t * t * std::cos(yaw), reach * t * t * std::sin(yaw), height * t));
  }
  return points;
}

Vector3d direction(double yaw, double elevation) {
  return {std::cos(elevation) * std::cos(yaw), std::cos(elevation) * std::sin(yaw),
          std::sin(elevation)};
}

/// Small tree: a trunk, branches, and leaves all along them.
void addTree(Parameters& parameters, const Pot& pot, double height, double spread, double thickness,
             InstanceBuilder& builder) {
  const double trunk_top = pot.soil_z + (height - pot.soil_z) * parameters.range(0.45, 0.6);
  const Vector3d base(0, 0, pot.soil_z - 0.03);
  const Vector3d top(parameters.range(-0.05, 0.05), parameters.range(-0.05, 0.05), trunk_top);
  const double trunk = parameters.range(0.016, 0.028);
  std::vector<SdfPtr> wood_pieces = {
      tube({base,
            0.5 * (base + top) +
                Vector3d(parameters.range(-0.03, 0.03), parameters.range(-0.03, 0.03), 0),
            top},
           {1.2 * trunk, trunk, 0.8 * trunk})};
  std::vector<SdfPtr> leaves;
  const int branches = parameters.count(7, 10);
  const double size = parameters.range(0.13, 0.19);
  for (int b = 0; b < branches; ++b) {
    const double yaw = b * kGoldenAngle + parameters.range(-0.3, 0.3);
    const double up = b == 0 ? 1.45 : parameters.range(0.35, 1.2);
    const double reach = b == 0 ? height - trunk_top - 0.3 * size
                                : std::min(spread / std::max(std::cos(up), 0.45),
                                           (height - trunk_top) / std::max(std::sin(up), 0.3)) *
                                      parameters.range(0.75, 0.95);
    const Vector3d start = base + (top - base) * (b == 0 ? 1.0 : parameters.range(0.72, 1.0));
    const Vector3d out = direction(yaw, up);
    wood_pieces.push_back(taperedCapsule(start, start + reach * out, 0.010, 0.0055));
    const int count = parameters.count(6, 8);
    for (int i = 0; i < count; ++i) {
      const Vector3d root = start + reach * (0.35 + 0.65 * i / (count - 1.0)) * out;
      const double leaf_yaw = yaw + i * kGoldenAngle;
      const Vector3d along = direction(leaf_yaw, parameters.range(-0.25, 0.55)) + 0.5 * out;
      const double length = size * parameters.range(0.8, 1.15);
      leaves.push_back(leaf(root, along, Vector3d::UnitZ() + 0.4 * direction(leaf_yaw + 1, 0),
                            length, 0.5 * length, thickness));
    }
  }
  builder.add(wood_pieces, plain({116, 92, 70}));
  builder.add(leaves, leafMaterial(parameters));
}

/// One or more bare stems, each with a crown of arching blades (dracaena, palm).
void addPalm(Parameters& parameters, const Pot& pot, double height, double spread, double thickness,
             InstanceBuilder& builder) {
  const int stems = parameters.count(1, 3);
  std::vector<SdfPtr> trunks;
  std::vector<SdfPtr> blades;
  for (int s = 0; s < stems; ++s) {
    const double yaw = s * 2.1 + parameters.range(0, 1);
    const double offset = stems > 1 ? 0.35 * pot.soil_radius : 0;
    const double top = pot.soil_z + (height - pot.soil_z) * (s == 0 ? 0.62 : 0.62 - 0.17 * s);
    const Vector3d base(offset * std::cos(yaw), offset * std::sin(yaw), pot.soil_z - 0.03);
    const Vector3d crown(1.6 * base.x(), 1.6 * base.y(), top);
    trunks.push_back(taperedCapsule(base, crown, 0.026, 0.019));
    const int count = parameters.count(12, 16);
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count;  // inner blades stand, outer ones hang
      const double length =
          spread * (0.8 + 0.35 * std::sin(kPi * share)) * parameters.range(0.9, 1.1);
      const double rise = 0.75 - 0.5 * share;
      const double droop = 0.15 + 0.45 * share;
      blades.push_back(turned(
          archingBlade(length, parameters.range(0.045, 0.065), thickness, rise, droop),
          Vector3d::UnitZ(), yaw + i * kGoldenAngle, crown + Vector3d(0, 0, 0.02 - 0.05 * share)));
    }
  }
  builder.add(trunks, plain({138, 112, 84}));
  builder.add(blades, leafMaterial(parameters));
}

/// Stems from the soil, each with one big leaf that looks outward (rubber plant, peace lily).
void addBroadLeaves(Parameters& parameters, const Pot& pot, double height, double spread, int stems,
                    double thickness, InstanceBuilder& builder) {
  std::vector<SdfPtr> stalks;
  std::vector<SdfPtr> leaves;
  const double stalk = 0.5 * thickness + 0.001;
  const double slender = parameters.range(0.42, 0.62);
  for (int i = 0; i < stems; ++i) {
    const double share = (i + 0.5) / stems;
    const double yaw = i * kGoldenAngle + parameters.range(-0.2, 0.2);
    const double length = (0.30 + 0.10 * parameters.range(-1, 1)) * spread * 2.05;
    const double top =
        pot.soil_z + (height - pot.soil_z) * (1.0 - 0.62 * share) - 0.35 * length * (1 - share);
    const double reach = spread * (0.12 + 0.55 * share);
    const double at = 0.3 * pot.soil_radius * std::sqrt(share);
    const std::vector<Vector3d> points =
        stemPoints({at * std::cos(yaw), at * std::sin(yaw), pot.soil_z - 0.01}, yaw,
                   std::max(0.06, top - pot.soil_z), reach);
    stalks.push_back(tube(points, {1.3 * stalk, 1.2 * stalk, 1.1 * stalk, stalk, stalk}));
    const double tilt = 0.75 - 0.95 * share + parameters.range(-0.15, 0.15);
    leaves.push_back(leaf(points.back() - 0.012 * direction(yaw, tilt), direction(yaw, tilt),
                          direction(yaw, tilt + 0.5 * kPi), length, slender * length, thickness));
  }
  builder.add(stalks, plain({86, 120, 62}));
  builder.add(leaves, leafMaterial(parameters));
}

/// Stiff upright swords (snake plant).
void addSwords(Parameters& parameters, const Pot& pot, double height, double thickness,
               InstanceBuilder& builder) {
  std::vector<SdfPtr> swords;
  const int count = parameters.count(9, 13);
  for (int i = 0; i < count; ++i) {
    const double yaw = i * kGoldenAngle;
    const double share = (i + 0.5) / count;
    const double at = 0.62 * pot.soil_radius * std::sqrt(share);
    const double length =
        (height - pot.soil_z) * (1.05 - 0.45 * share) * parameters.range(0.9, 1.05);
    const Vector3d root(at * std::cos(yaw), at * std::sin(yaw), pot.soil_z - 0.06 * length);
    swords.push_back(leaf(root, direction(yaw, 1.5 - 0.3 * share), direction(yaw + 0.6, 0), length,
                          parameters.range(0.14, 0.2) * length, 1.3 * thickness));
  }
  Material material = leafMaterial(parameters);
  material.second_color = {170, 182, 92};
  builder.add(swords, material);
}

/// Rosette of fleshy, upward bent leaves (aloe).
void addRosette(Parameters& parameters, const Pot& pot, double height, double spread,
                InstanceBuilder& builder) {
  std::vector<SdfPtr> leaves;
  const int count = parameters.count(14, 20);
  const double rise = height - pot.soil_z;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const double yaw = i * kGoldenAngle;
    const Vector3d out = direction(yaw, 0);
    const Vector3d root(0, 0, pot.soil_z + 0.004);
    const double reach = spread * (0.15 + 0.85 * share);
    const double top = rise * (1.0 - 0.55 * share) - 0.01;
    leaves.push_back(tube({root, root + 0.55 * reach * out + Vector3d(0, 0, 0.4 * top),
                           root + reach * out + Vector3d(0, 0, top)},
                          {0.085 * rise, 0.07 * rise, 0.0045}));
  }
  builder.add(leaves, leafMaterial(parameters));
}

ShapeInstance buildLargePlant(Parameters& parameters) {
  InstanceBuilder builder("plant_large");
  const double height = parameters.range(1.12, 1.78);
  const Pot pot =
      addPot(parameters, parameters.range(0.15, 0.22), parameters.range(0.26, 0.40), builder);
  const double spread = parameters.range(0.34, 0.48);
  constexpr double kThickness = 0.013;
  switch (parameters.choice(3)) {
    case 0:
      addTree(parameters, pot, height, spread, kThickness, builder);
      break;
    case 1:
      addPalm(parameters, pot, height, 1.2 * spread, kThickness, builder);
      break;
    default:
      addBroadLeaves(parameters, pot, height, 1.15 * spread, parameters.count(14, 19), kThickness,
                     builder);
  }
  return builder.finish(kThickness);
}

ShapeInstance buildSmallPlant(Parameters& parameters) {
  InstanceBuilder builder("plant_small");
  const double height = parameters.range(0.32, 0.58);
  const Pot pot =
      addPot(parameters, parameters.range(0.075, 0.115), parameters.range(0.11, 0.17), builder);
  const double spread = parameters.range(0.15, 0.21);
  constexpr double kThickness = 0.009;
  switch (parameters.choice(3)) {
    case 0:
      addBroadLeaves(parameters, pot, height, spread, parameters.count(14, 20), kThickness,
                     builder);
      break;
    case 1:
      addSwords(parameters, pot, height, kThickness, builder);
      break;
    default:
      addRosette(parameters, pot, 0.8 * height, spread, builder);
  }
  return builder.finish(kThickness);
}

}  // namespace

std::vector<ShapeFamily> plantFamilies() {
  return {makeFamily<buildLargePlant>("plant_large", "plant"),
          makeFamily<buildSmallPlant>("plant_small", "plant")};
}

}  // namespace hydrabench
