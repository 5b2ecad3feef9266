// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/latent_flow/latent_grid.h"
#include "eval/simulation/office_labels.h"
#include "eval/training/training_pool.h"
#include "tests/eval/training/toy_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using enum InstanceSplit;

TrainingWorldConfig quickConfig() {
  TrainingWorldConfig config;
  config.world = "quick";
  config.frames = 25;
  config.sdf_points = 200;
  config.image_width = 180;
  config.min_pixels = 60;
  return config;
}

/// What tells an instance from others: family and extent, all digits of it.
using Fingerprint = std::pair<std::string, std::array<double, 6>>;

std::set<Fingerprint> fingerprints(const OfficeConfig& config, std::uint64_t seed) {
  std::set<Fingerprint> result;
  for (const Furnisher::Placed& piece : layOutOffice(config, seed).pieces) {
    const ShapeInstance& shape = *piece.piece.shape;
    const Label label = piece.piece.label;
    if (label != office_label::kChair && label != office_label::kCouch &&
        label != office_label::kPlant && label != office_label::kBin) {
      continue;
    }
    const Aabb box = shape.sdf->bounds();
    result.insert({shape.family,
                   {box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(),
                    box.max().z()}});
  }
  return result;
}

bool meet(const std::set<Fingerprint>& a, const std::set<Fingerprint>& b) {
  return std::any_of(a.begin(), a.end(), [&](const Fingerprint& f) { return b.count(f) > 0; });
}

TEST(TrainingWorldSeed, OfOneSplitIsNoneOfAnotherNorOneAUserHas) {
  constexpr std::uint64_t kLast = (std::uint64_t{1} << 61) - 1;
  EXPECT_GT(trainingWorldSeed(kTraining, 0), kLast);
  EXPECT_EQ(trainingWorldSeed(kTraining, 5) - trainingWorldSeed(kTraining, 0), 5u);
  EXPECT_LT(trainingWorldSeed(kTraining, kLast), trainingWorldSeed(kValidation, 0));
  EXPECT_GT(trainingWorldSeed(kValidation, kLast), trainingWorldSeed(kValidation, 0));
}

TEST(TrainingWorldDeathTest, IsNeverMadeOfTheEvaluationSplit) {
  EXPECT_DEATH(trainingWorldSeed(kEvaluation, 0), "");
  EXPECT_DEATH(trainingOffice(quickConfig(), kEvaluation, 0), "");
  EXPECT_DEATH(makeTrainingWorld(quickConfig(), kEvaluation, 0), "");
  EXPECT_DEATH(trainingWorldSeed(kTraining, std::uint64_t{1} << 61), "");
}

TEST(TrainingOffice, SharesNoInstanceWithOfficesOfOtherSplits) {
  const auto training = fingerprints(trainingOffice(quickConfig(), kTraining, 0), 7);
  EXPECT_GE(training.size(), 15u);
  EXPECT_EQ(training, fingerprints(trainingOffice(quickConfig(), kTraining, 0), 7));
  // The same seed and the same wishes: the split alone makes the difference.
  OfficeConfig evaluated = trainingOffice(quickConfig(), kTraining, 0);
  evaluated.split = kEvaluation;
  OfficeConfig validation = evaluated;
  validation.split = kValidation;
  EXPECT_FALSE(meet(training, fingerprints(evaluated, 7)));
  EXPECT_FALSE(meet(training, fingerprints(validation, 7)));
  EXPECT_FALSE(meet(fingerprints(validation, 7), fingerprints(evaluated, 7)));
  EXPECT_FALSE(meet(training, fingerprints(OfficeConfig::quick(), 7)));
}

TEST(TrainingOffice, IsOfItsSplitAndAnotherForEveryIndex) {
  EXPECT_EQ(trainingOffice({}, kTraining, 3).split, kTraining);
  EXPECT_EQ(trainingOffice({}, kValidation, 3).split, kValidation);
  EXPECT_EQ(trainingOffice(quickConfig(), kValidation, 3).split, kValidation);
  const auto office = [](std::uint64_t index) {
    return fingerprints(trainingOffice(quickConfig(), kTraining, index),
                        trainingWorldSeed(kTraining, index));
  };
  EXPECT_FALSE(meet(office(0), office(1)));
}

/// A world beside the scene it was made from.
class TrainingWorldOfAScene : public ::testing::Test {
 protected:
  TrainingWorldOfAScene() {
    for (const SceneObject& object : scene_.objects) {
      if (object.scored) objects_.push_back(&object);
    }
  }

  /// Through a cache in which there is something else.
  TrainingWorld cachedWorld() const {
    writeText(folder_ / "train_000000.world", "hydrabench training world 1 of another config");
    return cachedTrainingWorld(config_, kTraining, 0, folder_.path());
  }

