// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "baselines/hydra/mesh_objects.h"

namespace hydrabench {
namespace {

using testing::SizeIs;

constexpr Label kChair = 5;

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
