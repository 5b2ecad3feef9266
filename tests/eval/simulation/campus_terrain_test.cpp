// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_terrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/raycaster.h"
#include "eval/simulation/campus_ground.h"
#include "eval/simulation/campus_labels.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using enum TerrainFeature;

std::vector<CampusTerrain> terrains() {
  std::vector<CampusTerrain> result;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) result.emplace_back(Random(seed));
  return result;
}

Vector2d anywhere(const CampusTerrain& terrain, Random& random) {
  const double reach = terrain.loop().radius_m + CampusTerrain::kEdge_m;
  return {random.uniform(-1, 1) * (terrain.loop().half_x_m + reach),
          random.uniform(-1, 1) * (terrain.loop().half_y_m + reach)};
}

/// Height of the second place above the first [m].
double rise(const CampusTerrain& terrain, const Vector2d& from, const Vector2d& to) {
  return terrain.heightAt(to) - terrain.heightAt(from);
}

TEST(CampusLoop, IsAsLongAsItsStraightsAndCircle) {
  const CampusLoop loop{10, 5, 3};
  EXPECT_NEAR(loop.lengthAt(0), 60 + 6 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(loop.lengthAt(-1), 60 + 4 * std::numbers::pi, 1e-12);
  double length = 0;
  const double step = loop.lengthAt(2) / 20000;
  for (int i = 0; i < 20000; ++i) {
    length += (loop.along((i + 1) * step, 2).point - loop.along(i * step, 2).point).norm();
  }
  EXPECT_NEAR(length, loop.lengthAt(2), 1e-3);
}

TEST(CampusLoop, StationsLieAtTheirOffsetAndLookAhead) {
  const CampusLoop loop{10, 5, 3};
  for (const double offset : {-2.0, 0.0, 4.0}) {
    for (int i = 0; i < 300; ++i) {
      const double at = loop.lengthAt(offset) * i / 300;
      const CampusLoop::Station station = loop.along(at, offset);
      EXPECT_NEAR(loop.offsetOf(station.point), offset, 1e-9);
      const Vector2d moved = loop.along(at + 1e-4, offset).point - station.point;
      EXPECT_NEAR((moved / 1e-4 - station.ahead).norm(), 0, 1e-4);
      EXPECT_NEAR(loop.offsetOf(station.point + 0.1 * station.out), offset + 0.1, 1e-9);
    }
  }
  EXPECT_NEAR((loop.along(0, 0).point - Vector2d(-10, -8)).norm(), 0, 1e-12);
  EXPECT_NEAR((loop.along(-1, 0).point - loop.along(loop.lengthAt(0) - 1, 0).point).norm(), 0,
              1e-9);
}

TEST(CampusTerrain, RoadIsAtLeast250MetresLong) {
  for (const CampusTerrain& terrain : terrains()) EXPECT_GE(terrain.loop().lengthAt(0), 250);
}

TEST(CampusTerrain, SlopesReachNearlyTenPercentAndNeverMore) {
  for (const CampusTerrain& terrain : terrains()) {
    double steepest = 0;
    for (double x = -80; x < 80; x += 0.25) {
      for (double y = -56; y < 56; y += 0.5) {
        steepest = std::max(steepest, terrain.baseSlopeAt({x, y}).norm());
      }
    }
    EXPECT_LE(steepest, CampusTerrain::kMaxSlope);
    EXPECT_GE(steepest, 0.08);
  }
}

TEST(CampusTerrain, SlopeIsTheGradientOfTheHeight) {
  Random random(5);
  for (const CampusTerrain& terrain : terrains()) {
    for (int i = 0; i < 100; ++i) {
      const Vector2d p = anywhere(terrain, random);
      constexpr double kStep = 1e-5;
      const Vector2d dx(kStep, 0);
      const Vector2d dy(0, kStep);
      const Vector2d slope = terrain.baseSlopeAt(p);
      EXPECT_NEAR((terrain.baseHeightAt(p + dx) - terrain.baseHeightAt(p - dx)) / (2 * kStep),
                  slope.x(), 1e-6);
      EXPECT_NEAR((terrain.baseHeightAt(p + dy) - terrain.baseHeightAt(p - dy)) / (2 * kStep),
                  slope.y(), 1e-6);
    }
  }
}

TEST(CampusTerrain, KerbsStandTwelveToFifteenCentimetresHighAllAlong) {
  for (const CampusTerrain& terrain : terrains()) {
    EXPECT_GE(terrain.kerbHeight(), 0.12);
    EXPECT_LE(terrain.kerbHeight(), 0.15);
    for (int i = 0; i < 200; ++i) {
      for (const double side : {-1.0, 1.0}) {
        const double foot = side * CampusTerrain::kRoadHalfWidth_m;
        const CampusLoop::Station station =
            terrain.loop().along(terrain.loop().lengthAt(foot) * i / 200, foot);
        const Vector2d across = side * station.out;
        const double height = rise(terrain, station.point - 1e-6 * across,
                                   station.point + (CampusTerrain::kKerbRamp_m + 1e-6) * across);
        // The ground goes on below it.
        EXPECT_NEAR(height, terrain.kerbHeight(),
                    CampusTerrain::kMaxSlope * CampusTerrain::kKerbRamp_m + 1e-5);
      }
    }
  }
}

TEST(CampusTerrain, StepsAreEqualAndLeadOntoTheTerrace) {
  for (const CampusTerrain& terrain : terrains()) {
    const CampusTerrain::Stairs& stairs = terrain.stairs();
    EXPECT_GE(stairs.steps, 6);
    EXPECT_GE(stairs.rise_m, 0.14);
    EXPECT_LE(stairs.rise_m, 0.18);
    const double x = 0.5 * (stairs.x_low + stairs.x_high);
    const double foot = terrain.terrace().min().y();
    const auto tread = [&](int step) { return Vector2d(x, foot + (step - 0.5) * stairs.tread_m); };
    for (int step = 0; step < stairs.steps; ++step) {
      EXPECT_NEAR(rise(terrain, tread(step), tread(step + 1)), stairs.rise_m, 1e-12);
    }
    const Vector2d top(x, foot + stairs.run() + 1);
    EXPECT_NEAR(rise(terrain, tread(stairs.steps), top), 0, 1e-12);
    EXPECT_NEAR(rise(terrain, tread(0), top), terrain.terraceHeight(), 1e-12);
  }
}

TEST(CampusTerrain, TerraceDropsBetween80And150CentimetresOnAllSides) {
  for (const CampusTerrain& terrain : terrains()) {
    EXPECT_GE(terrain.terraceHeight(), 0.8);
    EXPECT_LE(terrain.terraceHeight(), 1.5);
    const Rect& terrace = terrain.terrace();
    const Vector2d center = terrace.center();
    constexpr double kBeyond = 1e-6;
    const double in = CampusTerrain::kWallRamp_m + kBeyond;
    const std::vector<std::pair<Vector2d, Vector2d>> edges = {
        {{terrace.min().x() - kBeyond, center.y()}, {terrace.min().x() + in, center.y()}},
        {{terrace.max().x() + kBeyond, center.y()}, {terrace.max().x() - in, center.y()}},
        {{terrace.min().x() + 2, terrace.min().y() - kBeyond},
         {terrace.min().x() + 2, terrace.min().y() + in}},
        {{center.x(), terrace.max().y() + kBeyond}, {center.x(), terrace.max().y() - in}}};
    for (const auto& [below, above] : edges) {
      EXPECT_NEAR(rise(terrain, below, above), terrain.terraceHeight(), 1e-12);
    }
  }
}

TEST(CampusTerrain, HasNoGaps) {
  // Along lines across terrace and road no step of half a millimetre rises more than the steepest
  // face does: that of a corner of the terrace, where two walls meet.
  constexpr double kStep = 5e-4;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const CampusTerrain terrain{Random(seed)};
    Random random(seed);
    const double steepest = 2 * terrain.terraceHeight() / CampusTerrain::kWallRamp_m;
    const Rect& terrace = terrain.terrace();
    for (int line = 0; line < 12; ++line) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      const Vector2d step = kStep * Vector2d(std::cos(angle), std::sin(angle));
      Vector2d p = terrace.min() +
                   Vector2d(random.uniform(), random.uniform()).cwiseProduct(terrace.sizes()) -
                   24000 * step;
      for (int i = 0; i < 48000; ++i, p += step) {
        ASSERT_LE(std::abs(rise(terrain, p, p + step)), (steepest + 1) * kStep) << p.transpose();
      }
    }
  }
}

