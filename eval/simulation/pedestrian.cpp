// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/pedestrian.h"

#include <cmath>
#include <numbers>
#include <string>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kThinnest = 0.03;  ///< [m] hands
constexpr double kHip = 0.50;       // heights and lengths as shares of the height of the figure
constexpr double kShoulder = 0.785;
constexpr double kHeel = 0.04;
constexpr double kToe = 0.11;

struct Clothes {
  Material skin;
  Material hair;
  Material coat;
  Material trousers;
  Material shoes;
};

Clothes drawClothes(Parameters& parameters) {
  Clothes clothes;
  clothes.skin = plain(parameters.color({{232, 190, 160}, {198, 146, 110}, {128, 84, 60}}));
  clothes.hair =
      plain(parameters.color({{40, 32, 28}, {92, 62, 40}, {176, 142, 92}, {150, 148, 146}}), 0.1);
  clothes.coat = plain(parameters.color({{170, 44, 48},
                                         {46, 74, 128},
                                         {60, 96, 70},
                                         {206, 168, 62},
                                         {52, 54, 60},
                                         {186, 182, 174},
                                         {124, 82, 132}}));
  clothes.trousers =
      plain(parameters.color({{52, 62, 86}, {44, 44, 48}, {110, 98, 80}, {88, 92, 96}}));
  clothes.shoes = plain(parameters.color({{40, 36, 34}, {92, 62, 44}, {216, 214, 210}}), 0.1);
  return clothes;
}

/// In the frame of the figure.
ShapeInstance trunk(double h, const Clothes& clothes) {
  InstanceBuilder builder("pedestrian_trunk");
  std::vector<SdfPtr> coat = {
      capsule({0, 0, 0.55 * h}, {0, 0, 0.76 * h}, 0.066 * h),
      capsule({0, -0.085 * h, kShoulder * h}, {0, 0.085 * h, kShoulder * h}, 0.042 * h)};
  for (const double y : {-1.0, 1.0}) {
    coat.push_back(taperedCapsule({0, y * 0.042 * h, 0.54 * h}, {0, y * 0.056 * h, 0.755 * h},
                                  0.060 * h, 0.056 * h));
  }
  builder.add(coat, clothes.coat);
  builder.add(capsule({0, -0.042 * h, 0.505 * h}, {0, 0.042 * h, 0.505 * h}, 0.060 * h),
              clothes.trousers);
  builder.add({capsule({0, 0, 0.80 * h}, {0, 0, 0.88 * h}, 0.030 * h),
               ellipsoid({0.008 * h, 0, 0.925 * h}, {0.056 * h, 0.045 * h, 0.074 * h})},
              clothes.skin);
  builder.add(ellipsoid({-0.008 * h, 0, 0.940 * h}, {0.056 * h, 0.050 * h, 0.060 * h}),
              clothes.hair);
  return builder.finish(kThinnest);
}

ShapeInstance leg(double h, const Clothes& clothes) {
  InstanceBuilder builder("pedestrian_leg");
  builder.add({taperedCapsule({0, 0, 0}, {0, 0, -0.245 * h}, 0.050 * h, 0.036 * h),
               taperedCapsule({0, 0, -0.245 * h}, {-0.01 * h, 0, -0.46 * h}, 0.036 * h, 0.026 * h)},
              clothes.trousers);
  builder.add(roundedBox({0.5 * (kToe - kHeel) * h, 0, -(kHip - 0.02) * h},
                         {(kToe + kHeel) * h, 0.052 * h, 0.04 * h}, 0.009 * h),
              clothes.shoes);
  return builder.finish(kThinnest);
}

/// @param side  1: left, -1: right
ShapeInstance arm(double h, double side, const Clothes& clothes) {
  InstanceBuilder builder("pedestrian_arm");
  const Vector3d elbow(0, side * 0.008 * h, -0.17 * h);
  const Vector3d wrist(0.05 * h, side * 0.01 * h, -0.305 * h);
  builder.add({taperedCapsule({0, 0, 0}, elbow, 0.031 * h, 0.026 * h),
               taperedCapsule(elbow, wrist, 0.026 * h, 0.021 * h)},
              clothes.coat);
  builder.add(
      ellipsoid(wrist + Vector3d(0.012 * h, 0, -0.035 * h), {0.02 * h, 0.015 * h, 0.035 * h}),
      clothes.skin);
  return builder.finish(kThinnest);
}

}  // namespace

Transform Pedestrian::limbPose(std::size_t limb, double walked_m) const {
  const double phase = std::sin(2 * std::numbers::pi * walked_m / stride_m);
  const double between = std::abs(limbs[1].swing_rad * phase);
  // The leg behind stands on the tip of its shoe.
  const double hip_m = leg_m * std::cos(between) + toe_m * std::sin(between);
  Transform pose = Transform::Identity();
  pose.linear() =
      Eigen::AngleAxisd(limbs[limb].swing_rad * phase, Vector3d::UnitY()).toRotationMatrix();
  pose.translation() = limbs[limb].joint + Vector3d(0, 0, hip_m - leg_m);
  return pose;
}

Pedestrian drawPedestrian(Random random) {
  Parameters parameters(random);
  Pedestrian person;
  const double h = parameters.range(1.52, 1.88);
  const Clothes clothes = drawClothes(parameters);
  person.height_m = h;
  person.leg_m = kHip * h;
  person.toe_m = kToe * h;
  person.stride_m = parameters.range(0.74, 0.84) * h;
  // Half a step ahead, half a step behind.
  const double leg_swing = std::asin(0.25 * person.stride_m / person.leg_m);
  const double arm_swing = parameters.range(0.6, 1.0) * leg_swing;
  const Vector3d hip(0, 0.05 * h, kHip * h);
  const Vector3d shoulder(0, 0.122 * h, kShoulder * h);
  const auto right = [](const Vector3d& left) { return Vector3d(left.x(), -left.y(), left.z()); };
  person.limbs = {{trunk(h, clothes), Vector3d::Zero(), 0},
                  {leg(h, clothes), hip, leg_swing},
                  {leg(h, clothes), right(hip), -leg_swing},
                  {arm(h, 1, clothes), shoulder, -arm_swing},
                  {arm(h, -1, clothes), right(shoulder), arm_swing}};
  return person;
}

}  // namespace hydrabench
