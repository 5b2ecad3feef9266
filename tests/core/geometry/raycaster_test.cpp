// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/raycaster.h"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

Mesh unitCube() { return boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1))); }

Raycaster raycasterOf(const std::vector<Mesh>& meshes) {
  Raycaster raycaster;
  for (const Mesh& mesh : meshes) raycaster.add(mesh);
  raycaster.commit();
  return raycaster;
}

Raycaster::Ray rayFrom(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  Raycaster::Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return ray;
}

Eigen::Vector3d drawPoint(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

std::vector<Raycaster::Ray> drawRays(std::size_t count) {
  std::vector<Raycaster::Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(3, i);
    const Eigen::Vector3d origin = drawPoint(random, 2);
    rays.push_back(rayFrom(origin.cast<float>(), (drawPoint(random, 0.5) - origin).cast<float>()));
  }
  return rays;
}

TEST(Raycaster, ReportsDistanceInMultiplesOfTheDirection) {
  const Raycaster raycaster = raycasterOf({unitCube()});
  const Raycaster::Hit hit = raycaster.intersect(rayFrom({-1, 0.4f, 0.3f}, {2, 0, 0}));
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit.mesh, 0u);
  EXPECT_FLOAT_EQ(hit.distance, 0.5f);
}

TEST(Raycaster, MissesWhereNothingIs) {
  const Raycaster raycaster = raycasterOf({unitCube()});
  EXPECT_FALSE(raycaster.intersect(rayFrom({-1, 2, 0.5f}, {1, 0, 0})));
  EXPECT_FALSE(raycaster.intersect(rayFrom({-1, 0.5f, 0.5f}, {-1, 0, 0})));
  EXPECT_FALSE(raycasterOf({}).intersect(rayFrom({0, 0, 0}, {1, 0, 0})));
}

TEST(Raycaster, RespectsTheEndsOfARay) {
  const Raycaster raycaster = raycasterOf({unitCube()});
  Raycaster::Ray ray = rayFrom({-1, 0.4f, 0.3f}, {1, 0, 0});
  ray.max_distance = 0.9f;
  EXPECT_FALSE(raycaster.intersect(ray));
  ray.max_distance = 5;
  ray.min_distance = 1.5f;
  EXPECT_FLOAT_EQ(raycaster.intersect(ray).distance, 2);  // the far side, from inside
}

TEST(Raycaster, NamesMeshFaceAndBarycentricWeights) {
  Mesh triangle;
  triangle.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  triangle.faces = {{0, 1, 2}};
  Mesh behind = triangle;
  for (Eigen::Vector3d& v : behind.vertices) v.z() = -1;
  behind.faces = {{0, 0, 0}, {0, 1, 2}};  // a face without area first
  const Raycaster raycaster = raycasterOf({behind, Mesh(), triangle});
  const Raycaster::Hit hit = raycaster.intersect(rayFrom({1, 2, 1}, {0, 0, -1}));
  EXPECT_EQ(hit.mesh, 2u);
  EXPECT_EQ(hit.face, 0u);
  EXPECT_FLOAT_EQ(hit.u, 0.25f);
  EXPECT_FLOAT_EQ(hit.v, 0.5f);
  const Raycaster::Hit from_below = raycaster.intersect(rayFrom({1, 2, -3}, {0, 0, 1}));
  EXPECT_EQ(from_below.mesh, 0u);
  EXPECT_EQ(from_below.face, 1u);
}

TEST(Raycaster, GivesManyRaysTheHitsOfSingleOnes) {
  const Raycaster raycaster = raycasterOf({sphereMesh({0, 0, 0}, 1, 3), unitCube()});
  const std::vector<Raycaster::Ray> rays = drawRays(1003);  // no multiple of a packet
  std::vector<Raycaster::Hit> hits(rays.size());
  std::vector<std::uint8_t> blocked(rays.size(), 7);
  raycaster.intersect(rays, hits);
  raycaster.occluded(rays, blocked);
  int num_hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Raycaster::Hit single = raycaster.intersect(rays[i]);
    EXPECT_EQ(static_cast<bool>(hits[i]), static_cast<bool>(single)) << i;
    EXPECT_EQ(blocked[i], single ? 1 : 0) << i;
    if (!single) continue;
    ++num_hits;
    EXPECT_NEAR(hits[i].distance, single.distance, 1e-5f);
    EXPECT_EQ(hits[i].mesh, single.mesh);
  }
  EXPECT_GT(num_hits, 500);
  raycaster.intersect(std::span<const Raycaster::Ray>(), std::span<Raycaster::Hit>());
}

