// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/mesh_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Label kChair = 5;
constexpr Label kFloor = 3;

/// A square of 10 x 10 cells of 0.1 m, 121 vertices, from (x, y) on.
TriangleSoup square(double x, double y, Label label = kChair) {
  TriangleSoup soup;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) {
      const Eigen::Vector3d a(x + 0.1 * i, y + 0.1 * j, 0);
      const Eigen::Vector3d b = a + Eigen::Vector3d(0.1, 0, 0);
      const Eigen::Vector3d c = a + Eigen::Vector3d(0, 0.1, 0);
      const Eigen::Vector3d d = a + Eigen::Vector3d(0.1, 0.1, 0);
      soup.vertices.insert(soup.vertices.end(), {a, b, c, b, d, c});
    }
  }
  soup.colors.resize(soup.vertices.size());
  soup.labels.assign(soup.vertices.size(), label);
  return soup;
}

/// A strip of 40 triangles, 42 vertices, 5 cm apart, from x on at height z.
TriangleSoup strip(double x, double z = 0) {
  TriangleSoup soup;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d a(x + 0.05 * i, 0, z);
    const Eigen::Vector3d b = a + Eigen::Vector3d(0.05, 0, 0);
    const Eigen::Vector3d c = a + Eigen::Vector3d(0, 0.05, 0);
    const Eigen::Vector3d d = a + Eigen::Vector3d(0.05, 0.05, 0);
    soup.vertices.insert(soup.vertices.end(), {a, b, c, b, d, c});
  }
  soup.colors.resize(soup.vertices.size());
  soup.labels.assign(soup.vertices.size(), kChair);
  return soup;
}

class MeshObjectsTest : public testing::Test {
 protected:
  MapMesh mesh_{0.005};
  MeshObjects objects_{{}, {kChair}};
};

