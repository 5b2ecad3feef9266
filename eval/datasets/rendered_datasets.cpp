// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/rendered_datasets.h"

#include "eval/datasets/dataset_config.h"
#include "eval/datasets/placed_meshes_scene.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace fs = std::filesystem;

DatasetConfig readSimulated(ConfigReader& reader, const fs::path&) {
  SimulatedConfig config;
  read(reader, config);
  reader.finish();
  return {.name = config.name(), .seed = config.seed, .generated = true, .open = [config] {
            return std::make_unique<SimulatedDataset>(config);
          }};
}

DatasetConfig readPlacedMeshes(ConfigReader& reader, const fs::path&) {
  PlacedMeshesConfig meshes;
  std::string name = "placed_meshes";
  std::string scene_file;
  std::string preset = "default";
  std::uint64_t seed = 1;
  const fs::path root = readDataRoot(reader);
  reader.field("name", name);
  reader.require("scene");
  reader.field("scene", scene_file);
  reader.choice("preset", preset, {"clean", "default", "hard"});
  reader.field("seed", seed);
  read(reader, meshes);

  SimulatedConfig config = SimulatedConfig::forWorld("office", preset);
  ConfigReader trajectory = reader.section("trajectory");
  read(trajectory, config.trajectory);
  read(reader, config.sensor);
  ConfigReader odometry = reader.section("odometry");
  read(odometry, config.odometry);
  ConfigReader lidar = reader.section("lidar");
  read(lidar, preset, config.lidar);
  reader.finish();

  meshes.scene = root / scene_file;
  const auto open = [=] {
    const auto scene = std::make_shared<const Scene>(makePlacedMeshesScene(meshes));
    const RgbdRenderer::Config no_color{.with_color = false};
    std::vector<StampedPose> path = makeTrajectory(
        *scene, RgbdRenderer(scene, no_color).raycaster(), config.sensor.camera, config.trajectory);
    auto dataset = std::make_unique<SimulatedDataset>(name, scene, std::move(path), config.sensor,
                                                      config.odometry, seed);
    if (config.lidar.enabled) {
      dataset->mountLidar(config.lidar, cameraOnBody(config.trajectory.camera_height_m,
                                                     config.trajectory.camera_pitch_deg));
    }
    return dataset;
  };
  // The meshes stand beside the scene's file.
  return {.name = name,
          .seed = seed,
          .generated = true,
          .files = {meshes.scene.parent_path()},
          .open = open};
}

}  // namespace hydrabench
