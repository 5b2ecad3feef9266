// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/shape_family.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

ShapeInstance drawn(const ShapeFamily& family, std::uint64_t index) {
  return family.draw(Random(instanceSeed(InstanceSplit::kEvaluation, index)));
}

Vector3d randomPointIn(const Aabb& box, Random& random) {
  return {random.uniform(box.min().x(), box.max().x()),
          random.uniform(box.min().y(), box.max().y()),
          random.uniform(box.min().z(), box.max().z())};
}

TEST(ShapeFamilies, CoverTheClassesOfTheOffice) {
  std::map<std::string, int> families_of_class;
  std::set<std::string> names;
  for (const ShapeFamily& family : shapeFamilies()) {
    ++families_of_class[family.class_name];
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_EQ(&shapeFamily(family.name), &family);
  }
  EXPECT_EQ(families_of_class["chair"], 3);
  EXPECT_EQ(families_of_class["couch"], 3);
  EXPECT_EQ(families_of_class["plant"], 2);
  EXPECT_EQ(families_of_class["bin"], 3);
  EXPECT_EQ(families_of_class["computer"], 6);
}

TEST(ShapeFamilies, OfStreetsFollowThoseOfRooms) {
  EXPECT_EQ(indoorFamilies().data(), shapeFamilies().data());
  EXPECT_EQ(indoorFamilies().size() + outdoorFamilies().size(), shapeFamilies().size());
  EXPECT_EQ(indoorFamilies().back().name, "whiteboard");
  std::map<std::string, int> families_of_class;
  for (const ShapeFamily& family : outdoorFamilies()) ++families_of_class[family.class_name];
  const std::map<std::string, int> expected = {{"fire_hydrant", 3}, {"car", 5},  {"bench", 3},
                                               {"tree", 2},         {"pole", 1}, {"bollard", 1},
                                               {"sign", 1}};
  EXPECT_EQ(families_of_class, expected);
}

TEST(ShapeFamiliesDeathTest, AbortForANameThatDoesNotExist) {
  EXPECT_DEATH(shapeFamily("throne"), "no shape family is called \"throne\"");
}

TEST(ShapeInstance, DependsOnItsRandomStreamAlone) {
  for (const ShapeFamily& family : shapeFamilies()) {
    const ShapeInstance once = drawn(family, 5);
    const ShapeInstance again = drawn(family, 5);
    const ShapeInstance other = drawn(family, 6);
    EXPECT_EQ(once.family, family.name);
    ASSERT_EQ(once.parts.size(), again.parts.size());
    const Aabb box = once.sdf->bounds();
    Random random(1);
    bool differs = once.parts.size() != other.parts.size();
    for (int i = 0; i < 50; ++i) {
      const Vector3d p = randomPointIn(box, random);
      EXPECT_EQ(once.sdf->value(p), again.sdf->value(p));
      differs = differs || once.sdf->value(p) != other.sdf->value(p);
    }
    EXPECT_TRUE(differs) << family.name;
  }
}

TEST(ShapeInstance, DistanceChangesNoFasterThanThePointMoves) {
  for (const ShapeFamily& family : shapeFamilies()) {
    for (std::uint64_t index = 0; index < 4; ++index) {
      const ShapeInstance instance = drawn(family, index);
      const Aabb box = instance.sdf->bounds();
      Random random(index);
      for (int i = 0; i < 1500; ++i) {
        const Vector3d p = randomPointIn(box, random);
        const Vector3d q =
            i % 2 == 0
                ? randomPointIn(box, random)
                : Vector3d(p + 0.002 * Vector3d(random.normal(), random.normal(), random.normal()));
        const double change = std::abs(instance.sdf->value(p) - instance.sdf->value(q));
        ASSERT_LE(change, (p - q).norm() * (1 + 1e-9) + 1e-12)
            << family.name << " " << p.transpose() << " to " << q.transpose();
      }
    }
  }
}

TEST(ShapeInstance, IsTheUnionOfItsParts) {
  for (const ShapeFamily& family : shapeFamilies()) {
    const ShapeInstance instance = drawn(family, 2);
    const Aabb box = instance.sdf->bounds();
    Random random(9);
    for (int i = 0; i < 200; ++i) {
      const Vector3d p = randomPointIn(box, random);
      bool inside = false;
      for (const ShapePart& part : instance.parts) inside = inside || part.sdf->value(p) < 0;
      EXPECT_EQ(instance.sdf->value(p) < 0, inside) << family.name;
    }
  }
}

TEST(ShapeInstance, LooksTheSameAfterATurnThatItDeclares) {
  for (const ShapeFamily& family : shapeFamilies()) {
    for (std::uint64_t index = 0; index < 4; ++index) {
      const ShapeInstance instance = drawn(family, index);
      if (instance.yaw_symmetry == 1) continue;
      // No front: any angle will do.
      const double turn =
          instance.yaw_symmetry == 0 ? 1.0 : 2 * std::numbers::pi / instance.yaw_symmetry;
      const Eigen::AngleAxisd rotation(turn, Vector3d::UnitZ());
      const Aabb box = instance.sdf->bounds();
      Random random(index);
      for (int i = 0; i < 200; ++i) {
        const Vector3d p = randomPointIn(box, random);
        ASSERT_NEAR(instance.sdf->value(rotation * p), instance.sdf->value(p), 1e-9)
            << family.name << " at " << p.transpose();
      }
    }
  }
}

TEST(InstanceSeed, NeverSharesASeedBetweenSplits) {
  using enum InstanceSplit;
  // The ranges [first, last] of the three splits follow each other without touching.
  EXPECT_LT(instanceSeed(kEvaluation, kMaxInstanceIndex), instanceSeed(kTraining, 0));
  EXPECT_LT(instanceSeed(kTraining, kMaxInstanceIndex), instanceSeed(kValidation, 0));
  EXPECT_EQ(instanceSeed(kTraining, 7) - instanceSeed(kTraining, 0), 7u);
  for (std::uint64_t object = 0; object < 1000; ++object) {
    EXPECT_LE(instanceIndex(42, object), kMaxInstanceIndex);
  }
}

TEST(InstanceSeedDeathTest, AbortsBeyondTheRange) {
  EXPECT_DEATH(instanceSeed(InstanceSplit::kTraining, kMaxInstanceIndex + 1), "instance index");
}

}  // namespace
}  // namespace hydrabench
