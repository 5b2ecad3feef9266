// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_traffic.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/campus_labels.h"
#include "eval/simulation/sdf_queries.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SimulatedConfig movingCampus(int cars, int pedestrians, const std::string& preset = "default") {
  SimulatedConfig config = SimulatedConfig::forWorld("campus_quick", preset);
  config.campus.movers = {cars, pedestrians};
  config.sensor.camera = {160, 120, 93.1, 93.1, 80, 60};
  config.lidar.enabled = true;
  config.lidar.labels = true;
  return config;
}

constexpr int kCars = 3;
constexpr int kPeople = 16;

const SimulatedDataset& moving() {
  static const SimulatedDataset dataset(movingCampus(kCars, kPeople, "clean"));
  return dataset;
}
const SimulatedDataset& still() {
  static const SimulatedDataset dataset(movingCampus(0, 0, "clean"));
  return dataset;
}

bool isCar(const Mover& mover) { return mover.label == campus_label::kCar; }

/// Of all parts where they are at a time, world frame.
std::vector<Vector3d> verticesAt(const Mover& mover, std::int64_t stamp_ns) {
  std::vector<Vector3d> vertices;
  for (const Mover::Part& part : mover.parts) {
    const Transform pose = poseAt(part.poses, stamp_ns).value();
    for (const Vector3d& vertex : part.surface->mesh.vertices) vertices.push_back(pose * vertex);
  }
  return vertices;
}