  /// Distance [m] of a point in object coordinates from the surface of shape `i`.
  double distance(std::size_t i, const Eigen::Vector3d& p) const {
    const SceneObject& object = *objects_[i];
    return object.shape->sdf->value(bounds(object.surface->mesh).center() +
                                    world_.shapes[i].half_extent_m * p);
  }

  void expectTrueDistances(std::size_t i) const {
    const TrainingShape& shape = world_.shapes[i];
    EXPECT_EQ(shape.family, objects_[i]->subtype);
    ASSERT_EQ(shape.points.size(), 200u);
    ASSERT_EQ(shape.distances.size(), 200u);
    int inside = 0;
    int near = 0;
    for (std::size_t k = 0; k < shape.points.size(); ++k) {
      const double expected = distance(i, shape.points[k].cast<double>()) / shape.half_extent_m;
      EXPECT_NEAR(shape.distances[k], std::clamp(expected, -0.5, 0.5), 2e-4);  // 16 bits
      inside += shape.distances[k] < 0;
      near += std::abs(shape.distances[k]) < 0.1;
    }
    EXPECT_GT(inside, 10) << shape.family;
    EXPECT_GT(near, 80) << shape.family;  // half of them were drawn there
    const double half = 0.5 * bounds(objects_[i]->surface->mesh).sizes().maxCoeff();
    if (shape.yaw_symmetry != 0) {
      EXPECT_NEAR(shape.half_extent_m, half, 1e-6);
    } else {
      EXPECT_GE(shape.half_extent_m, half - 1e-6);
    }
  }

  /// Share of the points on an object that lie within 6 cm of its surface, were its yaw so.
  template <typename YawOf>
  double shareOnSurface(const YawOf& yawOf) const {
    double near = 0;
    double all = 0;
    for (const TrainingView& view : world_.views) {
      const TrainingShape& shape = world_.shapes[view.shape];
      if (shape.class_name != "chair" && shape.class_name != "couch") continue;
      for (std::size_t i = 0; i < view.points.object.size(); ++i) {
        if (!view.on_object[i]) continue;
        const Eigen::Vector3f from_center = view.points.object[i] - view.center;
        const Eigen::Vector3f p = turnedBy(-yawOf(view), from_center) / shape.half_extent_m;
        near += std::abs(distance(view.shape, p.cast<double>())) < 0.06;
        ++all;
      }
    }
    return near / all;
  }

  TrainingWorldConfig config_ = quickConfig();
  TemporaryFolder folder_;
  TrainingWorld world_ = cachedWorld();
  Scene scene_ = makeOffice(trainingOffice(config_, kTraining, 0), trainingWorldSeed(kTraining, 0));
  std::vector<const SceneObject*> objects_;
};

TEST_F(TrainingWorldOfAScene, IsTrueToTheSceneAndTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(world_.shapes.size(), objects_.size());
  std::set<std::string> classes;
  for (std::size_t i = 0; i < world_.shapes.size(); ++i) {
    classes.insert(world_.shapes[i].class_name);
    expectTrueDistances(i);
  }
  EXPECT_EQ(classes, (std::set<std::string>{"bin", "chair", "couch", "plant"}));

  ASSERT_GT(world_.views.size(), 20u);
  bool some_leak = false;
  for (const TrainingView& view : world_.views) {
    ASSERT_EQ(view.on_object.size(), view.points.object.size());
    EXPECT_GE(view.points.object.size(), 30u);
    const auto leaked = std::count(view.on_object.begin(), view.on_object.end(), 0);
    if (view.clean) {
      EXPECT_EQ(leaked, 0);
    }
    some_leak |= leaked > 0;
  }
  EXPECT_TRUE(some_leak);

  // All conventions about poses at once: measured points, turned back, lie on the true surface, and
  // do not if the yaw is read in any other way.
  EXPECT_GT(shareOnSurface([](const TrainingView& v) { return v.yaw; }), 0.9);
  EXPECT_LT(shareOnSurface([](const TrainingView& v) { return v.yaw + std::numbers::pi; }), 0.8);
  EXPECT_LT(shareOnSurface([](const TrainingView& v) { return -v.yaw; }), 0.8);

  setNumThreads(numThreads() == 1 ? 2 : 1);
  writeTrainingWorld(folder_ / "other", config_, makeTrainingWorld(config_, kTraining, 0));
  setNumThreads(0);
  EXPECT_TRUE(readText(folder_ / "other") == readText(folder_ / "train_000000.world"));
}

