// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/marching_cubes.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/cube_contours.h"
#include "core/geometry/cube_triangles.h"
#include "core/geometry/mesh_topology.h"
#include "core/types/random.h"
#include "tests/core/mapping/filled_volume.h"

namespace hydrabench {
namespace {

TsdfVolume::Config smallBlocks() {
  TsdfVolume::Config config;
  config.voxels_per_side = 4;
  return config;
}

void append(const TriangleSoup& soup, Mesh& mesh) {
  for (std::size_t i = 0; i < soup.vertices.size(); i += 3) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.faces.emplace_back(first, first + 1, first + 2);
    mesh.vertices.insert(mesh.vertices.end(), &soup.vertices[i], &soup.vertices[i] + 3);
  }
}

Mesh meshOf(const TsdfVolume& volume, double min_weight = 1e-4) {
  Mesh mesh;
  for (const BlockIndex& block : volume.blockIndices()) {
    append(marchingCubes(volume, block, min_weight), mesh);
  }
  return mesh;
}

TEST(CubeTriangles, NumberAsManyAsInThePublishedTable) {
  std::size_t total = 0;
  for (int mask = 0; mask < 256; ++mask) {
    EXPECT_LE(cubeTriangles(mask).size(), 5u);
    total += cubeTriangles(mask).size();
  }
  EXPECT_EQ(total, 820u);
}

bool onOneFace(int edge_a, int edge_b) {
  for (int axis = 0; axis < 3; ++axis) {
    int high = 0;
    for (int corner :
         {cubeEdgeStart(edge_a), cubeEdgeEnd(edge_a), cubeEdgeStart(edge_b), cubeEdgeEnd(edge_b)}) {
      high += corner >> axis & 1;
    }
    if (high == 0 || high == 4) return true;
  }
  return false;
}

TEST(CubeTriangles, MeetEachOtherInsideTheCubeAndTheNeighborsOnItsFaces) {
  for (int mask = 0; mask < 256; ++mask) {
    int uses[12][12] = {};
    for (const CubeTriangle& triangle : cubeTriangles(mask)) {
      for (std::size_t k = 0; k < 3; ++k) ++uses[triangle[k]][triangle[(k + 1) % 3]];
    }
    for (int a = 0; a < 12; ++a) {
      for (int b = 0; b < 12; ++b) {
        ASSERT_LE(uses[a][b], 1) << mask;
        if (uses[a][b] == 0) continue;
        EXPECT_EQ(uses[b][a], onOneFace(a, b) ? 0 : 1) << mask;
      }
    }
  }
}

TEST(CubeTriangles, AreOneForASingleCornerAndTurnOutward) {
  ASSERT_EQ(cubeTriangles(1).size(), 1u);
  Eigen::Vector3d corners[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const int edge = cubeTriangles(1)[0][k];
    EXPECT_EQ(cubeEdgeStart(edge), 0);
    corners[k] = Eigen::Vector3d::Unit(edge / 4);
  }
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  EXPECT_EQ(normal, Eigen::Vector3d(1, 1, 1));
}

TEST(MarchingCubes, PutsAPlaneWhereTheDistancesSay) {
  // One block: 3 x 3 cubes around z = 0.22 have all corners. Two triangles each.
  const TsdfVolume volume =
      filledVolume(smallBlocks(), {0, 0, 0}, {0, 0, 0}, [](const auto& p) { return p.z() - 0.22; });
  const Mesh mesh = meshOf(volume);
  EXPECT_EQ(mesh.faces.size(), 18u);
  for (const Eigen::Vector3d& p : mesh.vertices) EXPECT_NEAR(p.z(), 0.22, 1e-8);
  for (const Eigen::Vector3i& f : mesh.faces) {
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(f[k])]; };
    EXPECT_GT((corner(1) - corner(0)).cross(corner(2) - corner(0)).z(), 0);
  }
}

TEST(MarchingCubes, ReachesIntoTheNeighborsAtFacesEdgesAndCorner) {
  // Blocks of 4 voxels, 0.4 m: a ball around the corner where eight of them meet.
  const auto ball = [](const auto& p) { return p.norm() - 0.21; };
  const Mesh mesh = meshOf(filledVolume(smallBlocks(), {-1, -1, -1}, {0, 0, 0}, ball));
  const MeshTopology topology = analyzeTopology(mesh);
  EXPECT_TRUE(topology.watertight());
  EXPECT_EQ(topology.components, 1u);
  const double exact = 4.0 / 3 * std::numbers::pi * 0.21 * 0.21 * 0.21;
  EXPECT_GT(signedVolume(mesh), 0.7 * exact);
  EXPECT_LT(signedVolume(mesh), exact);
}

TEST(MarchingCubes, LeavesOutCubesThatReachIntoAMissingBlock) {
  const auto plane = [](const auto& p) { return p.z() - 0.22; };
  TsdfVolume volume = filledVolume(smallBlocks(), {0, 0, 0}, {1, 1, 0}, plane);
  EXPECT_EQ(marchingCubes(volume, {0, 0, 0}, 1e-4).vertices.size(), 3u * 2 * 16);
  volume.remove({1, 1, 0});  // the neighbour across the edge takes one cube with it
  EXPECT_EQ(marchingCubes(volume, {0, 0, 0}, 1e-4).vertices.size(), 3u * 2 * 15);
  volume.remove({1, 0, 0});
  EXPECT_EQ(marchingCubes(volume, {0, 0, 0}, 1e-4).vertices.size(), 3u * 2 * 12);
  EXPECT_TRUE(marchingCubes(volume, {1, 0, 0}, 1e-4).vertices.empty());
}

