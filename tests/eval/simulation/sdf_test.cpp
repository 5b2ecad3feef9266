// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/types/random.h"
#include "eval/simulation/sdf_operators.h"
#include "eval/simulation/sdf_primitives.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

Vector3d randomPoint(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

/// Steps along the gradient by the value lead to the surface: true wherever the distance is exact
/// and smooth.
void expectExactOutside(const Sdf& sdf, double tolerance) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const Vector3d p = randomPoint(random, 2);
    const double distance = sdf.value(p);
    if (distance < 0.05) continue;
    const Vector3d foot = p - distance * sdfNormal(sdf, p);
    EXPECT_NEAR(sdf.value(foot), 0, tolerance) << p.transpose();
  }
}

TEST(Sphere, HasTheDistanceToItsCentreLessItsRadius) {
  const SdfPtr sdf = sphere({1, 0, 0}, 0.5);
  EXPECT_DOUBLE_EQ(sdf->value({3, 0, 0}), 1.5);
  EXPECT_DOUBLE_EQ(sdf->value({1, 0, 0}), -0.5);
}

TEST(RoundedBox, MeasuresFacesEdgesAndCorners) {
  const SdfPtr sharp = roundedBox({0, 0, 0}, {2, 4, 6}, 0);
  EXPECT_DOUBLE_EQ(sharp->value({2, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(sharp->value({4, 6, 0}), 5);  // edge: 3-4-5
  EXPECT_DOUBLE_EQ(sharp->value({3, 4, 4}), 3);  // corner: 2-2-1
  EXPECT_DOUBLE_EQ(sharp->value({0.75, 0, 0}), -0.25);
  const SdfPtr round = roundedBox({0, 0, 0}, {2, 4, 6}, 0.5);
  EXPECT_DOUBLE_EQ(round->value({2, 0, 0}), 1);  // faces stay where they are
  EXPECT_DOUBLE_EQ(round->value({3.5, 5.5, 0}),
                   4.5);  // 3-4-5 to the edge's axis, less the rounding
}

TEST(Ellipsoid, IsExactOnItsAxes) {
  const SdfPtr sdf = ellipsoid({0, 0, 0}, {3, 2, 1});
  EXPECT_NEAR(sdf->value({5, 0, 0}), 2, 1e-9);
  EXPECT_NEAR(sdf->value({0, 0, 4}), 3, 1e-9);
  EXPECT_NEAR(sdf->value({0, 0, 0}), -1, 1e-9);
}

TEST(Ellipsoid, AgreesWithASearchOverItsSurface) {
  const Vector3d radii(0.9, 0.5, 0.1);
  const SdfPtr sdf = ellipsoid({0, 0, 0}, radii);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vector3d p = randomPoint(random, 1);
    double nearest = 10;
    constexpr int kSteps = 700;
    for (int a = 0; a <= kSteps; ++a) {
      const double polar = std::numbers::pi * a / kSteps;
      for (int b = 0; b < 2 * kSteps; ++b) {
        const double azimuth = std::numbers::pi * b / kSteps;
        const Vector3d q(radii.x() * std::sin(polar) * std::cos(azimuth),
                         radii.y() * std::sin(polar) * std::sin(azimuth),
                         radii.z() * std::cos(polar));
        nearest = std::min(nearest, (p - q).squaredNorm());
      }
    }
    EXPECT_NEAR(std::abs(sdf->value(p)), std::sqrt(nearest), 1e-4) << p.transpose();
  }
}

TEST(TaperedCapsule, IsACapsuleWhenBothRadiiAreEqual) {
  const Vector3d a(0.1, -0.2, 0.3);
  const Vector3d b(-0.4, 0.6, 1.0);
  const SdfPtr tapered = taperedCapsule(a, b, 0.2, 0.2);
  const SdfPtr plain = capsule(a, b, 0.2);
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d p = randomPoint(random, 2);
    EXPECT_NEAR(tapered->value(p), plain->value(p), 1e-12);
  }
}

TEST(Frustum, KeepsItsHeightAndRadii) {
  const SdfPtr sdf = frustum({0, 0, 1}, 0.5, 0.3, 2, 0.05);
  EXPECT_NEAR(sdf->value({0, 0, 1}), 0, 1e-12);
  EXPECT_NEAR(sdf->value({0, 0, 3}), 0, 1e-12);
  EXPECT_NEAR(sdf->value({0.4, 0, 2}), 0, 1e-12);
}

TEST(Extrusion, OfARectangleIsABox) {
  const SdfPtr box = roundedBox({0, 0, 0}, {0.6, 1.0, 0.8}, 0);
  const SdfPtr drawn =
      extrusion(rectangleProfile({0, 0}, {1.0, 0.8}, 0), Axis::kX, 0.6, 0);  // profile in (y, z)
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vector3d p = randomPoint(random, 1);
    EXPECT_NEAR(drawn->value(p), box->value(p), 1e-12);
  }
}

