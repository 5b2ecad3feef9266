// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/map_mesh.h"

#include <initializer_list>
#include <map>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/mapping/cell_table.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const Eigen::Vector3d kA(0, 0, 0);
const Eigen::Vector3d kB(1, 0, 0);
const Eigen::Vector3d kC(0, 1, 0);
const Eigen::Vector3d kD(1, 1, 0);

TriangleSoup soup(std::initializer_list<Eigen::Vector3d> vertices, Label label = 5) {
  TriangleSoup soup;
  soup.vertices = vertices;
  soup.colors.assign(soup.vertices.size(), Rgb{1, 2, 3});
  soup.labels.assign(soup.vertices.size(), label);
  return soup;
}

TEST(MapMesh, MergesVerticesOfOneCell) {
  MapMesh map(0.01);
  const Eigen::Vector3d near_b(1.004, 0, 0);
  map.update({0, 0, 0}, soup({kA, kB, kC, near_b, kD, kC}));
  EXPECT_THAT(map.activeVertices(), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(map.position(1), kB);  // the first of the cell counts
  const Mesh mesh = map.mesh();
  EXPECT_THAT(mesh.vertices, SizeIs(4));
  EXPECT_THAT(mesh.faces, ElementsAre(Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(1, 3, 2)));
}

TEST(MapMesh, RoundsToTheNearestCellOnBothSidesOfZero) {
  MapMesh map(1);
  map.update({0, 0, 0}, soup({{-0.4, 0, 0}, {0.4, 0, 0}, {-0.6, 0, 0}}));
  EXPECT_THAT(map.activeVertices(), SizeIs(2));
}

TEST(MapMesh, AVertexThatStaysInItsCellKeepsItsIdAndMoves) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}, 5));
  const Eigen::Vector3d moved(1.003, 0, 0);
  map.update({0, 0, 0}, soup({kA, moved, kC}, 7));
  EXPECT_THAT(map.activeVertices(), ElementsAre(0, 1, 2));
  EXPECT_EQ(map.position(1), moved);
  EXPECT_EQ(map.label(1), 7);
}

TEST(MapMesh, AVertexThatLeavesItsCellDiesAndItsIdIsNotUsedAgain) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.update({0, 0, 0}, soup({kA, kD, kC}));
  EXPECT_FALSE(map.alive(1));
  EXPECT_THAT(map.activeVertices(), ElementsAre(0, 2, 3));
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  EXPECT_THAT(map.activeVertices(), ElementsAre(0, 2, 4));
}

TEST(MapMesh, AVertexOfTwoBlocksLivesUntilBothHaveLetItGo) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.update({1, 0, 0}, soup({kB, kD, kC}));
  map.update({0, 0, 0}, {});
  EXPECT_FALSE(map.alive(0));
  EXPECT_TRUE(map.active(1));
  map.update({1, 0, 0}, {});
  EXPECT_THAT(map.activeVertices(), IsEmpty());
  EXPECT_THAT(map.mesh().vertices, IsEmpty());
}

TEST(MapMesh, AVertexStaysActiveUntilTheLastOfItsBlocksIsArchived) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.update({1, 0, 0}, soup({kB, kD, kC}));
  map.archive({0, 0, 0});
  EXPECT_TRUE(map.alive(0));
  EXPECT_FALSE(map.active(0));
  EXPECT_THAT(map.activeVertices(), ElementsAre(1, 2, 3));
  map.archive({1, 0, 0});
  EXPECT_THAT(map.activeVertices(), IsEmpty());
  EXPECT_THAT(map.mesh().faces, SizeIs(2));
}

TEST(MapMesh, AVertexOfAFrozenTriangleOutlivesTheActiveBlockThatSharedIt) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.update({1, 0, 0}, soup({kB, kD, kC}));
  map.archive({0, 0, 0});
  map.update({1, 0, 0}, {});
  EXPECT_TRUE(map.alive(1));
  EXPECT_FALSE(map.active(1));
  EXPECT_FALSE(map.alive(3));
  EXPECT_THAT(map.mesh().faces, SizeIs(1));
}

TEST(MapMesh, ABlockThatIsSeenAgainAddsVerticesOfItsOwn) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.archive({0, 0, 0});
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  EXPECT_THAT(map.activeVertices(), ElementsAre(3, 4, 5));
  EXPECT_THAT(map.mesh().vertices, SizeIs(6));
}

TEST(MapMesh, OfABlockThatIsSeenAgainTheBetterMeasuredVersionStaysIfAsked) {
  MapMesh map(0.01, MapMesh::Revisited::kBest);
  const BlockIndex block(0, 0, 0);
  const auto visit = [&](std::initializer_list<Eigen::Vector3d> triangle, double confidence) {
    map.update(block, soup(triangle));
    map.archive(block, confidence);
    return map.mesh().vertices;
  };
  EXPECT_THAT(visit({kA, kB, kC}, 2), ElementsAre(kA, kB, kC));
  EXPECT_THAT(visit({kB, kD, kC}, 1), ElementsAre(kA, kB, kC));
  EXPECT_THAT(map.activeVertices(), IsEmpty());
  EXPECT_THAT(visit({kB, kD, kC}, 3), ElementsAre(kB, kD, kC));
  map.update({1, 0, 0}, soup({kA, kB, kC}));  // another block is no version of this one
  map.archive({1, 0, 0}, 1);
  EXPECT_THAT(map.mesh().faces, SizeIs(2));
}

