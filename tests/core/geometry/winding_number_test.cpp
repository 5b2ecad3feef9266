// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/winding_number.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

Eigen::Vector3d drawPoint(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

TEST(WindingNumber, IsOneInsideAndZeroOutsideAClosedMesh) {
  const WindingNumber winding(sphereMesh({0, 0, 0}, 1, 4));
  for (std::size_t i = 0; i < 2000; ++i) {
    Random random(1, i);
    const Eigen::Vector3d query = drawPoint(random, 1.5);
    if (std::abs(query.norm() - 1) < 0.02) continue;
    EXPECT_NEAR(winding.at(query), query.norm() < 1 ? 1 : 0, 1e-2);
    EXPECT_NEAR(winding.exactAt(query), query.norm() < 1 ? 1 : 0, 1e-12);
  }
}

TEST(WindingNumber, OfOverlappingSolidsCountsBoth) {
  Mesh mesh = sphereMesh({0, 0, 0}, 1, 3);
  append(sphereMesh({1, 0, 0}, 1, 3), mesh);
  const WindingNumber winding(mesh);
  EXPECT_NEAR(winding.exactAt({0.5, 0, 0}), 2, 1e-12);
  EXPECT_NEAR(winding.at({0.5, 0, 0}), 2, 1e-2);
  EXPECT_NEAR(winding.at({-0.5, 0, 0}), 1, 1e-2);
}

TEST(WindingNumber, OfACubeWithoutItsLidIsFiveSixthsAtTheCentre) {
  Mesh cube = boxMesh(Aabb(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)));
  std::erase_if(cube.faces, [&](const Eigen::Vector3i& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](int v) { return cube.vertices[static_cast<std::size_t>(v)].z() > 0; });
  });
  ASSERT_EQ(cube.faces.size(), 10u);
  EXPECT_NEAR(WindingNumber(cube).exactAt({0, 0, 0}), 5.0 / 6.0, 1e-14);
  EXPECT_NEAR(WindingNumber(cube).at({0, 0, 0}), 5.0 / 6.0, 1e-2);
}

TEST(WindingNumber, OfAnInsideOutMeshIsNegative) {
  Mesh mesh = sphereMesh({0, 0, 0}, 1, 2);
  for (Eigen::Vector3i& face : mesh.faces) std::swap(face[0], face[1]);
  EXPECT_NEAR(WindingNumber(mesh).exactAt({0, 0, 0}), -1, 1e-12);
}

TEST(WindingNumber, OfNothingIsZero) {
  EXPECT_EQ(WindingNumber(Mesh()).at({0, 0, 0}), 0);
  EXPECT_EQ(WindingNumber(Mesh()).exactAt({0, 0, 0}), 0);
}

TEST(WindingNumber, ApproximationStaysCloseToTheSum) {
  Mesh open = sphereMesh({0, 0, 0}, 1, 5);
  append(sphereMesh({0.6, 0.3, 0}, 0.7, 4), open);
  open.faces.resize(open.faces.size() * 2 / 3);
  const WindingNumber winding(open);
  double worst = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    Random random(2, i);
    const Eigen::Vector3d query = drawPoint(random, 1.5);
    const double error = std::abs(winding.at(query) - winding.exactAt(query));
    worst = std::max(worst, error);
    sum += error;
  }
  EXPECT_LT(worst, 2e-2);
  EXPECT_LT(sum / 1000, 2e-3);
}

TEST(WindingNumber, FarFieldErrorFallsWithTheFifthPowerOfTheDistance) {
  // An open patch as one far node. What the expansion to second order leaves out falls with the
  // fifth power of the distance, a wrong second-order term with the fourth: 1/32 and 1/16 at twice
  // the distance.
  Mesh patch = sphereMesh({0, 0, 0}, 1, 3);
  patch.faces.resize(100);
  const WindingNumber winding(patch);
  const auto errorAt = [&](double distance) {
    double worst = 0;
    for (std::size_t i = 0; i < 50; ++i) {
      Random random(3, i);
      const Eigen::Vector3d query = distance * drawPoint(random, 1).normalized();
      worst = std::max(worst, std::abs(winding.at(query) - winding.exactAt(query)));
    }
    return worst;
  };
  EXPECT_LT(errorAt(20), errorAt(10) / 24);
  EXPECT_LT(errorAt(40), errorAt(20) / 24);
}

}  // namespace
}  // namespace hydrabench