TEST(Raycaster, SaysWhetherAnythingStandsBetween) {
  const Raycaster raycaster = raycasterOf({unitCube()});
  std::vector<Raycaster::Ray> rays(2, rayFrom({-1, 0.4f, 0.3f}, {1, 0, 0}));
  rays[0].max_distance = 0.99f;
  rays[1].max_distance = 1.01f;
  std::vector<std::uint8_t> blocked(2);
  raycaster.occluded(rays, blocked);
  EXPECT_THAT(blocked, ::testing::ElementsAre(0, 1));
}

TEST(Raycaster, DoesNotLeakThroughSharedEdges) {
  // From the centre of a closed surface every ray hits, also those through edges and vertices.
  const Mesh sphere = sphereMesh({0, 0, 0}, 1, 3);
  const Raycaster raycaster = raycasterOf({sphere});
  std::vector<Raycaster::Ray> rays;
  for (const Eigen::Vector3i& face : sphere.faces) {
    const Eigen::Vector3d& a = sphere.vertices[static_cast<std::size_t>(face[0])];
    const Eigen::Vector3d& b = sphere.vertices[static_cast<std::size_t>(face[1])];
    rays.push_back(rayFrom({0, 0, 0}, a.cast<float>()));
    rays.push_back(rayFrom({0, 0, 0}, (a + b).cast<float>()));
  }
  std::vector<Raycaster::Hit> hits(rays.size());
  raycaster.intersect(rays, hits);
  for (const Raycaster::Hit& hit : hits) EXPECT_TRUE(hit);
}

TEST(Raycaster, GivesTheSameBytesForAnyNumberOfThreads) {
  const std::vector<Raycaster::Ray> rays = drawRays(2000);
  const auto hitsWith = [&](int num_threads) {
    setNumThreads(num_threads);
    const Raycaster raycaster =
        raycasterOf({sphereMesh({0, 0, 0}, 1, 5), sphereMesh({0.01, 0, 0}, 1, 5)});
    std::vector<Raycaster::Hit> hits(rays.size());
    parallelForRanges(rays.size(), 64, [&](std::size_t begin, std::size_t end) {
      raycaster.intersect(std::span(rays).subspan(begin, end - begin),
                          std::span(hits).subspan(begin, end - begin));
    });
    setNumThreads(0);
    return hits;
  };
  const auto serial = hitsWith(1);
  for (const int num_threads : {2, 7}) {
    const auto hits = hitsWith(num_threads);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(
          std::tuple(hits[i].mesh, hits[i].face, hits[i].distance, hits[i].u, hits[i].v),
          std::tuple(serial[i].mesh, serial[i].face, serial[i].distance, serial[i].u, serial[i].v));
    }
  }
}

/// Distance to every triangle, the plain way.
double plainDistance(const Mesh& mesh, const Eigen::Vector3d& query) {
  double best = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3i& face : mesh.faces) {
    const Eigen::Vector3d nearest =
        nearestPointOnTriangle(query, mesh.vertices[static_cast<std::size_t>(face[0])],
                               mesh.vertices[static_cast<std::size_t>(face[1])],
                               mesh.vertices[static_cast<std::size_t>(face[2])]);
    best = std::min(best, (nearest - query).norm());
  }
  return best;
}

TEST(NearestOnSurface, AgreesWithTryingEveryTriangle) {
  // Far from the origin and with coordinates that are no floats, where single precision would show.
  Mesh mesh = sphereMesh({100.1, -57.3, 3.7}, 0.731, 3);
  append(sphereMesh({101.3, -57.3, 3.7}, 0.2, 2), mesh);
  const Raycaster raycaster = raycasterOf({mesh});
  for (std::size_t i = 0; i < 1000; ++i) {
    Random random(5, i);
    const Eigen::Vector3d query =
        Eigen::Vector3d(100.5, -57, 3.5) + drawPoint(random, i % 2 ? 1.0 : 30.0);
    const Raycaster::SurfacePoint nearest = raycaster.nearest(query);
    const double expected = plainDistance(mesh, query);
    EXPECT_NEAR(nearest.distance, expected, 1e-12);
    EXPECT_NEAR((nearest.position - query).norm(), expected, 1e-12);
  }
}