TEST(ConvexProfile, AgreesWithThePolygonInsideAndStaysBelowItOutside) {
  const Polyline corners = {{-0.6, -0.3}, {0.5, -0.4}, {0.8, 0.1}, {0.1, 0.6}, {-0.5, 0.4}};
  const SdfProfilePtr polygon = polygonProfile(corners);
  const SdfProfilePtr convex = convexProfile(corners);
  const SdfProfilePtr reversed = convexProfile(Polyline(corners.rbegin(), corners.rend()));
  Random random(17);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    EXPECT_NEAR(reversed->value(p), convex->value(p), 1e-12);
    if (polygon->value(p) <= 0) {
      EXPECT_NEAR(convex->value(p), polygon->value(p), 1e-12);
    } else {
      EXPECT_GT(convex->value(p), 0);
      EXPECT_LE(convex->value(p), polygon->value(p) + 1e-12);
    }
  }
}

TEST(Primitives, MeasureTheExactDistanceOutside) {
  expectExactOutside(*roundedBox({0, 0, 0}, {1, 0.6, 0.4}, 0.1), 1e-6);
  expectExactOutside(*ellipsoid({0, 0, 0}, {0.8, 0.4, 0.05}), 1e-5);
  expectExactOutside(*taperedCapsule({0, 0, -0.5}, {0.2, 0, 0.5}, 0.3, 0.1), 1e-6);
  expectExactOutside(*cylinder({0, -0.3, 0}, {0.3, 0.3, 0.2}, 0.3, 0.05), 1e-6);
  expectExactOutside(*torus({0, 0, 0}, 0.6, 0.1), 1e-6);
  expectExactOutside(*frustum({0, 0, -0.5}, 0.5, 0.3, 1, 0.05), 1e-6);
}

TEST(Union, SkippingByBoxesChangesNothing) {
  Random random(11);
  std::vector<SdfPtr> leaves;
  for (int i = 0; i < 20; ++i) leaves.push_back(sphere(randomPoint(random, 1), 0.1));
  const SdfPtr whole = unite(leaves);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p = randomPoint(random, 1.5);
    double expected = 10;
    for (const SdfPtr& leaf : leaves) expected = std::min(expected, leaf->value(p));
    EXPECT_EQ(whole->value(p), expected);
  }
}

TEST(Shell, KeepsTheSkinOnly) {
  const SdfPtr sdf = shell(sphere({0, 0, 0}, 1), 0.2);
  EXPECT_NEAR(sdf->value({1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(sdf->value({0.9, 0, 0}), -0.1, 1e-12);
  EXPECT_NEAR(sdf->value({0.8, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(sdf->value({0, 0, 0}), 0.8, 1e-12);
}

TEST(Placed, IsMeasuredInTheChildFrame) {
  const SdfPtr sdf = turned(roundedBox({0, 0, 0}, {2, 1, 1}, 0), Vector3d::UnitZ(),
                            std::numbers::pi / 2, {0, 5, 0});
  EXPECT_NEAR(sdf->value({0, 7, 0}), 1, 1e-12);  // the long side now runs along y
  EXPECT_NEAR(sdf->value({1, 5, 0}), 0.5, 1e-12);
}

struct NamedSdf {
  std::string name;
  SdfPtr sdf;
};

std::vector<NamedSdf> operatorsAndPrimitives() {
  const SdfPtr a = roundedBox({0, 0, 0}, {1, 0.5, 0.5}, 0.05);
  const SdfPtr b = ellipsoid({0.4, 0, 0.2}, {0.5, 0.3, 0.08});
  return {{"ellipsoid", b},
          {"tapered capsule", taperedCapsule({0, 0, -0.4}, {0.3, 0, 0.4}, 0.05, 0.3)},
          {"frustum", frustum({0, 0, 0}, 0.5, 0.2, 0.6, 0.04)},
          {"stroke",
           extrusion(strokeProfile({{-0.5, 0}, {0, 0.3}, {0.5, 0}}, 0.04), Axis::kY, 0.5, 0.02)},
          {"convex extrusion",
           extrusion(convexProfile({{-0.5, 0}, {0, 0.6}, {0.7, 0}}), Axis::kY, 0.5, 0.02)},
          {"revolution", revolution(strokeProfile({{0.2, 0}, {0.4, 0.6}}, 0.03))},
          {"smooth union", smoothUnion(a, b, 0.2)},
          {"intersection", intersect(a, b)},
          {"smooth intersection", smoothIntersection(a, b, 0.1)},
          {"difference", subtract(a, b)},
          {"shell", shell(a, 0.1)},
          {"inflated", inflated(b, 0.05)},
          {"turned", turned(a, {1, 2, 3}, 0.7, {0.1, 0.2, 0.3})}};
}

TEST(Sdf, ChangesNoFasterThanThePointMoves) {
  for (const NamedSdf& item : operatorsAndPrimitives()) {
    Random random(23);
    for (int i = 0; i < 4000; ++i) {
      const Vector3d p = randomPoint(random, 1);
      const Vector3d q = p + randomPoint(random, i % 2 == 0 ? 1.0 : 1e-3);
      const double change = std::abs(item.sdf->value(p) - item.sdf->value(q));
      ASSERT_LE(change, (p - q).norm() * (1 + 1e-9) + 1e-12) << item.name;
    }
  }
}

TEST(Sdf, BoundsContainTheShape) {
  for (const NamedSdf& item : operatorsAndPrimitives()) {
    const Aabb box = item.sdf->bounds();
    Random random(29);
    for (int i = 0; i < 4000; ++i) {
      const Vector3d p = randomPoint(random, 1);
      if (item.sdf->value(p) < 0) {
        ASSERT_TRUE(box.contains(p)) << item.name;
      }
    }
  }
}

}  // namespace
}  // namespace hydrabench
