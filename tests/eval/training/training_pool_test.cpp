// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_pool.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/eval/training/toy_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr int kDistances = 50;
const Eigen::Vector3f kHalf(0.5f, 1, 0.4f);

struct Toy {
  TrainingShape shape;
  TrainingView view;
};

Toy toy(int yaw_symmetry) {
  Toy result;
  result.shape = toyShape("couch", yaw_symmetry, kHalf, Random(1));
  result.view = toyView(0, result.shape, kHalf, Random(2));
  return result;
}

TrainingSample sampleOf(const Toy& toy, double stretch = 1) {
  return makeTrainingSample(toy.shape, toy.view, kDistances, stretch, Random(3));
}

Eigen::Vector3f row(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

/// Yaw in the level frame that the target of the direct output stands for.
double yawOf(const TrainingSample& sample, int pose) {
  const auto& direct = sample.direct[pose];
  return std::atan2(direct[5], direct[4]) + sample.input.frame.bearing;
}

TEST(TrainingSample, MapsMeasuredPointsOntoTheShapeInTheUnitCube) {
  for (const int symmetry : {1, 2}) {
    const Toy t = toy(symmetry);
    const TrainingSample sample = sampleOf(t);
    ASSERT_EQ(sample.nocs[0].size(), 3u * PointInput::kObjectPoints);
    ASSERT_EQ(sample.weights.size(), std::size_t{PointInput::kObjectPoints});
    for (std::size_t i = 0; i < PointInput::kObjectPoints; ++i) {
      EXPECT_LE(row(sample.nocs[0], i).cwiseAbs().maxCoeff(), 1 + 1e-5f);
      EXPECT_NEAR(boxDistance(row(sample.nocs[0], i), kHalf), 0, 1e-5);
      EXPECT_EQ(sample.weights[i], 1);
    }
  }
}

TEST(TrainingSample, TargetsOfPosePutNocsBackToWhereThePointsAre) {
  for (const int symmetry : {0, 1, 2}) {
    const Toy t = toy(symmetry);
    const TrainingSample sample = sampleOf(t, 1.1);
    const LocalFrame& frame = sample.input.frame;
    for (int pose = 0; pose < TrainingSample::kPoses; ++pose) {
      const auto& direct = sample.direct[pose];
      const Eigen::Vector3d center = frame.toLevel({direct[0], direct[1], direct[2]});
      const double half_extent = frame.scale * std::exp(direct[3]);
      EXPECT_NEAR(half_extent, 1.1 * 0.4, 1e-6);
      for (std::size_t i = 0; i < PointInput::kObjectPoints; i += 17) {
        const Eigen::Vector3f p =
            center.cast<float>() + static_cast<float>(half_extent) *
                                       turnedBy(yawOf(sample, pose), row(sample.nocs[pose], i));
        EXPECT_LT((p - 1.1f * t.view.points.object[sample.input.source[i]]).norm(), 1e-5f);
      }
    }
  }
}

TEST(TrainingSample, OfAShapeThatLooksTheSameFromBehindHasTwoPosesHalfATurnApart) {
  const TrainingSample sample = sampleOf(toy(2));
  for (std::size_t i = 0; i < PointInput::kObjectPoints; ++i) {
    const Eigen::Vector3f a = row(sample.nocs[0], i);
    EXPECT_LT((row(sample.nocs[1], i) - Eigen::Vector3f(-a.x(), -a.y(), a.z())).norm(), 1e-5f);
  }
  EXPECT_NEAR(sample.direct[1][4], -sample.direct[0][4], 1e-6);
  EXPECT_NEAR(sample.direct[1][5], -sample.direct[0][5], 1e-6);
  const TrainingSample single = sampleOf(toy(1));
  EXPECT_EQ(single.nocs[0], single.nocs[1]);
  EXPECT_EQ(single.direct[0], single.direct[1]);
}

TEST(TrainingSample, AShapeWithoutAFrontFacesTheCamera) {
  const TrainingSample sample = sampleOf(toy(0));
  const Eigen::Vector3f to_camera = turnedBy(-yawOf(sample, 0), -sample.center_level.cast<float>());
  EXPECT_NEAR(to_camera.y(), 0, 1e-5);
  EXPECT_GT(to_camera.x(), 1.5f);
  EXPECT_EQ(sample.nocs[0], sample.nocs[1]);
}

TEST(TrainingSample, DistancesStayTrueHoweverTheShapeIsTurned) {
  for (const int symmetry : {0, 1, 2}) {
    const Toy t = toy(symmetry);
    const TrainingSample sample = sampleOf(t, 0.9);
    // Back into the frame in which the box stands straight: only what faces the camera was turned.
    const double turn = symmetry == 0 ? yawOf(sample, 0) - t.view.yaw : 0;
    ASSERT_EQ(sample.distances.size(), std::size_t{kDistances});
    for (std::size_t i = 0; i < kDistances; ++i) {
      const Eigen::Vector3f p = turnedBy(turn, row(sample.points, i));
      EXPECT_NEAR(sample.distances[i], std::min(0.5f, boxDistance(p, kHalf)), 1e-5);
    }
  }
}

TEST(TrainingSample, AStretchScalesLengthsAndNoAngles) {
  const Toy t = toy(1);
  const TrainingSample plain = sampleOf(t);
  const TrainingSample large = sampleOf(t, 1.2);
  EXPECT_FALSE(plain.augmented);
  EXPECT_TRUE(large.augmented);
  EXPECT_NEAR(large.half_extent_m, 1.2 * plain.half_extent_m, 1e-7);
  EXPECT_LT((large.center_level - 1.2 * plain.center_level).norm(), 1e-6);
  EXPECT_NEAR(large.input.frame.scale, 1.2 * plain.input.frame.scale, 1e-6);
  EXPECT_NEAR(large.input.frame.bearing, plain.input.frame.bearing, 1e-6);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(large.direct[0][k], plain.direct[0][k], 1e-5);
  for (std::size_t i = 0; i < plain.nocs[0].size(); ++i) {
    ASSERT_NEAR(large.nocs[0][i], plain.nocs[0][i], 1e-5);
  }
  EXPECT_EQ(large.points, plain.points);
  EXPECT_EQ(large.distances, plain.distances);
}

TEST(TrainingSample, PointsOffTheObjectDoNotCount) {
  Toy t = toy(1);
  t.view.on_object[4] = 0;                                 // leaked
  t.view.points.object[9] += Eigen::Vector3f(0, 0, 0.9f);  // on the object, yet far from it
  const TrainingSample sample = sampleOf(t);
  for (std::size_t i = 0; i < sample.weights.size(); ++i) {
    const std::uint32_t source = sample.input.source[i];
    EXPECT_EQ(sample.weights[i], source == 4 || source == 9 ? 0 : 1);
  }
}

class ToyPool : public ::testing::Test {
 protected:
  ToyPool() : pool_(TrainingWorldConfig(), InstanceSplit::kTraining, folder_.path()) {
    cacheToyWorlds(folder_.path(), {});
  }

  std::set<std::int64_t> numbers() const {
    std::set<std::int64_t> result;
    for (const auto& [name, shapes] : pool_.shapesByClass()) {
      for (const TrainingPool::Shape& shape : shapes) result.insert(shape.number);
    }
    return result;
  }

  TemporaryFolder folder_;
  TrainingPool pool_;
};

TEST_F(ToyPool, HasTheWorldsOfItsWindowAndNumbersShapesThroughAllWorlds) {
  pool_.load(0, 2);
  EXPECT_EQ(numbers(), (std::set<std::int64_t>{0, 1, 2, 3, 1000, 1001, 1002, 1003}));
  EXPECT_EQ(pool_.shapesByClass().at("couch").size(), 2u);
  EXPECT_EQ(pool_.shapesByClass().at("couch")[0].views.size(), 3u);
  pool_.load(1, 2);
  EXPECT_EQ(numbers(), (std::set<std::int64_t>{1000, 1001, 1002, 1003}));
}

TEST_F(ToyPool, DrawsClassesByWeight) {
  pool_.load(0, 2);
  std::map<std::string, int> counts;
  std::set<std::int64_t> shapes;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const TrainingSample sample =
        pool_.draw({{"bin", 0}, {"chair", 3}, {"couch", 0}, {"plant", 1}}, 5, true, Random(i));
    ++counts[sample.class_name];
    shapes.insert(sample.shape);
    EXPECT_EQ(sample.distances.size(), 5u);
  }
  EXPECT_EQ(counts.size(), 2u);
  EXPECT_NEAR(counts["chair"], 300, 40);
  EXPECT_EQ(shapes, (std::set<std::int64_t>{-1, 1, 1001}));  // plants have lost their own yaw
}

TEST_F(ToyPool, DrawsTheSameForTheSameNumbersAndStretchesOnlyWhenAsked) {
  pool_.load(0, 2);
  const std::map<std::string, double> weights = {{"bin", 1}, {"chair", 1}};
  bool stretched = false;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const TrainingSample a = pool_.draw(weights, 5, true, Random(i));
    const TrainingSample b = pool_.draw(weights, 5, true, Random(i));
    EXPECT_EQ(a.input.points, b.input.points);
    EXPECT_EQ(a.distances, b.distances);
    stretched |= a.augmented;
    EXPECT_FALSE(pool_.draw(weights, 5, false, Random(i)).augmented);
  }
  EXPECT_TRUE(stretched);
}

TEST_F(ToyPool, SaysWhichClassHasNoView) {
  pool_.load(0, 1);
  EXPECT_THAT(messageOf<InputError>([&] {
                pool_.draw({{"lamp", 1}}, 5, false, Random(1));
              }),
              ::testing::HasSubstr("no view of class 'lamp' in 1 training worlds"));
}

}  // namespace
}  // namespace hydrabench