TEST(NearestOnSurface, IsAtDistanceZeroOnTheSurface) {
  Transform far = Transform::Identity();
  far.translation() = Eigen::Vector3d{40, -30, 2};
  far.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Mesh mesh = transformed(far, sphereMesh({0, 0, 0}, 0.5, 4));
  Mesh sliver;
  sliver.vertices = {{0, 0, 0}, {10.1, 1e-5, 0.3}, {5.2, 3e-5, 0.1}};
  sliver.faces = {{0, 1, 2}};
  append(transformed(far, sliver), mesh);
  const Raycaster raycaster = raycasterOf({mesh});
  for (const Eigen::Vector3d& point : sampleSurface(mesh, 5000, 1).points) {
    EXPECT_LT(raycaster.nearest(point).distance, 1e-12);
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    EXPECT_EQ(raycaster.nearest(vertex).distance, 0);
}

TEST(NearestOnSurface, IsExactEvenWhereFloatsAreCoarserThanTheMesh) {
  // A kilometre out a float counts in 0.06 mm; the triangles measure 0.2 mm.
  const Mesh mesh = sphereMesh({1000, -500, 20}, 0.005, 4);
  const Raycaster raycaster = raycasterOf({mesh});
  for (const Eigen::Vector3d& point : sampleSurface(mesh, 2000, 2).points) {
    EXPECT_LT(raycaster.nearest(point).distance, 1e-12);
  }
  for (std::size_t i = 0; i < 500; ++i) {
    Random random(6, i);
    const Eigen::Vector3d query = Eigen::Vector3d(1000, -500, 20) + drawPoint(random, 0.006);
    EXPECT_NEAR(raycaster.nearest(query).distance, plainDistance(mesh, query), 1e-12);
  }
}

TEST(NearestOnSurface, KeepsToTheMaximumDistanceInclusive) {
  const Raycaster raycaster = raycasterOf({unitCube()});
  EXPECT_EQ(raycaster.nearest({0.5, 0.5, 1.5}, 0.5).distance, 0.5);
  EXPECT_EQ(raycaster.nearest({0.5, 0.5, 1.5}, 0.499999).face, Raycaster::kMiss);
  EXPECT_EQ(raycasterOf({}).nearest({0, 0, 0}).face, Raycaster::kMiss);
}

TEST(NearestOnSurface, TakesTheFirstOfEquallyNearFaces) {
  const Mesh sphere = sphereMesh({0, 0, 0}, 1, 2);
  Mesh backwards = sphere;
  std::reverse(backwards.faces.begin(), backwards.faces.end());
  const Raycaster raycaster = raycasterOf({sphereMesh({9, 9, 9}, 1, 2), sphere, backwards, sphere});
  for (std::size_t face = 0; face < sphere.faces.size(); ++face) {
    const Eigen::Vector3i& corners = sphere.faces[face];
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int corner : corners) {
      const Eigen::Vector3d& vertex = sphere.vertices[static_cast<std::size_t>(corner)];
      middle += vertex / 3;
      const auto first = std::find_if(
          sphere.faces.begin(), sphere.faces.end(),
          [&](const Eigen::Vector3i& other) { return (other.array() == corner).any(); });
      EXPECT_EQ(raycaster.nearest(vertex).mesh, 1u);
      EXPECT_EQ(raycaster.nearest(vertex).face, first - sphere.faces.begin());
    }
    EXPECT_EQ(raycaster.nearest(2 * middle).mesh, 1u);
    EXPECT_EQ(raycaster.nearest(2 * middle).face, face);
  }
}

TEST(NearestPointOnTriangle, IsRightInEveryRegion) {
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(2, 0, 0);
  const Eigen::Vector3d c(0, 2, 0);
  const auto nearest = [&](double x, double y) {
    return nearestPointOnTriangle({x, y, 3}, a, b, c);
  };
  EXPECT_EQ(nearest(-1, -1), a);
  EXPECT_EQ(nearest(3, -1), b);
  EXPECT_EQ(nearest(-1, 3), c);
  EXPECT_EQ(nearest(1, -1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(nearest(-1, 1), Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(nearest(2, 2), Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(nearest(0.5, 0.25), Eigen::Vector3d(0.5, 0.25, 0));
}

TEST(NearestPointOnTriangle, OfATriangleWithoutAreaLiesOnItsSegmentOrPoint) {
  const Eigen::Vector3d p(1, 1, 1);
  EXPECT_EQ(nearestPointOnTriangle({0, 0, 0}, p, p, p), p);
  EXPECT_TRUE(nearestPointOnTriangle({1, 1, 0}, {0, 0, 0}, {2, 0, 0}, {1, 0, 0})
                  .isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(nearestPointOnTriangle({3, 1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0})
                  .isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_TRUE(nearestPointOnTriangle({-1, 1, 0}, {0, 0, 0}, {0, 0, 0}, {2, 0, 0}).isZero());
}

}  // namespace
}  // namespace hydrabench
