// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_world.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/campus_drive.h"
#include "eval/simulation/campus_labels.h"
#include "eval/simulation/sdf_queries.h"
#include "eval/simulation/simulated_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const CampusLayout& campus() {
  static const CampusLayout layout = layOutCampus({}, 1);
  return layout;
}

const SimulatedDataset& quickCampus() {
  static const SimulatedDataset dataset(SimulatedConfig::forWorld("campus_quick"));
  return dataset;
}

std::map<Label, int> countByLabel(const CampusLayout& layout) {
  std::map<Label, int> counts;
  for (const PlacedShape& object : layout.objects) ++counts[object.label];
  return counts;
}

int numScored(const CampusLayout& layout) {
  std::map<Label, int> counts = countByLabel(layout);
  return counts[campus_label::kFireHydrant] + counts[campus_label::kCar] +
         counts[campus_label::kBench];
}

Aabb worldBox(const PlacedShape& object) {
  const Aabb own = tightBounds(*object.shape->sdf);
  Aabb box;
  for (int i = 0; i < 8; ++i) {
    box.extend(object.T_world_object * own.corner(static_cast<Aabb::CornerType>(i)));
  }
  return box;
}

TEST(CampusLayout, HasTheScoredObjectsThatWereAskedForOfEverySeed) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const CampusLayout layout = layOutCampus({}, seed);
    const std::map<Label, int> counts = countByLabel(layout);
    EXPECT_EQ(counts.at(campus_label::kFireHydrant), 18) << "seed " << seed;
    EXPECT_EQ(counts.at(campus_label::kCar), 26) << "seed " << seed;
    EXPECT_EQ(counts.at(campus_label::kBench), 24) << "seed " << seed;
    EXPECT_GE(numScored(layout), 60);
    for (const Label label : {campus_label::kTree, campus_label::kLampPole, campus_label::kBollard,
                              campus_label::kSign}) {
      EXPECT_GE(counts.at(label), 4) << "seed " << seed << ", label " << int{label};
    }
  }
}

TEST(CampusLayout, NoTwoObjectsTouch) {
  const std::vector<PlacedShape>& objects = campus().objects;
  std::vector<Aabb> boxes;
  for (const PlacedShape& object : objects) boxes.push_back(worldBox(object));
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[i].intersects(boxes[j])) continue;
      EXPECT_FALSE(
          interpenetrate({objects[i].shape->sdf.get(), objects[i].T_world_object, boxes[i]},
                         {objects[j].shape->sdf.get(), objects[j].T_world_object, boxes[j]}, 0))
          << objects[i].shape->family << " and " << objects[j].shape->family;
    }
  }
}

/// Height of the lowest point of the shape above the ground, over a grid of places below it.
double gapBelow(const PlacedShape& object, const CampusTerrain& terrain) {
  const Aabb box = tightBounds(*object.shape->sdf);
  constexpr int kSteps = 60;
  double gap = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Vector3d on_grid(box.min().x() + box.sizes().x() * i / kSteps,
                             box.min().y() + box.sizes().y() * j / kSteps, 0);
      // Upwards from the ground until the shape begins.
      const Vector3d p = object.T_world_object * on_grid;
      const double ground = terrain.heightAt(p.head<2>());
      const Transform T_object_world = object.T_world_object.inverse();
      double up = -0.05;
      for (int k = 0; k < 60 && up < 0.3; ++k) {
        const double distance =
            object.shape->sdf->value(T_object_world * Vector3d(p.x(), p.y(), ground + up));
        if (distance < 1e-4) break;
        up += distance;
      }
      gap = std::min(gap, up);
    }
  }
  return gap;
}

TEST(CampusLayout, EveryScoredObjectStandsOnTheGroundWithinACentimetre) {
  const CampusLayout& layout = campus();
  std::vector<double> gaps(layout.objects.size(), 0);
  parallelFor(gaps.size(),
              [&](std::size_t i) { gaps[i] = gapBelow(layout.objects[i], layout.terrain); });
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Label label = layout.objects[i].label;
    if (label != campus_label::kFireHydrant && label != campus_label::kCar &&
        label != campus_label::kBench) {
      continue;
    }
    EXPECT_NEAR(gaps[i], 0, 0.01) << layout.objects[i].shape->family << " at "
                                  << layout.objects[i].T_world_object.translation().transpose();
  }
}