TEST(CampusTerrain, TellsWhichFeatureAPlaceBelongsTo) {
  for (const CampusTerrain& terrain : terrains()) {
    const CampusTerrain::Stairs& stairs = terrain.stairs();
    const Rect& terrace = terrain.terrace();
    const double foot = terrace.min().y();
    EXPECT_EQ(terrain.featureAt({0.5 * (stairs.x_low + stairs.x_high), foot + 1}), kStairs);
    EXPECT_EQ(terrain.featureAt({terrace.min().x() - 0.3, terrace.center().y()}), kTerrace);
    EXPECT_EQ(terrain.featureAt(terrace.center()), kFlat);
    const CampusLoop::Station kerb = terrain.loop().along(3, CampusTerrain::kRoadHalfWidth_m);
    EXPECT_EQ(terrain.featureAt(kerb.point), kKerb);
    // The middle of the eastern hill, on the road.
    Vector2d steepest(0, -28);
    for (double x = -40; x < 40; x += 0.1) {
      if (terrain.baseSlopeAt({x, -28}).norm() > terrain.baseSlopeAt(steepest).norm()) {
        steepest.x() = x;
      }
    }
    EXPECT_EQ(terrain.featureAt(steepest), kSlope);
    EXPECT_EQ(terrain.featureAt({terrace.center().x(), -28}), kFlat);
  }
}

