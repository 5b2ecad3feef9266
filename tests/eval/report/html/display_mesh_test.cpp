// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/display_mesh.h"

#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"

namespace hydrabench {
namespace {

double longestEdge(const Mesh& mesh) {
  double longest = 0;
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, (mesh.vertices[static_cast<std::size_t>(face[k])] -
                                   mesh.vertices[static_cast<std::size_t>(face[(k + 1) % 3])])
                                      .norm());
    }
  }
  return longest;
}

TEST(DisplayMesh, HasEnoughVerticesOnFlatFacesForAnErrorToVary) {
  const Mesh box = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0.4, 0.2)));
  const Mesh shown = displayMesh(box, 800);
  EXPECT_GT(longestEdge(box), 1);
  EXPECT_LE(longestEdge(shown), 0.15 * bounds(box).diagonal().norm());
}

TEST(DisplayMesh, StaysClosedAndTheSameSurfaceWhenEdgesAreHalved) {
  const Mesh box = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0.4, 0.2)));
  const Mesh shown = displayMesh(box, 800);
  EXPECT_TRUE(analyzeTopology(shown).watertight());
  EXPECT_NEAR(surfaceArea(shown), surfaceArea(box), 1e-9);
  EXPECT_NEAR(signedVolume(shown), signedVolume(box), 1e-9);
}

TEST(DisplayMesh, KeepsToTheFacesItWasGranted) {
  const Mesh sphere = sphereMesh({0, 0, 0}, 1, 5);  // 20480 faces
  EXPECT_LE(coarseMesh(sphere, 500).faces.size(), 500u);
  EXPECT_LE(displayMesh(sphere, 500).faces.size(), 2000u);
  EXPECT_TRUE(displayMesh(Mesh(), 500).empty());
}

}  // namespace
}  // namespace hydrabench
