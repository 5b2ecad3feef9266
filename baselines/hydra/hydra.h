// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "baselines/hydra/mesh_objects.h"
#include "core/config/config_reader.h"
#include "core/lidar/lidar_input.h"
#include "core/mapping/active_window.h"
#include "core/pipeline/mapping_system.h"

namespace hydrabench {

/// Hydra (Hughes et al., "Hydra: A Real-time Spatial Perception System for 3D Scene Graph
/// Construction and Optimization", RSS 2022; IJRR 2024), built anew from the papers, the public
/// code and its configs as of January 2026, for what a scene graph shows of objects. Every frame
/// goes into a TSDF with labels; every 0.2 s the mesh of the active window is taken, its vertices
/// are clustered class by class, and the clusters are joined to the objects there are. Blocks
/// farther than 8 m are archived, and with them the objects.
///
/// Hydra keeps no meshes of objects, only which vertices of the scene are theirs. An object's mesh
/// here is what those vertices span: the triangles of the scene mesh with all three corners among
/// them. Its box is that of the mesh, or of the vertices where there is no triangle.
///
/// Where this departs from Hydra:
///  - Poses are taken as given and fixed: no pose graph, no deformation of the mesh, no loop
///    closures. With ground-truth poses Hydra optimises nothing either.
///  - The backend's merge of an active object with an archived one is carried out at once and for
///    good, and the merged object is active again. Hydra proposes such merges and applies them anew
///    at each update; the rule is the same.
///  - A vertex whose fused class is no longer that of its object leaves the object, so that a wrong
///    label that is outvoted later leaves nothing behind. Hydra keeps such vertices.
///  - A colour is blended in with the share w / (W + w) of its weight, the first one whole. Hydra
///    divides by the weight that w was added to already, and blends the first colour with black.
///  - Label 0 (unknown) is never fused: where a mask has holes, a voxel keeps the class it was seen
///    with before. In Hydra's favour.
///  - The window is measured from the camera. Hydra measures it from the body, 5 cm away on
///    uHumans2.
///  - A block that left the window stays until its lower neighbours in x, y and z, to which the
///    cubes across the border belong, have left it too. Hydra archives it at once and loses those
///    triangles when the neighbour is meshed again.
///  - Triangles that vertex merging folds onto each other with opposite sides are both dropped, so
///    that the mesh stays closed; Hydra keeps one.
///  - When an object was last observed is when it last got a new vertex.
///  - Mesh, objects and frames take turns in one thread of control. Hydra runs them side by side
///    and may skip frames; here nothing depends on timing.
///  - Boxes are axis-aligned, Hydra's default. Places, rooms and agents are left out.
class Hydra : public MappingSystem {
 public:
  /// As on uHumans2.
  struct Config {
    double min_range_m = 0.1;  ///< of the sensor
    double max_range_m = 5;
    /// Names of classes that move: kept out of the map.
    std::vector<std::string> dynamic_classes = {"human"};
    LidarInput::Config lidar;  ///< off
    ActiveWindow::Config window;
    MeshObjects::Config objects;
  };
  /// Objects are of the classes that are objects in the label space.
  Hydra(const Config& config, const LabelSpace& label_space);

  /// Throws InputError where the frame has no label image; with a lidar, it need not have images.
  void process(const Frame& frame) override;
  SceneGraph finish() override;
  const StageTimes& stageTimes() const override { return times_; }
  std::vector<std::string> notes() const override { return lidar_.notes(); }

  const ActiveWindow& window() const { return window_; }
  const MeshObjects& objects() const { return objects_; }

 private:
  void update();
  ObjectNode objectNode(const MeshObjects::Node& node) const;

  Config config_;
  LabelSpace label_space_;
  std::vector<Label> dynamic_labels_;
  ActiveWindow window_;
  LidarInput lidar_;
  MeshObjects objects_;
  StageTimes times_;
  std::int64_t last_stamp_ns_ = 0;
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
};

void read(ConfigReader& reader, Hydra::Config& config);

}  // namespace hydrabench
