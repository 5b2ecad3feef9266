// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/shape/crisp/object_points.h"
#include "core/shape/crisp/point_input.h"
#include "eval/simulation/office_world.h"
#include "eval/simulation/shape_family.h"
#include "eval/simulation/street_block.h"

namespace hydrabench {

/// The distance field of a shape around one of the frames that a shape may be estimated in: near
/// its own, as an estimated pose is.
struct ShapeGrid {
  LocalFrame frame;                 ///< in object coordinates
  std::vector<std::int8_t> values;  ///< as quantizedDistance() of distances in the frame's units,
                                    ///< kGridSide^3, x fastest (core/shape/latent_flow)
};

/// One instance of a shape family as training data.
///
/// Object coordinates: upright, origin at the centre of the box, the largest half extent is 1.
/// Instances that have no front (plants, round bins) turn about their axis at will; their half
/// extent is the larger of half their height and their radius.
struct TrainingShape {
  std::string family;
  std::string class_name;
  int yaw_symmetry = 1;  ///< looks the same every 360/n degrees; 0: has no front
  float half_extent_m = 0;
  std::vector<Eigen::Vector3f> points;  ///< near the surface and all over the cube
  std::vector<float> distances;         ///< at `points`, in object coordinates
  std::vector<ShapeGrid> grids;         ///< TrainingWorldConfig::grid_frames of them
};

/// One instance seen from one place.
struct TrainingView {
  std::uint32_t shape = 0;                           ///< index into the shapes of its world
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< of the object's box, level frame [m]
  float yaw = 0;                                     ///< of the object in the level frame [rad]
  bool clean = false;                                ///< the mask is exact
  ObjectPoints points;
  std::vector<std::uint8_t> on_object;  ///< per object point: 1 on the object, 0 leaked
};

struct TrainingWorld {
  std::vector<TrainingShape> shapes;
  std::vector<TrainingView> views;
};

/// How training worlds are made: offices of the built-in generator or streets, other seeds, other
/// instances, seen by cameras set down at random.
struct TrainingWorldConfig {
  std::string world = "office";    ///< of OfficeConfig; "quick" is for tests and first tries;
                                   ///< "street": hydrants, cars, benches (StreetBlock)
  std::string objects = "scored";  ///< "all": furniture, computers, trees, too
  int frames = 1500;               ///< rendered per world
  int max_views_per_shape = 64;    ///< so that no instance dominates
  int sdf_points = 12000;          ///< per instance
  int min_pixels = 70;             ///< of a mask, at image_width
  int image_width = 360;
  double clean_masks = 0.5;  ///< share of views with exact masks
  double max_depth_m = 5;
  int grid_frames = 0;  ///< grids per instance, for the latent flow
};
void read(ConfigReader& reader, TrainingWorldConfig& config);

/// World `index` of a split: a function of its arguments. Worlds, like instances, of different
/// splits have nothing in common; those of kEvaluation are never made here (aborts).
TrainingWorld makeTrainingWorld(const TrainingWorldConfig& config, InstanceSplit split,
                                std::uint64_t index);

/// What stands in a world: makeOffice(trainingOffice(...), trainingWorldSeed(...)), or for "street"
/// makeStreetBlock(trainingStreet(...), trainingWorldSeed(...)).
OfficeConfig trainingOffice(const TrainingWorldConfig& config, InstanceSplit split,
                            std::uint64_t index);
StreetBlockConfig trainingStreet(InstanceSplit split);

/// Seed of the layout of a world; disjoint per split, and none below 2^61, where users' seeds are.
std::uint64_t trainingWorldSeed(InstanceSplit split, std::uint64_t index);

/// Millimetres and 16 bits: a cache, in the byte order of the machine. nullopt where the file does
/// not exist or is of another config.
void writeTrainingWorld(const std::filesystem::path& path, const TrainingWorldConfig& config,
                        const TrainingWorld& world);
std::optional<TrainingWorld> readTrainingWorld(const std::filesystem::path& path,
                                               const TrainingWorldConfig& config);

}  // namespace hydrabench
