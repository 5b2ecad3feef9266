// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// Mesh files, each alone in a room, and a camera that goes around one after the other: views of
/// shapes that nothing here was made from.
struct MeshGalleryConfig {
  struct Item {
    std::string file;   ///< below the folder
    std::string label;  ///< name of a class; those the office does not have are added
  };
  std::filesystem::path folder;
  std::vector<Item> items;
  int views = 24;                ///< of each mesh, all around it, 0.1 s apart
  double distance_factor = 1.6;  ///< of the camera from the middle, times the box diagonal
  double min_distance_m = 1.2;
  double camera_height_m = 0.8;   ///< above the floor, for meshes up to this height ...
  double min_elevation_deg = 10;  ///< ... and at least this far above the horizon of the middle
};
void read(ConfigReader& reader, MeshGalleryConfig& config);

/// Throws InputError naming the file at fault.
Scene makeMeshGalleryScene(const MeshGalleryConfig& config);
/// Poses around every object in order.
std::vector<StampedPose> makeGalleryTrajectory(const Scene& scene, const MeshGalleryConfig& config);

DatasetConfig readMeshGallery(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench
