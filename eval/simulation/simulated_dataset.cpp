// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/simulated_dataset.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "eval/simulation/campus_drive.h"
#include "eval/simulation/campus_traffic.h"
#include "eval/simulation/visibility.h"

namespace hydrabench {
namespace {

// Streams of the world's seed.
constexpr std::uint64_t kSensorStream = 101;
constexpr std::uint64_t kOdometryStream = 102;
constexpr std::uint64_t kLidarStream = 103;

constexpr std::size_t kVisibilityFrames = 500;  // of the trajectory are looked at, evenly spread
constexpr std::size_t kVisibilityPoints = 400;  // per object: a fraction is known to about 2.5 %

std::shared_ptr<const Scene> makeWorld(const SimulatedConfig& config) {
  if (!config.isOutdoors()) {
    return std::make_shared<const Scene>(makeOffice(config.office, config.seed));
  }
  auto scene = std::make_shared<Scene>(makeCampus(config.campus, config.seed));
  const auto end_ns = static_cast<std::int64_t>(std::ceil(1e9 * config.trajectory.duration_s));
  if (config.campus.movers.any()) addCampusTraffic(config.campus, config.seed, end_ns, *scene);
  return scene;
}

std::vector<StampedPose> driveThrough(const SimulatedConfig& config, const Scene& scene,
                                      const CampusTerrain* terrain, const Raycaster& raycaster) {
  const Camera& camera = config.sensor.camera;
  if (!terrain) return makeTrajectory(scene, raycaster, camera, config.trajectory);
  return driveThroughCampus(scene, *terrain, campusWay(config.campus, *terrain), raycaster, camera,
                            config.trajectory);
}

/// A robot the size of a Jackal.
TrajectoryConfig campusDrive(bool quick) {
  TrajectoryConfig config;
  config.duration_s = quick ? 30 : 230;
  config.camera_height_m = 0.55;
  config.camera_pitch_deg = 4;
  config.robot_radius_m = 0.35;
  config.max_speed_m_s = 1.6;
  config.max_yaw_rate_deg_s = 35;
  return config;
}

}  // namespace

SimulatedConfig SimulatedConfig::forWorld(const std::string& world, const std::string& preset) {
  SimulatedConfig config;
  config.world = world;
  config.preset = preset;
  if (config.isOutdoors()) {
    const bool quick = world == "campus_quick";
    if (quick) config.campus = CampusConfig::quick();
    config.trajectory = campusDrive(quick);
  }
  if (world == "quick") {
    config.office = OfficeConfig::quick();
    config.trajectory.duration_s = 30;
  }
  config.lidar = LidarSensorConfig::forPattern(config.lidar.pattern, preset);
  if (preset == "clean") config.sensor = RgbdSensorConfig::clean();
  if (preset == "hard") {
    config.sensor = RgbdSensorConfig::hard();
    config.odometry.translation_m_per_sqrt_m = 0.01;
    config.odometry.yaw_deg_per_sqrt_m = 0.15;
  }
  if (config.isOutdoors()) useOutdoorCamera(config.sensor);
  return config;
}

void read(ConfigReader& reader, SimulatedConfig& config) {
  std::string world = config.world;
  std::string preset = config.preset;
  reader.choice("world", world, {"office", "quick", "campus", "campus_quick"});
  reader.choice("preset", preset, {"clean", "default", "hard"});
  const std::uint64_t seed = config.seed;
  config = SimulatedConfig::forWorld(world, preset);
  config.seed = seed;
  reader.field("seed", config.seed);
  if (config.isOutdoors()) {
    ConfigReader campus = reader.section("campus");
    read(campus, config.campus);
  } else {
    ConfigReader office = reader.section("office");
    read(office, config.office);
  }
  ConfigReader trajectory = reader.section("trajectory");
  read(trajectory, config.trajectory);
  read(reader, config.sensor);
  ConfigReader odometry = reader.section("odometry");
  read(odometry, config.odometry);
  ConfigReader lidar = reader.section("lidar");
  read(lidar, preset, config.lidar);
}

std::string SimulatedConfig::name() const {
  std::string place = world == "quick" ? "office_quick" : world;
  if (isOutdoors() && campus.movers.any()) place += "_moving";
  return preset == "default" ? place : place + "_" + preset;
}

SimulatedDataset::SimulatedDataset(const SimulatedConfig& config)
    : name_(config.name()),
      scene_(makeWorld(config)),
      terrain_(config.isOutdoors() ? std::optional(campusTerrain(config.seed)) : std::nullopt),
      renderer_(scene_),
      trajectory_(driveThrough(config, *scene_, terrain(), renderer_.raycaster())),
      reported_poses_(
          driftedPoses(trajectory_, config.odometry, hashSeed(config.seed, kOdometryStream))),
      sensor_(config.sensor),
      seed_(config.seed) {
  if (!config.lidar.enabled) return;
  const TrajectoryConfig& drive = config.trajectory;
  mountLidar(config.lidar, cameraOnBody(drive.camera_height_m, drive.camera_pitch_deg));
}

SimulatedDataset::SimulatedDataset(std::string name, std::shared_ptr<const Scene> scene,
                                   std::vector<StampedPose> trajectory,
                                   const RgbdSensorConfig& sensor,
                                   const OdometryDriftConfig& odometry, std::uint64_t seed)
    : name_(std::move(name)),
      scene_(std::move(scene)),
      renderer_(scene_),
      trajectory_(std::move(trajectory)),
      reported_poses_(driftedPoses(trajectory_, odometry, hashSeed(seed, kOdometryStream))),
      sensor_(sensor),
      seed_(seed) {}

void SimulatedDataset::mountLidar(const LidarSensorConfig& config, const Transform& T_body_camera) {
  lidar_.emplace(config, trajectory_, reported_poses_, T_body_camera,
                 hashSeed(seed_, kLidarStream));
}

Frame SimulatedDataset::frame(std::size_t index) const {
  assert(index < trajectory_.size());
  const StampedPose& pose = trajectory_[index];
  Frame frame = observe(*scene_, renderer_, pose.T_world_camera, sensor_,
                        hashSeed(seed_, kSensorStream), index, pose.stamp_ns);
  frame.T_world_camera = reported_poses_[index];
  if (lidar_) frame.scans = lidar_->scansOf(renderer_, index);
  return frame;
}

const GroundTruth& SimulatedDataset::groundTruth() const {
  std::call_once(ground_truth_once_, [this] {
    const std::size_t stride = std::max<std::size_t>(1, trajectory_.size() / kVisibilityFrames);
    const std::vector<double> visible =
        visibleFractions(*scene_, renderer_.raycaster(), sensor_.camera, trajectory_,
                         sensor_.min_depth_m, sensor_.max_depth_m, stride, kVisibilityPoints);
    for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
      const SceneObject& object = scene_->objects[i];
      GroundTruthObject truth;
      truth.id = i + 1;
      truth.label = object.label;
      truth.name = object.name;
      truth.subtype = object.subtype;
      truth.room = object.room;
      truth.T_world_object = object.T_world_object;
      // Shares the mesh with the scene.
      truth.mesh = std::shared_ptr<const Mesh>(object.surface, &object.surface->mesh);
      truth.visible_fraction = visible[i];
      truth.scored = object.scored;
      ground_truth_.objects.push_back(std::move(truth));
    }
    ground_truth_.scene_mesh =
        mergedMesh(*scene_, /*with_overhead=*/true, &ground_truth_.scene_labels);
    roundToFloat(ground_truth_.scene_mesh);  // what a file of it would hold
    ground_truth_.rooms = scene_->rooms;
    ground_truth_.trajectory = trajectory_;
  });
  return ground_truth_;
}

}  // namespace hydrabench