TEST(TrainingWorldWithGrids, HoldsTrueDistancesNearThePoseOfAllThatStandsThere) {
  TrainingWorldConfig config = quickConfig();
  config.objects = "all";
  config.grid_frames = 2;
  const TrainingWorld world = makeTrainingWorld(config, kTraining, 0);
  const Scene scene =
      makeOffice(trainingOffice(config, kTraining, 0), trainingWorldSeed(kTraining, 0));
  ASSERT_EQ(world.shapes.size(), scene.objects.size());
  std::set<std::string> classes;
  for (std::size_t i = 0; i < world.shapes.size(); ++i) {
    const TrainingShape& shape = world.shapes[i];
    classes.insert(shape.class_name);
    ASSERT_EQ(shape.grids.size(), 2u);
    const SceneObject& object = scene.objects[i];
    const Eigen::Vector3d center = bounds(object.surface->mesh).center();
    for (const ShapeGrid& grid : shape.grids) {
      EXPECT_LE(grid.frame.center.norm(), 0.5);
      EXPECT_NEAR(std::log(grid.frame.scale), 0, 0.5);
      for (int k = 0; k < kGridSide; ++k) {  // along a diagonal
        const Eigen::Vector3d p = grid.frame.toLevel(gridNode(k, kGridSide - 1 - k, k));
        const double distance = object.shape->sdf->value(center + shape.half_extent_m * p) /
                                shape.half_extent_m / grid.frame.scale;
        EXPECT_EQ(grid.values[gridIndex(k, kGridSide - 1 - k, k)], quantizedDistance(distance))
            << shape.family << k;
      }
    }
  }
  EXPECT_TRUE(classes.count("desk") && classes.count("computer") && classes.count("chair"));
}

TrainingWorldConfig streetConfig() {
  TrainingWorldConfig config = quickConfig();
  config.world = "street";
  config.max_depth_m = 12;
  return config;
}

/// The first street on an incline of more than 4 %.
std::uint64_t steepStreet() {
  StreetBlockConfig empty;
  empty.cars = empty.hydrants = empty.benches = empty.unscored = 0;
  for (std::uint64_t index = 0;; ++index) {
    const StreetBlock block = makeStreetBlock(empty, trainingWorldSeed(kTraining, index));
    if (std::abs(block.slope_x) > 0.04) return index;
  }
}

TEST(TrainingStreet, ShowsLeaningCarsAsShapesThatLean) {
  const std::uint64_t index = steepStreet();
  const TrainingWorld world = makeTrainingWorld(streetConfig(), kTraining, index);
  const StreetBlock block =
      makeStreetBlock(trainingStreet(kTraining), trainingWorldSeed(kTraining, index));
  std::vector<const SceneObject*> objects;
  for (const SceneObject& object : block.scene.objects) {
    if (object.scored) objects.push_back(&object);
  }
  ASSERT_EQ(world.shapes.size(), objects.size());
  std::set<std::string> classes;
  for (const TrainingShape& shape : world.shapes) classes.insert(shape.class_name);
  EXPECT_EQ(classes, (std::set<std::string>{"bench", "car", "fire_hydrant"}));

  // Measured points of cars, turned back by the yaw alone, lie on the leaning car's surface, not on
  // that of an upright one.
  double leaning = 0;
  double upright = 0;
  double all = 0;
  for (const TrainingView& view : world.views) {
    const TrainingShape& shape = world.shapes[view.shape];
    if (shape.class_name != "car") continue;
    const SceneObject& car = *objects[view.shape];
    const Eigen::Matrix3d back =
        Eigen::AngleAxisd(-view.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d lean = back * car.T_world_object.linear();
    const Eigen::Vector3d center = bounds(car.surface->mesh).center();
    Aabb box;  // of the leaning car, in its upright frame
    for (const Eigen::Vector3d& v : car.surface->mesh.vertices) box.extend(lean * v);
    for (std::size_t i = 0; i < view.points.object.size(); ++i) {
      if (!view.on_object[i]) continue;
      const Eigen::Vector3d p =
          back * (view.points.object[i] - view.center).cast<double>();  // from the box's centre
      leaning += std::abs(car.shape->sdf->value(lean.transpose() * (box.center() + p))) < 0.06;
      upright += std::abs(car.shape->sdf->value(center + p)) < 0.06;
      ++all;
    }
  }
  ASSERT_GT(all, 500);
  EXPECT_GT(leaning / all, 0.8);
  EXPECT_LT(upright, leaning - 0.05 * all);
}

TEST(TrainingStreet, IsOfItsSplit) {
  EXPECT_EQ(trainingStreet(kTraining).split, kTraining);
  EXPECT_EQ(trainingStreet(kValidation).split, kValidation);
  StreetBlockConfig config;
  config.hydrants = config.benches = config.unscored = 0;
  config.cars = 3;
  const auto heights = [&](InstanceSplit split) {
    config.split = split;
    std::set<double> result;
    for (const SceneObject& object : makeStreetBlock(config, 5).scene.objects) {
      result.insert(object.shape->sdf->bounds().max().z());
    }
    return result;
  };
  EXPECT_EQ(heights(kTraining).size(), 3u);
  EXPECT_EQ(heights(kTraining), heights(kTraining));
  EXPECT_NE(heights(kTraining), heights(kValidation));
}

}  // namespace
}  // namespace hydrabench
