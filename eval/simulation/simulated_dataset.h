// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/simulation/campus_world.h"
#include "eval/simulation/odometry_drift.h"
#include "eval/simulation/office_world.h"
#include "eval/simulation/rgbd_sensor.h"
#include "eval/simulation/simulated_lidar.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {

/// A generated world, a drive through it and a sensor. `preset` (clean, default, hard) sets how
/// much goes wrong; any key of the sections overrides it.
struct SimulatedConfig {
  std::string world = "office";
  std::string preset = "default";
  std::uint64_t seed = 1;  ///< of everything: rooms, furniture, noise
  OfficeConfig office;     ///< of the worlds "office" and "quick"
  CampusConfig campus;     ///< of the worlds "campus" and "campus_quick"
  TrajectoryConfig trajectory;
  RgbdSensorConfig sensor;
  OdometryDriftConfig odometry;
  LidarSensorConfig lidar;  ///< off by default

  /// @param world   "office" (2000 frames) or "quick" (two rooms and a corridor, 300 frames);
  ///                "campus" (2300 frames) or "campus_quick" (40 m of its way, 300 frames)
  /// @param preset  "clean", "default" or "hard"
  static SimulatedConfig forWorld(const std::string& world, const std::string& preset = "default");
  std::string name() const;  ///< of the dataset: "office_quick_hard"
  bool isOutdoors() const { return world == "campus" || world == "campus_quick"; }
};
void read(ConfigReader& reader, SimulatedConfig& config);

/// Renders frames when they are asked for: a sequence costs no memory beyond its scene. Frames in
/// any order, from several threads.
class SimulatedDataset : public Dataset {
 public:
  explicit SimulatedDataset(const SimulatedConfig& config);
  /// A scene made elsewhere, along a given path.
  SimulatedDataset(std::string name, std::shared_ptr<const Scene> scene,
                   std::vector<StampedPose> trajectory, const RgbdSensorConfig& sensor,
                   const OdometryDriftConfig& odometry, std::uint64_t seed);
  /// Frames carry scans from now on. Nothing else in them changes.
  void mountLidar(const LidarSensorConfig& config, const Transform& T_body_camera);

  std::string name() const override { return name_; }
  std::uint64_t seed() const override { return seed_; }
  const LabelSpace& labelSpace() const override { return scene_->label_space; }
  const Camera& camera() const override { return sensor_.camera; }
  std::size_t numFrames() const override { return trajectory_.size(); }
  Frame frame(std::size_t index) const override;
  /// Visible fractions and the scene mesh are computed on the first call (seconds).
  const GroundTruth& groundTruth() const override;

  const Scene& scene() const { return *scene_; }
  /// Ground with its exact heights and features; null indoors and for scenes made elsewhere.
  const CampusTerrain* terrain() const { return terrain_ ? &*terrain_ : nullptr; }
  const RgbdRenderer& renderer() const { return renderer_; }
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }

 private:
  std::string name_;
  std::shared_ptr<const Scene> scene_;
  std::optional<CampusTerrain> terrain_;
  RgbdRenderer renderer_;
  std::vector<StampedPose> trajectory_;  ///< true
  std::vector<Transform> reported_poses_;
  RgbdSensorConfig sensor_;
  std::optional<SimulatedLidar> lidar_;
  std::uint64_t seed_;
  mutable std::once_flag ground_truth_once_;
  mutable GroundTruth ground_truth_;
};

}  // namespace hydrabench