TEST_F(MeshObjectsTest, AClusterOfAnObjectClassBecomesANode) {
  mesh_.update({0, 0, 0}, square(0, 0));
  mesh_.update({1, 0, 0}, square(3, 0, kFloor));
  objects_.update(mesh_, 7);
  ASSERT_THAT(objects_.nodes(), SizeIs(1));
  const MeshObjects::Node& node = objects_.nodes()[0];
  EXPECT_EQ(node.label, kChair);
  EXPECT_THAT(node.vertices, SizeIs(121));
  EXPECT_TRUE(node.position.isApprox(Eigen::Vector3d(0.5, 0.5, 0)));
  EXPECT_TRUE(node.box.max().isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(node.active);
  EXPECT_EQ(node.first_observed_ns, 7);
}

TEST_F(MeshObjectsTest, AClusterOfTheWrongSizeDoesNot) {
  mesh_.update({0, 0, 0}, square(0, 0));
  MeshObjects too_small({.min_cluster_size = 122}, {kChair});
  MeshObjects too_large({.max_cluster_size = 120}, {kChair});
  too_small.update(mesh_, 1);
  too_large.update(mesh_, 1);
  EXPECT_THAT(too_small.nodes(), IsEmpty());
  EXPECT_THAT(too_large.nodes(), IsEmpty());
}

TEST_F(MeshObjectsTest, ANodeGrowsByClustersWhoseCentroidItsBoxContains) {
  mesh_.update({0, 0, 0}, square(0, 0));
  objects_.update(mesh_, 1);
  mesh_.update({1, 0, 0}, square(0.9, 0));  // the whole is centred at x = 0.95, inside
  objects_.update(mesh_, 2);
  ASSERT_THAT(objects_.nodes(), SizeIs(1));
  EXPECT_EQ(objects_.nodes()[0].number, 0u);
  EXPECT_THAT(objects_.nodes()[0].vertices, SizeIs(20 * 11));
  EXPECT_EQ(objects_.nodes()[0].first_observed_ns, 1);
  EXPECT_EQ(objects_.nodes()[0].last_observed_ns, 2);
  objects_.update(mesh_, 3);
  EXPECT_EQ(objects_.nodes()[0].last_observed_ns, 2);  // nothing new
}

TEST_F(MeshObjectsTest, NodesMergeOnceOneContainsTheOther) {
  mesh_.update({0, 0, 0}, square(0, 0));
  mesh_.update({1, 0, 0}, square(2, 0));
  objects_.update(mesh_, 1);
  EXPECT_THAT(objects_.nodes(), SizeIs(2));
  mesh_.update({2, 0, 0}, square(1, 0));  // joins them to one cluster
  objects_.update(mesh_, 2);
  ASSERT_THAT(objects_.nodes(), SizeIs(1));
  EXPECT_EQ(objects_.nodes()[0].number, 0u);
  EXPECT_THAT(objects_.nodes()[0].vertices, SizeIs(31 * 11));
}

TEST_F(MeshObjectsTest, ANodeThatLosesItsVerticesIsDeleted) {
  mesh_.update({0, 0, 0}, square(0, 0));
  objects_.update(mesh_, 1);
  mesh_.update({0, 0, 0}, {});
  objects_.update(mesh_, 2);
  EXPECT_THAT(objects_.nodes(), IsEmpty());
}

TEST_F(MeshObjectsTest, ANodeWhoseVerticesChangeTheirClassIsDeleted) {
  mesh_.update({0, 0, 0}, square(0, 0));
  objects_.update(mesh_, 1);
  mesh_.update({0, 0, 0}, square(0, 0, kFloor));
  objects_.update(mesh_, 2);
  EXPECT_THAT(objects_.nodes(), IsEmpty());
}

TEST_F(MeshObjectsTest, ANodeIsActiveUntilAllItsVerticesAreArchived) {
  mesh_.update({0, 0, 0}, square(0, 0));
  mesh_.update({1, 0, 0}, square(0.9, 0));
  objects_.update(mesh_, 1);
  mesh_.archive({0, 0, 0});
  objects_.update(mesh_, 2);
  ASSERT_THAT(objects_.nodes(), SizeIs(1));
  EXPECT_TRUE(objects_.nodes()[0].active);
  EXPECT_THAT(objects_.nodes()[0].vertices, SizeIs(20 * 11));
  mesh_.archive({1, 0, 0});
  objects_.update(mesh_, 3);
  ASSERT_THAT(objects_.nodes(), SizeIs(1));
  EXPECT_FALSE(objects_.nodes()[0].active);
}

TEST_F(MeshObjectsTest, AnArchivedNodeIsJoinedWhenItIsSeenAgain) {
  for (const bool merge : {true, false}) {
    MapMesh mesh(0.005);
    MeshObjects objects({.merge_revisited = merge}, {kChair});
    mesh.update({0, 0, 0}, square(0, 0));
    objects.update(mesh, 1);
    mesh.archive({0, 0, 0});
    objects.update(mesh, 2);
    mesh.update({0, 0, 0}, square(0.4, 0));
    objects.update(mesh, 3);
    ASSERT_THAT(objects.nodes(), SizeIs(merge ? 1 : 2));
    EXPECT_EQ(objects.nodes()[0].number, 0u);
    EXPECT_EQ(objects.nodes()[0].active, merge);
    EXPECT_THAT(objects.nodes()[0].vertices, SizeIs(merge ? 242 : 121));
  }
}

TEST_F(MeshObjectsTest, AnArchivedNodeElsewhereIsNotJoined) {
  mesh_.update({0, 0, 0}, square(0, 0));
  objects_.update(mesh_, 1);
  mesh_.archive({0, 0, 0});
  objects_.update(mesh_, 2);
  mesh_.update({0, 0, 0}, square(0.6, 0));  // they overlap, but neither box has the other's centre
  objects_.update(mesh_, 3);
  EXPECT_THAT(objects_.nodes(), SizeIs(2));
}

TEST(MeshObjectsArchive, ANodeArchivedInThisUpdateTakesNoCluster) {
  MapMesh mesh(0.005);
  MeshObjects objects({.merge_revisited = false}, {kChair});
  mesh.update({0, 0, 0}, strip(0));
  objects.update(mesh, 1);
  mesh.archive({0, 0, 0});
  mesh.update({0, 0, 0}, strip(0.1));  // its centre lies in the archived node's box
  objects.update(mesh, 2);
  ASSERT_THAT(objects.nodes(), SizeIs(2));
  EXPECT_FALSE(objects.nodes()[0].active);
  EXPECT_THAT(objects.nodes()[0].vertices, SizeIs(42));
  EXPECT_TRUE(objects.nodes()[1].active);
  EXPECT_EQ(objects.nodes()[1].first_observed_ns, 2);
}

TEST(MeshObjectsArchive, ANodeWhoseVerticesAllMovedIsStillTheSame) {
  MapMesh mesh(0.005);
  MeshObjects objects({}, {kChair});
  mesh.update({0, 0, 0}, strip(0, -0.01));
  mesh.update({1, 0, 0}, strip(0, 0.01));
  objects.update(mesh, 1);
  mesh.update({0, 0, 0}, strip(0.02));  // no vertex in its old cell
  mesh.update({1, 0, 0}, {});
  objects.update(mesh, 2);
  ASSERT_THAT(objects.nodes(), SizeIs(1));
  EXPECT_EQ(objects.nodes()[0].number, 0u);
  EXPECT_EQ(objects.nodes()[0].first_observed_ns, 1);
}

}  // namespace
}  // namespace hydrabench
