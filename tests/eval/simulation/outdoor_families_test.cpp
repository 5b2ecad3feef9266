// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/sdf_queries.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

/// Distance fields of every family of a class, several instances each.
std::vector<ShapeInstance> instancesOf(const std::string& class_name, std::uint64_t count) {
  std::vector<ShapeInstance> instances;
  for (const ShapeFamily& family : outdoorFamilies()) {
    if (family.class_name != class_name) continue;
    instances.push_back(family.nominal());
    for (std::uint64_t i = 0; i < count; ++i) {
      instances.push_back(family.draw(Random(instanceSeed(InstanceSplit::kEvaluation, 40 + i))));
    }
  }
  return instances;
}

TEST(Cars, AreAlikeOnBothSides) {
  for (const ShapeInstance& car : instancesOf("car", 6)) {
    const Aabb box = car.sdf->bounds();
    Random random(3);
    for (int i = 0; i < 300; ++i) {
      const Vector3d p(random.uniform(box.min().x(), box.max().x()), random.uniform(0, 1.2),
                       random.uniform(0, box.max().z()));
      const Vector3d mirrored(p.x(), -p.y(), p.z());
      ASSERT_NEAR(car.sdf->value(p), car.sdf->value(mirrored), 1e-9) << car.family;
    }
  }
}

TEST(Cars, StandOnFourWheelsWithAWheelbaseOfCars) {
  for (const ShapeInstance& car : instancesOf("car", 6)) {
    const Aabb box = tightBounds(*car.sdf);
    std::optional<double> rear;  // x of the tyres' contact, on either side of the middle
    std::optional<double> front;
    for (double x = box.min().x(); x < box.max().x(); x += 0.01) {
      // Half a tyre's width in from the flank; the mirrors reach 0.18 m beyond it.
      const Vector3d p(x, 0.5 * box.sizes().y() - 0.18 - 0.12, 0.001);
      if (car.sdf->value(p) > 0.0) continue;
      (x < 0 ? rear : front) = x;
    }
    ASSERT_TRUE(rear && front) << car.family;
    const double share = (*front - *rear) / box.sizes().x();
    EXPECT_GT(share, 0.54) << car.family;
    EXPECT_LT(share, 0.68) << car.family;
    EXPECT_GT(car.sdf->value({0, 0, 0.1}), 0.05) << car.family << " lies on its belly";
  }
}

TEST(Benches, OfferASeatAtSittingHeight) {
  for (const ShapeInstance& bench : instancesOf("bench", 6)) {
    // Between the table of a picnic bench and the seats' outer edges; else over the middle. The
    // best of several places: some lie over gaps between boards.
    const double from = bench.family == "bench_picnic" ? 0.58 : -0.08;
    double seat = 0;
    for (int i = 0; i <= 16; ++i) {
      seat = std::max(seat, heightBelow(*bench.sdf, {from + 0.01 * i, 0.2, 0.6}).value_or(0));
    }
    EXPECT_GE(seat, 0.40) << bench.family;
    EXPECT_LE(seat, 0.49) << bench.family;
  }
}

TEST(Hydrants, OfBarrelsLookToTheirLargestOutlet) {
  for (const ShapeInstance& hydrant : instancesOf("fire_hydrant", 6)) {
    if (hydrant.family == "hydrant_pillar") continue;  // two alike, to either side of the front
    const Aabb box = tightBounds(*hydrant.sdf);
    EXPECT_GT(box.max().x(), -1.05 * box.min().x()) << hydrant.family;
  }
}

TEST(OutdoorObjects, HaveMeshesThatEncloseWhatTheirDistanceFieldsDo) {
  std::vector<ShapeInstance> instances;
  for (const char* class_name : {"fire_hydrant", "car", "bench"}) {
    for (ShapeInstance& instance : instancesOf(class_name, 0)) {
      instances.push_back(std::move(instance));
    }
  }
  parallelFor(instances.size(), [&](std::size_t i) {
    const ShapeInstance& instance = instances[i];
    const Mesh mesh = meshInstance(instance).mesh;
    const Aabb box = bounds(mesh);
    constexpr int kSteps = 64;
    const Vector3d step = box.sizes() / kSteps;
    std::size_t inside = 0;
    Random random(i);
    for (int cell = 0; cell < kSteps * kSteps * kSteps; ++cell) {  // one point at random in each
      const Vector3d at(cell % kSteps + random.uniform(), cell / kSteps % kSteps + random.uniform(),
                        cell / (kSteps * kSteps) + random.uniform());
      if (instance.sdf->value(box.min() + at.cwiseProduct(step)) < 0) ++inside;
    }
    const double expected = static_cast<double>(inside) * step.prod();
    // Boards are 3 cm thick and meshes simplified by up to 0.2 mm.
    EXPECT_NEAR(signedVolume(mesh), expected, 3e-4 * surfaceArea(mesh) + 0.005 * expected)
        << instance.family;
  });
}

}  // namespace
}  // namespace hydrabench