TEST(CampusTerrain, LabelsTheGround) {
  namespace id = campus_label;
  for (const CampusTerrain& terrain : terrains()) {
    const CampusTerrain::Stairs& stairs = terrain.stairs();
    const double x = 0.5 * (stairs.x_low + stairs.x_high);
    const Rect& terrace = terrain.terrace();
    const double foot = terrace.min().y();
    EXPECT_EQ(terrain.labelAt({x, -28}), id::kRoad);
    EXPECT_EQ(terrain.labelAt({x, -28 + 3.61}), id::kSidewalk);  // the kerb's face
    EXPECT_EQ(terrain.labelAt({x, -28 - 5}), id::kSidewalk);
    EXPECT_EQ(terrain.labelAt({x, foot - 0.1}), id::kSidewalk);  // before the steps
    EXPECT_EQ(terrain.labelAt({x, foot + 0.5}), id::kStairs);
    EXPECT_EQ(terrain.labelAt({stairs.x_low - 0.02, foot + 0.5}), id::kWall);
    EXPECT_EQ(terrain.labelAt({terrace.min().x() + 0.02, terrace.center().y()}), id::kWall);
    EXPECT_EQ(terrain.labelAt(terrace.center()), id::kSidewalk);
    EXPECT_EQ(terrain.labelAt({terrace.min().x() - 1, terrace.center().y()}), id::kGrass);
    EXPECT_EQ(terrain.labelAt({x, -28 - 7}), id::kGrass);
  }
}

/// The meshed ground of a terrain, to shoot at.
struct Ground {
  explicit Ground(const CampusTerrain& terrain) {
    scene.label_space = campusLabelSpace();
    buildCampusGround(terrain, scene);
    for (const StructurePart& part : scene.structure) raycaster.add(part.surface.mesh);
    raycaster.commit();
  }
  Raycaster::Hit below(const Vector2d& place) const {
    return raycaster.intersect(
        {{static_cast<float>(place.x()), static_cast<float>(place.y()), 20}, {0, 0, -1}});
  }
  Scene scene;
  Raycaster raycaster;
};