TEST(MapMesh, WhatABlockIsArchivedInPiecesOfOneVisitStaysTogether) {
  MapMesh map(0.01, MapMesh::Revisited::kBest);
  const BlockIndex block(0, 0, 0);
  map.update(block, soup({kA, kB, kC}));
  map.archive(block, 2, false);
  map.update(block, soup({kB, kD, kC}));
  map.archive(block, 1);
  EXPECT_THAT(map.mesh().faces, SizeIs(2));
  map.update(block, soup({kA, kB, kD}));
  map.archive(block, 3);
  EXPECT_THAT(map.mesh().faces, SizeIs(1));
}

TEST(MapMesh, DropsTrianglesThatLoseTheirArea) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, {1.001, 0, 0}, kA, kB, kC}));
  EXPECT_THAT(map.mesh().faces, SizeIs(1));
}

TEST(MapMesh, KeepsOneOfEqualTrianglesAndNoneOfTwoBackToBack) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC, kC, kA, kB}));
  EXPECT_THAT(map.mesh().faces, SizeIs(1));
  map.update({0, 0, 0}, soup({kA, kB, kC, kA, kC, kB, kB, kD, kC}));
  EXPECT_THAT(map.mesh().faces, SizeIs(1));
  // The same across the border of two blocks.
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.update({1, 0, 0}, soup({kC, kB, kA}));
  EXPECT_THAT(map.mesh().faces, IsEmpty());
}

TEST(MapMesh, ASubmeshHasTheTrianglesWithAllCornersListed) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  map.archive({0, 0, 0});
  map.update({0, 0, 1}, soup({kB, kD, kC}));  // ids 3, 4, 5
  const std::vector<VertexId> three = {0, 1, 2};
  EXPECT_THAT(map.submesh(three).vertices, ElementsAre(kA, kB, kC));
  const std::vector<VertexId> not_one_triangle = {0, 1, 3, 4};
  EXPECT_TRUE(map.submesh(not_one_triangle).empty());
  EXPECT_THAT(map.submesh(not_one_triangle).vertices, IsEmpty());
  const std::vector<VertexId> all = {0, 1, 2, 3, 4, 5};
  EXPECT_THAT(map.submesh(all).faces, SizeIs(2));
}

TEST(MapMesh, ASubmeshPassesOverDeadVertices) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC, kB, kD, kC}));
  map.update({0, 0, 0}, soup({kA, kB, kC}));
  const std::vector<VertexId> ids = {0, 1, 2, 3, 99};
  EXPECT_THAT(map.submesh(ids).faces, SizeIs(1));
}

TEST(MapMesh, GivesLabelsAndColorsWithTheMesh) {
  MapMesh map(0.01);
  map.update({0, 0, 0}, soup({kA, kB, kC}, 13));
  std::vector<Label> labels;
  const Mesh mesh = map.mesh(&labels);
  EXPECT_THAT(labels, ElementsAre(13, 13, 13));
  EXPECT_THAT(mesh.colors, ElementsAre(Rgb{1, 2, 3}, Rgb{1, 2, 3}, Rgb{1, 2, 3}));
}

TEST(MapMesh, ListsActiveVerticesAscendingAfterManyChanges) {
  MapMesh map(0.01);
  Random random(3);
  std::map<int, TriangleSoup> blocks;
  for (int i = 0; i < 3000; ++i) {
    const int block = static_cast<int>(random.index(8));
    TriangleSoup triangles;
    for (int k = 0; k < 9; ++k) {
      triangles.vertices.emplace_back(random.index(9), random.index(9), random.index(9));
    }
    triangles.colors.resize(9);
    triangles.labels.resize(9);
    map.update({block, 0, 0}, triangles);
    blocks[block] = std::move(triangles);
  }
  std::vector<Eigen::Vector3d> expected;
  for (const auto& [index, triangles] : blocks) {
    expected.insert(expected.end(), triangles.vertices.begin(), triangles.vertices.end());
  }
  const auto less = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(expected.begin(), expected.end(), less);
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  const std::vector<VertexId> ids = map.activeVertices();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  std::vector<Eigen::Vector3d> positions;
  for (VertexId id : ids) positions.push_back(map.position(id));
  std::sort(positions.begin(), positions.end(), less);
  EXPECT_EQ(positions, expected);
}

TEST(CellTable, AgreesWithAMapThroughManyChanges) {
  CellTable table;
  std::map<BlockIndex, std::uint32_t, IndexLess> expected;
  Random random(1);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const BlockIndex cell(static_cast<int>(random.index(9)) - 4,
                          static_cast<int>(random.index(9)) - 4, static_cast<int>(random.index(9)));
    if (random.chance(0.5) && expected.erase(cell) > 0) {
      table.erase(cell);
    } else {
      std::uint32_t& value = table.findOrAdd(cell);
      const auto [place, added] = expected.emplace(cell, i);
      ASSERT_EQ(value, added ? CellTable::kNone : place->second);
      value = place->second;
    }
    ASSERT_EQ(table.size(), expected.size());
    ASSERT_EQ(table.find(cell), expected.count(cell) ? expected[cell] : CellTable::kNone);
  }
}

}  // namespace
}  // namespace hydrabench