TEST(CampusLayout, CarsLeanWithTheRoadAndEverythingElseIsUpright) {
  double most = 0;
  for (const PlacedShape& object : campus().objects) {
    const Vector3d up = object.T_world_object.linear().col(2);
    if (object.label != campus_label::kCar) {
      EXPECT_EQ(up, Vector3d::UnitZ());
      continue;
    }
    const Vector2d place = object.T_world_object.translation().head<2>();
    const Vector2d slope = campus().terrain.baseSlopeAt(place);
    // Wheels bridge where the hill curves.
    EXPECT_NEAR((up - Vector3d(-slope.x(), -slope.y(), 1).normalized()).norm(), 0, 0.006);
    most = std::max(most, slope.norm());
  }
  EXPECT_GT(most, 0.05) << "no car on a hill";
}

TEST(CampusLayout, LeavesTheWayFree) {
  const CampusLayout& layout = campus();
  const double length = layout.way.to_m - layout.way.from_m;
  EXPECT_GE(length, 250);
  for (const PlacedShape& object : layout.objects) {
    const Aabb box = worldBox(object);
    const Transform T_object_world = object.T_world_object.inverse();
    for (double s = 0; s < length; s += 0.05) {
      const Vector2d p =
          layout.terrain.loop().along(layout.way.from_m + s, CampusWay::kOffset_m).point;
      if (box.exteriorDistance(Vector3d(p.x(), p.y(), box.center().z())) > 1) continue;
      for (const double up : {0.15, 0.4, 0.8, 1.2}) {
        const Vector3d at(p.x(), p.y(), layout.terrain.heightAt(p) + up);
        ASSERT_GE(object.shape->sdf->value(T_object_world * at), CampusWay::kClearance_m)
            << object.shape->family;
      }
    }
  }
}

TEST(CampusLayout, IsAFunctionOfItsSeed) {
  const auto same = [](const CampusLayout& a, const CampusLayout& b) {
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const PlacedShape& x, const PlacedShape& y) {
                        return x.shape->family == y.shape->family &&
                               x.T_world_object.matrix() == y.T_world_object.matrix();
                      });
  };
  const CampusConfig quick = CampusConfig::quick();
  EXPECT_TRUE(same(layOutCampus(quick, 5), layOutCampus(quick, 5)));
  EXPECT_FALSE(same(layOutCampus(quick, 5), layOutCampus(quick, 6)));
  EXPECT_NE(campusTerrain(5).terrace().min(), campusTerrain(6).terrace().min());
}

TEST(CampusLabels, GroundIsRoadSidewalkGrassAndStairs) {
  EXPECT_THAT(campusLabelSpace().groundNames(),
              testing::ElementsAre("road", "sidewalk", "grass", "stairs"));
}

TEST(QuickCampus, ShowsEveryFeatureAndTenScoredObjects) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    const CampusLayout layout = layOutCampus(CampusConfig::quick(), seed);
    EXPECT_GE(numScored(layout), 10) << "seed " << seed;
    EXPECT_NEAR(layout.way.to_m - layout.way.from_m, 40, 1e-9);
    std::map<TerrainFeature, int> seen;  // within 6 m of the way
    for (double s = layout.way.from_m; s < layout.way.to_m; s += 0.5) {
      const CampusLoop::Station at = layout.terrain.loop().along(s, CampusWay::kOffset_m);
      for (double across = -6; across < 6; across += 0.25) {
        ++seen[layout.terrain.featureAt(at.point + across * at.out)];
      }
    }
    EXPECT_EQ(seen.size(), kTerrainFeatures.size()) << "seed " << seed;
  }
}

TEST(QuickCampus, CameraFollowsTheGroundAtItsHeight) {
  const SimulatedDataset& dataset = quickCampus();
  ASSERT_EQ(dataset.numFrames(), 300u);
  const CampusTerrain& terrain = *dataset.terrain();
  double most_lean = 0;
  for (const StampedPose& pose : dataset.trajectory()) {
    const Vector3d eye = pose.T_world_camera.translation();
    EXPECT_NEAR(eye.z() - terrain.heightAt(eye.head<2>()), 0.55, 0.01);
    EXPECT_LT(std::abs(terrain.loop().offsetOf(eye.head<2>()) - CampusWay::kOffset_m), 0.06);
    // Roll of the image: its x axis leaves the horizon on a slope.
    most_lean = std::max(most_lean, std::abs(pose.T_world_camera.linear()(2, 0)));
  }
  EXPECT_GT(most_lean, 0.01);
  EXPECT_LT(most_lean, 0.12);
}

TEST(QuickCampus, DrivesItsWayWithoutJumps) {
  const std::vector<StampedPose>& path = quickCampus().trajectory();
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step =
        (path[i].T_world_camera.translation() - path[i - 1].T_world_camera.translation()).norm();
    length += step;
    EXPECT_LE(step, 0.17);
    EXPECT_LE(rotationAngle(path[i].T_world_camera.linear(), path[i - 1].T_world_camera.linear()),
              6.0 / 180 * std::numbers::pi);
  }
  EXPECT_NEAR(length, 40, 1);
}