/// Times all over the drive, most of them between two poses.
std::vector<std::int64_t> someTimes() {
  std::vector<std::int64_t> times;
  for (std::int64_t i = 0; i < 12; ++i) times.push_back(i * 2'531'000'000);
  return times;
}

TEST(CampusTraffic, HasTheMoversThatWereAskedForAndTheClassOfPeople) {
  const Scene& scene = moving().scene();
  EXPECT_EQ(std::count_if(scene.movers.begin(), scene.movers.end(), isCar), kCars);
  EXPECT_EQ(scene.movers.size(), static_cast<std::size_t>(kCars + kPeople));
  const LabelSpace::Entry* human = scene.label_space.find("human");
  ASSERT_TRUE(human);
  EXPECT_FALSE(human->is_object);
  EXPECT_FALSE(human->is_ground);
  for (const Mover& mover : scene.movers) {
    EXPECT_EQ(mover.label, isCar(mover) ? campus_label::kCar : human->label);
  }
  EXPECT_EQ(moving().name(), "campus_quick_moving_clean");
  EXPECT_EQ(still().name(), "campus_quick_clean");
  EXPECT_FALSE(still().labelSpace().find("human"));
}

TEST(CampusTraffic, CarsDriveAndPeopleWalkAtTheirSpeeds) {
  for (const Mover& mover : moving().scene().movers) {
    const std::vector<TimedPose>& poses = mover.parts.front().poses;
    ASSERT_GE(poses.back().stamp_ns, moving().trajectory().back().stamp_ns);
    ASSERT_EQ(poses.front().stamp_ns, 0);
    for (std::size_t i = 10; i < poses.size(); i += 10) {
      const Vector3d way =
          poses[i].T_world_body.translation() - poses[i - 10].T_world_body.translation();
      const double speed =
          way.norm() / (1e-9 * static_cast<double>(poses[i].stamp_ns - poses[i - 10].stamp_ns));
      ASSERT_GE(speed, isCar(mover) ? 3 : 0.8) << mover.name;
      ASSERT_LE(speed, isCar(mover) ? 8 : 1.8) << mover.name;
      // Forwards.
      ASSERT_GT(poses[i].T_world_body.linear().col(0).dot(way.normalized()), 0.95) << mover.name;
    }
  }
}

TEST(CampusTraffic, EverybodyStaysOnTheGround) {
  const CampusTerrain& terrain = *moving().terrain();
  for (const Mover& mover : moving().scene().movers) {
    for (const std::int64_t time : someTimes()) {
      double lowest = 10;
      for (const Vector3d& p : verticesAt(mover, time)) {
        lowest = std::min(lowest, p.z() - terrain.heightAt(p.head<2>()));
        const double offset = terrain.loop().offsetOf(p.head<2>());
        // Cars on the road, people on the pavements, but for what they swing over the edge.
        if (isCar(mover)) {
          ASSERT_LT(std::abs(offset), CampusTerrain::kRoadHalfWidth_m) << mover.name;
        } else {
          ASSERT_GT(std::abs(offset), CampusTerrain::kRoadHalfWidth_m) << mover.name;
          ASSERT_LT(std::abs(offset),
                    CampusTerrain::kRoadHalfWidth_m + CampusTerrain::kPavementWidth_m);
        }
      }
      EXPECT_GT(lowest, -0.03) << mover.name << " at " << time;
      EXPECT_LT(lowest, 0.03) << mover.name << " at " << time;
    }
  }
}

TEST(CampusTraffic, NobodyComesNearTheRobotsWay) {
  const CampusTerrain& terrain = *moving().terrain();
  double nearest = 10;
  for (const Mover& mover : moving().scene().movers) {
    for (const std::int64_t time : someTimes()) {
      for (const Vector3d& p : verticesAt(mover, time)) {
        nearest = std::min(nearest,
                           std::abs(terrain.loop().offsetOf(p.head<2>()) - CampusWay::kOffset_m));
      }
    }
  }
  EXPECT_GT(nearest, CampusWay::kClearance_m);
  EXPECT_LT(nearest, 1.0);  // there are people on the inner pavement
}

TEST(CampusTraffic, NobodyRunsIntoWhatStands) {
  const Scene& scene = moving().scene();
  std::vector<PlacedSdf> standing;
  for (const SceneObject& object : scene.objects) {
    standing.push_back({object.shape->sdf.get(), object.T_world_object, worldBounds(object)});
  }
  for (const Mover& mover : scene.movers) {
    for (const std::int64_t time : someTimes()) {
      for (const Vector3d& p : verticesAt(mover, time)) {
        for (const PlacedSdf& object : standing) {
          if (!object.box.contains(p)) continue;
          ASSERT_GT(object.sdf->value(object.T_world_sdf.inverse() * p), 0) << mover.name;
        }
      }
    }
  }
}

TEST(CampusTraffic, NobodyRunsIntoAnother) {
  constexpr double kNear_m = 7;
  for (const std::int64_t time : someTimes()) {
    const std::vector<Mover>& movers = moving().scene().movers;
    const auto poseOf = [&](const Mover& mover) {
      return poseAt(mover.parts.front().poses, time).value();
    };
    for (const Mover& mover : movers) {
      const Transform T_mover_world = poseOf(mover).inverse();
      Aabb box;
      for (const Vector3d& p : verticesAt(mover, time)) box.extend(T_mover_world * p);
      for (const Mover& other : movers) {
        const Vector3d between = T_mover_world * poseOf(other).translation();
        if (&other == &mover || between.norm() > kNear_m) continue;
        for (const Vector3d& p : verticesAt(other, time)) {
          ASSERT_FALSE(box.contains(T_mover_world * p)) << mover.name << " " << other.name;
        }
      }
    }
  }
}

TEST(CampusTraffic, ChangesNothingButWhatIsSeenOfIt) {
  // Same drive, same truth; a pixel or point that shows no mover is what it is without them.
  const GroundTruth& with = moving().groundTruth();
  const GroundTruth& without = still().groundTruth();
  ASSERT_EQ(with.objects.size(), without.objects.size());
  for (std::size_t i = 0; i < with.objects.size(); ++i) {
    EXPECT_EQ(with.objects[i].name, without.objects[i].name);
    EXPECT_EQ(with.objects[i].visible_fraction, without.objects[i].visible_fraction);
  }
  EXPECT_EQ(with.scene_mesh.vertices, without.scene_mesh.vertices);
  EXPECT_EQ(with.scene_labels, without.scene_labels);

  std::size_t on_movers = 0;
  const auto first_mover = static_cast<std::int32_t>(moving().scene().objects.size());
  for (std::size_t index = 0; index < moving().numFrames(); index += 15) {
    const StampedPose& pose = moving().trajectory()[index];
    ASSERT_EQ(pose.T_world_camera.matrix(), still().trajectory()[index].T_world_camera.matrix());
    const RenderedView a =
        moving().renderer().render(moving().camera(), pose.T_world_camera, pose.stamp_ns);
    const RenderedView b = still().renderer().render(still().camera(), pose.T_world_camera);
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
      if (a.objects.data()[i] >= first_mover) {
        ++on_movers;
        const float behind = b.depth.data()[i];
        ASSERT_TRUE(behind == 0 || a.depth.data()[i] < behind);
        continue;
      }
      ASSERT_EQ(a.depth.data()[i], b.depth.data()[i]);
      ASSERT_EQ(a.labels.data()[i], b.labels.data()[i]);
      ASSERT_EQ(a.objects.data()[i], b.objects.data()[i]);
    }
  }
  EXPECT_GT(on_movers, 500u);
}