TEST(CampusGround, KeepsToTheHeightsAndLabelsOfTheTerrain) {
  const CampusTerrain terrain(Random(3));
  const Ground ground(terrain);
  Random random(4);
  int checked = 0;
  for (int i = 0; i < 40000; ++i) {
    const Vector2d p = anywhere(terrain, random);
    if (terrain.loop().offsetOf(p) > CampusTerrain::kEdge_m - 0.1) continue;
    // Not on steep faces, where 2 mm sideways are centimetres.
    const auto steep = [&](const Vector2d& d) {
      return std::abs(rise(terrain, p - d, p + d)) > 0.0021;
    };
    if (steep({0.01, 0}) || steep({0, 0.01})) continue;
    const Raycaster::Hit hit = ground.below(p);
    ASSERT_TRUE(hit) << p.transpose();
    EXPECT_NEAR(20 - hit.distance, terrain.heightAt(p), 0.004) << p.transpose();
    const Label label = terrain.labelAt(p);
    const auto same = [&](double x, double y) {
      return terrain.labelAt(p + Vector2d(x, y)) == label;
    };
    constexpr double kChord = 0.005;  // in bends the mesh leaves the circle
    if (same(kChord, 0) && same(-kChord, 0) && same(0, kChord) && same(0, -kChord)) {
      EXPECT_EQ(ground.scene.structure[hit.mesh].label, label) << p.transpose();
    }
    ++checked;
  }
  EXPECT_GT(checked, 20000);
}

TEST(CampusGround, HasCreasesAtKerbsStepsAndWalls) {
  // On either side of the steep face, as near as 3 mm, the mesh is as high as the terrain.
  const CampusTerrain terrain(Random(3));
  const Ground ground(terrain);
  const auto expectEdge = [&](const Vector2d& foot, const Vector2d& up, double run) {
    for (const Vector2d& p : {Vector2d(foot - 0.003 * up), Vector2d(foot + (run + 0.003) * up)}) {
      const Raycaster::Hit hit = ground.below(p);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(20 - hit.distance, terrain.heightAt(p), 0.003) << p.transpose();
    }
  };
  const Rect& terrace = terrain.terrace();
  for (double y = terrace.min().y() + 0.5; y < terrace.max().y(); y += 0.37) {
    expectEdge({terrace.min().x(), y}, {1, 0}, CampusTerrain::kWallRamp_m);
  }
  const CampusTerrain::Stairs& stairs = terrain.stairs();
  for (int i = 0; i < stairs.steps; ++i) {
    expectEdge({stairs.x_low + 0.7, terrace.min().y() + i * stairs.tread_m}, {0, 1},
               CampusTerrain::kRiserRamp_m);
  }
  for (int i = 0; i < 500; ++i) {
    const double foot = CampusTerrain::kRoadHalfWidth_m;
    const CampusLoop::Station station =
        terrain.loop().along(terrain.loop().lengthAt(foot) * i / 500, foot);
    expectEdge(station.point, station.out, CampusTerrain::kKerbRamp_m);
  }
}

TEST(CampusGround, IsOneSurfaceWithoutFacesThatLookDown) {
  const CampusTerrain terrain(Random(6));
  const Ground ground(terrain);
  std::set<Label> labels;
  double area = 0;
  for (const StructurePart& part : ground.scene.structure) {
    labels.insert(part.label);
    const Mesh& mesh = part.surface.mesh;
    for (const Eigen::Vector3i& face : mesh.faces) {
      const auto corner = [&](int k) -> const Eigen::Vector3d& {
        return mesh.vertices[static_cast<std::size_t>(face[k])];
      };
      const double up = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).z();
      EXPECT_GT(up, 0);
      area += up;
    }
  }
  EXPECT_EQ(labels.size(), 5u);  // road, sidewalk, grass, stairs, wall
  // Seen from above the faces fill the plan: rectangle, four sides, a circle in the corners.
  const CampusLoop& loop = terrain.loop();
  const double reach = loop.radius_m + CampusTerrain::kEdge_m;
  const double plan = 4 * loop.half_x_m * loop.half_y_m +
                      4 * reach * (loop.half_x_m + loop.half_y_m) +
                      std::numbers::pi * reach * reach;
  EXPECT_NEAR(area, plan, 0.001 * plan);
}

}  // namespace
}  // namespace hydrabench