TEST(QuickCampus, DepthEndsWhereStereoFailsAndTheSkyHasNone) {
  const SimulatedDataset& dataset = quickCampus();
  const Transform& pose = dataset.trajectory()[150].T_world_camera;
  RgbdSensorConfig sensor = RgbdSensorConfig::clean();
  useOutdoorCamera(sensor);
  const RenderedView view = dataset.renderer().render(sensor.camera, pose);
  const Frame frame = observe(dataset.scene(), dataset.renderer(), pose, sensor, 1, 150);
  int sky = 0;
  int far = 0;
  for (int v = 0; v < frame.depth.height(); ++v) {
    for (int u = 0; u < frame.depth.width(); ++u) {
      const float true_depth = view.depth(u, v);
      sky += true_depth == 0;
      far += true_depth > 6;
      EXPECT_EQ(frame.depth(u, v) > 0, true_depth >= 0.4f && true_depth <= 6);
      if (true_depth == 0) {
        EXPECT_EQ(view.labels(u, v), kUnknownLabel);
      }
    }
  }
  EXPECT_GT(sky, 1000);
  EXPECT_GT(far, 1000);
  // Depth errors grow with the square of the depth.
  EXPECT_EQ(dataset.camera(), sensor.camera);
  const DepthNoiseConfig noise = SimulatedConfig::forWorld("campus").sensor.depth_noise;
  EXPECT_NEAR(axialSigma(noise, 6) - noise.axial_constant_m,
              9 * (axialSigma(noise, 2) - noise.axial_constant_m), 1e-9);
  EXPECT_GT(axialSigma(noise, 6), 0.06);
}

TEST(QuickCampus, SunCastsShadows) {
  // A place on the open road is lit; below a car it is not, though the same colour.
  const SimulatedDataset& dataset = quickCampus();
  const Scene& scene = dataset.scene();
  ASSERT_TRUE(scene.sun);
  const auto car = std::find_if(scene.objects.begin(), scene.objects.end(), [](const auto& object) {
    return object.label == campus_label::kCar;
  });
  ASSERT_NE(car, scene.objects.end());
  const Vector3d below = car->T_world_object.translation() + Vector3d(0, 0, 0.02);
  const Raycaster::Ray to_sun{below.cast<float>(), scene.sun->to_sun.cast<float>()};
  EXPECT_TRUE(dataset.renderer().raycaster().intersect(to_sun));
  EXPECT_NEAR(scene.sun->to_sun.norm(), 1, 1e-12);
  EXPECT_GT(scene.sun->to_sun.z(), 0.5);
}

TEST(QuickCampus, GroundTruthHoldsWhatIsSeen) {
  const GroundTruth& truth = quickCampus().groundTruth();
  int well_seen = 0;
  for (const GroundTruthObject& object : truth.objects) {
    if (object.scored && object.visible_fraction > 0.1) ++well_seen;
  }
  EXPECT_GE(well_seen, 10);
  EXPECT_FALSE(truth.scene_mesh.empty());
}

TEST(CampusDrive, SaysWhenTheTimeIsTooShort) {
  SimulatedConfig config = SimulatedConfig::forWorld("campus_quick");
  config.campus.cars = config.campus.hydrants = config.campus.benches = 0;
  config.trajectory.duration_s = 20;
  EXPECT_THAT(messageOf<InputError>([&] { SimulatedDataset dataset(config); }),
              testing::HasSubstr("trajectory.duration_s: 20 s are too short, a way of 40 m"));
}

TEST(SimulatedConfig, CampusHasItsOwnSectionAndTheOfficeKeepsIts) {
  const auto resolved = [](const std::string& yaml) {
    ConfigReader reader(ConfigDocument::fromString(yaml, "campus.yaml"));
    SimulatedConfig config;
    read(reader, config);
    reader.finish();
    return reader.resolved();
  };
  EXPECT_THAT(resolved("world: campus"), testing::HasSubstr("hydrants: 18"));
  EXPECT_THAT(resolved("world: campus"), testing::Not(testing::HasSubstr("chairs")));
  EXPECT_THAT(resolved("{}"), testing::Not(testing::HasSubstr("hydrants")));
  EXPECT_THAT(messageOf<InputError>([&] { resolved("{world: campus, office: {chairs: 3}}"); }),
              testing::HasSubstr("office"));
}

}  // namespace
}  // namespace hydrabench