TEST(CampusTraffic, IsSeenInFramesAndSweepsTheSameForAnyNumberOfThreads) {
  const auto framesOf = [](int num_threads) {
    setNumThreads(num_threads);
    const SimulatedDataset dataset(movingCampus(2, 20));
    std::vector<Frame> frames;
    for (const std::size_t index : {20u, 150u, 280u}) frames.push_back(dataset.frame(index));
    setNumThreads(0);
    return frames;
  };
  const std::vector<Frame> one = framesOf(1);
  const std::vector<Frame> many = framesOf(5);
  std::size_t on_humans = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].color, many[i].color);
    EXPECT_EQ(one[i].depth, many[i].depth);
    EXPECT_EQ(one[i].labels, many[i].labels);
    EXPECT_EQ(one[i].instances, many[i].instances);
    EXPECT_EQ(one[i].instance_labels, many[i].instance_labels);
    ASSERT_EQ(one[i].scans.size(), 1u);
    EXPECT_EQ(one[i].scans[0].points, many[i].scans[0].points);
    EXPECT_EQ(one[i].scans[0].labels, many[i].scans[0].labels);
    const std::vector<Label>& labels = one[i].scans[0].labels;
    on_humans +=
        static_cast<std::size_t>(std::count(labels.begin(), labels.end(), campus_label::kHuman));
  }
  EXPECT_GT(on_humans, 50u);
}

std::string faultsOf(const std::string& movers) {
  ConfigReader reader(ConfigDocument::fromString(
      "world: campus\ncampus: {movers: " + movers + "}\n", "moving.yaml"));
  SimulatedConfig config;
  try {
    read(reader, config);
    reader.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CampusTraffic, BadNumbersOfMoversAreOneLineEach) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  EXPECT_EQ(faultsOf("{cars: 16, pedestrians: 120}"), "");
  EXPECT_THAT(faultsOf("{cars: 17}"),
              AllOf(HasSubstr("moving.yaml:2"), HasSubstr("campus.movers.cars"), HasSubstr("16")));
  EXPECT_THAT(faultsOf("{pedestrians: -1}"), HasSubstr("campus.movers.pedestrians"));
  EXPECT_THAT(faultsOf("{pedestrian: 3}"), HasSubstr("pedestrians"));
  EXPECT_THAT(faultsOf("7"), HasSubstr("campus.movers"));
  for (const char* bad : {"{cars: 17}", "{pedestrian: 3}", "7"}) {
    const std::string faults = faultsOf(bad);
    EXPECT_EQ(std::count(faults.begin(), faults.end(), '\n'), 0) << faults;
  }
}

}  // namespace
}  // namespace hydrabench