TEST(MarchingCubes, NeedsEightCornersOfTheLeastWeight) {
  TsdfVolume volume =
      filledVolume(smallBlocks(), {0, 0, 0}, {0, 0, 0}, [](const auto& p) { return p.z() - 0.22; });
  VoxelBlock& block = *volume.find({0, 0, 0});
  for (TsdfVoxel& voxel : block.voxels) voxel.weight = 1e-4f;
  EXPECT_EQ(meshOf(volume, 1e-4).faces.size(), 18u);  // exactly as much is enough
  block.voxels[volume.grid().localIndex(0, 0, 2)].weight = 0.5e-4f;
  EXPECT_EQ(meshOf(volume, 1e-4).faces.size(), 16u);
  block.voxels[volume.grid().localIndex(0, 0, 2)].weight = 0;
  EXPECT_EQ(meshOf(volume, 0).faces.size(), 16u);  // never measured is never enough
}

/// Two layers of voxels, the lower inside.
class TwoLayers : public testing::Test {
 protected:
  TwoLayers() : volume_(filledVolume(config(), {0, 0, 0}, {0, 0, 0}, &TwoLayers::sign)) {}
  static TsdfVolume::Config config() {
    TsdfVolume::Config config;
    config.voxels_per_side = 2;
    config.voxel_size_m = 1;
    return config;
  }
  static double sign(const Eigen::Vector3d& p) { return p.z() < 1 ? -1 : 1; }
  void setLayer(int z, float distance, float weight, Rgb color, Label label) {
    VoxelBlock& block = *volume_.find({0, 0, 0});
    for (int i = 0; i < 4; ++i) {
      const std::size_t local = volume_.grid().localIndex(i & 1, i >> 1, z);
      block.voxels[local] = {distance, weight, color, true};
      block.semantics->fuse(local, label, 1);
    }
  }
  TsdfVolume volume_;
};

TEST_F(TwoLayers, GiveColorsInProportionAndTheLabelOfTheNearer) {
  setLayer(0, -1, 1, {0, 100, 200}, 3);
  setLayer(1, 3, 1, {100, 0, 200}, 5);
  const TriangleSoup soup = marchingCubes(volume_, {0, 0, 0}, 1e-4);
  ASSERT_EQ(soup.vertices.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(soup.vertices[i].z(), 0.75);  // a quarter of the way from 0.5 to 1.5
    EXPECT_EQ(soup.colors[i], (Rgb{25, 75, 200}));
    EXPECT_EQ(soup.labels[i], 3);
  }
}

TEST_F(TwoLayers, GiveTheLabelOfTheHeavierWhereBothAreEquallyNear) {
  setLayer(0, -1, 1, {}, 3);
  setLayer(1, 1, 2, {}, 5);
  const TriangleSoup soup = marchingCubes(volume_, {0, 0, 0}, 1e-4);
  ASSERT_EQ(soup.labels.size(), 6u);
  for (Label label : soup.labels) EXPECT_EQ(label, 5);
}

TEST_F(TwoLayers, MeetHalfWayWhereTheirDistancesHardlyDiffer) {
  setLayer(0, -1e-8f, 1, {}, 3);
  setLayer(1, 9e-7f, 1, {}, 3);
  const TriangleSoup soup = marchingCubes(volume_, {0, 0, 0}, 1e-4);
  ASSERT_EQ(soup.vertices.size(), 6u);
  for (const Eigen::Vector3d& p : soup.vertices) EXPECT_EQ(p.z(), 1.0);
}

TEST_F(TwoLayers, HaveNoLabelWhereNoneWasFused) {
  for (Label label : marchingCubes(volume_, {0, 0, 0}, 1e-4).labels) {
    EXPECT_EQ(label, kUnknownLabel);
  }
}

TEST(MarchingCubes, ClosesAnySurfaceWhateverTheSigns) {
  // Noise inside eight blocks, all of it kept away from the outer border: every ambiguous face and
  // every case of the table occurs.
  Random random(7);
  const auto noise = [&random](const Eigen::Vector3d& p) {
    const double value = random.uniform(-1, 1);
    return p.cwiseAbs().maxCoeff() > 0.3 ? std::abs(value) : value;
  };
  const Mesh mesh = meshOf(filledVolume(smallBlocks(), {-1, -1, -1}, {0, 0, 0}, noise));
  EXPECT_GT(mesh.faces.size(), 200u);
  EXPECT_TRUE(analyzeTopology(mesh).watertight());
}

TEST(MarchingCubes, FindsNothingWhereAllIsFree) {
  const TsdfVolume volume =
      filledVolume(smallBlocks(), {0, 0, 0}, {0, 0, 0}, [](const auto&) { return 0.3; });
  EXPECT_TRUE(marchingCubes(volume, {0, 0, 0}, 1e-4).vertices.empty());
  EXPECT_TRUE(marchingCubes(volume, {5, 0, 0}, 1e-4).vertices.empty());
}

}  // namespace
}  // namespace hydrabench
