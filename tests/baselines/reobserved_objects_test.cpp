// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/khronos/reobserved_objects.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

/// A unit cube at x, seen from first to last.
ObjectNode cube(ObjectId id, double x, std::int64_t first_ns, std::int64_t last_ns,
                Label label = 5) {
  ObjectNode node;
  node.id = id;
  node.label = label;
  node.mesh = boxMesh(Aabb(Vector3d(x, 0, 0), Vector3d(x + 1, 1, 1)));
  node.box = bounds(node.mesh);
  node.T_world_object.translation() = node.box.center();
  node.first_observed_ns = first_ns;
  node.last_observed_ns = last_ns;
  return node;
}

TEST(ReobservedObjects, MergesWhatIntersectsAndWasSeenAtOtherTimes) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 0.5, 20, 30));
  ASSERT_EQ(objects.nodes().size(), 1u);
  const ObjectNode whole = objects.nodes()[0];
  EXPECT_EQ(whole.id, 1u);
  EXPECT_EQ(whole.mesh.faces.size(), 24u);
  EXPECT_EQ(whole.box.max(), Vector3d(1.5, 1, 1));
  EXPECT_EQ(whole.T_world_object.translation(), Vector3d(0.75, 0.5, 0.5));
  EXPECT_EQ(whole.first_observed_ns, 0);
  EXPECT_EQ(whole.last_observed_ns, 30);
  EXPECT_EQ(objects.numMerged(), 1u);
}

TEST(ReobservedObjects, WhatWasSeenAtTheSameTimeIsTwoThings) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 0.5, 10, 30));  // one instant is enough
  EXPECT_EQ(objects.nodes().size(), 2u);
}

TEST(ReobservedObjects, EveryTimeAnObjectWasSeenCounts) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 0.5, 40, 50));  // the same
  objects.add(cube(3, 0.5, 20, 30));  // in between: the same
  objects.add(cube(4, 0.5, 45, 46));  // together with the second
  EXPECT_EQ(objects.nodes().size(), 2u);
}

TEST(ReobservedObjects, OtherClassesAndBoxesApartStayApart) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 0, 20, 30, 7));
  objects.add(cube(3, 1, 40, 50));  // touches without volume
  EXPECT_EQ(objects.nodes().size(), 3u);
}

TEST(ReobservedObjects, TheThresholdIsInclusive) {
  // Half of each: 0.5 / 1.5.
  ReobservedObjects at(1.0 / 3.0);
  at.add(cube(1, 0, 0, 10));
  at.add(cube(2, 0.5, 20, 30));
  EXPECT_EQ(at.nodes().size(), 1u);
  ReobservedObjects above(0.34);
  above.add(cube(1, 0, 0, 10));
  above.add(cube(2, 0.5, 20, 30));
  EXPECT_EQ(above.nodes().size(), 2u);
}

TEST(ReobservedObjects, TheBestMatchIsTaken) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 1.2, 0, 10));
  objects.add(cube(3, 0.9, 20, 30));  // 0.1 of the first, 0.7 of the second
  // United with the second it reaches from 0.9 to 2.2 and was seen together with the first.
  ASSERT_EQ(objects.nodes().size(), 2u);
  EXPECT_EQ(objects.nodes()[0].box.max().x(), 1);
  EXPECT_EQ(objects.nodes()[1].box.min().x(), 0.9);
}

TEST(ReobservedObjects, AnObjectThatConnectsTwoMakesOneOfThem) {
  ReobservedObjects objects(1e-5);
  objects.add(cube(1, 0, 0, 10));
  objects.add(cube(2, 1.5, 20, 30));
  objects.add(cube(3, 0.8, 40, 50));
  ASSERT_EQ(objects.nodes().size(), 1u);
  EXPECT_EQ(objects.nodes()[0].id, 1u);
  EXPECT_EQ(objects.nodes()[0].box.max().x(), 2.5);
}

}  // namespace
}  // namespace hydrabench
