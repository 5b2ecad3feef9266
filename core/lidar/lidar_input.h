// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/lidar/camera_points.h"
#include "core/lidar/lidar_depth.h"
#include "core/mapping/active_window.h"
#include "core/mapping/ground/ground_table.h"
#include "core/mapping/tsdf_integrator.h"
#include "core/pipeline/stage_times.h"
#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// The lidar of the hybrid mode (paper, "hybrid LiDAR-camera configuration"): every sweep is
/// deskewed, its ground is told, its points get the classes of the image, and it goes into the map
/// with weights of its own; if asked for, it is the depth of the camera's pixels, too.
class LidarInput {
 public:
  struct Config {
    Config();
    bool enabled = false;
    double min_range_m = 0.4;
    double max_range_m = 40;
    double sensor_height_m = 0.5;  ///< above the ground under the robot
    bool deskew = true;            ///< false: points are taken as if measured at the scan's stamp
    /// Whether the depth images of the camera go into the map, too.
    bool camera_in_map = false;
    /// What objects are found and estimated from. camera: its own depth; lidar: the scans; filled:
    /// the camera's, and the scans where it measured nothing.
    std::string object_depth = "filled";
    GroundConfig ground;
    OcclusionConfig image_transfer;
    LidarDepth::Config depth;
    TsdfIntegrator::Config integrator;
  };
  /// @param moving  classes that are kept out of the map
  LidarInput(const Config& config, const LabelSpace& label_space, std::vector<Label> moving);

  bool enabled() const { return config_.enabled; }
  bool cameraInMap() const { return !config_.enabled || config_.camera_in_map; }

  /// Takes the frame's scans into the map. Stages: ground, image_transfer, lidar_integrate. Throws
  /// InputError where a scan is not usable, see requireUsable().
  void integrate(const Frame& frame, ActiveWindow& window, StageTimes& times);
  /// The frame as objects are found and estimated from it, see Config::object_depth; the scans so
  /// far included. Stage: lidar_depth. Not to be called for camera, nor where it is not enabled.
  Frame withLidarDepth(const Frame& frame, StageTimes& times) const;
  bool replacesDepth() const { return config_.enabled && config_.object_depth != "camera"; }

  /// Throws InputError if it is enabled and no scan with a return ever came.
  void requireScans() const;
  /// How many points and scans had no return; nothing where all had one.
  std::vector<std::string> notes() const;

 private:
  Config config_;
  std::vector<Label> moving_;
  std::unique_ptr<GroundSegmenter> ground_;
  TsdfIntegrator integrator_;
  LidarDepth depth_;
  std::size_t num_scans_ = 0;
  std::size_t num_empty_ = 0;  ///< scans without a return; not among num_scans_
  std::size_t num_points_ = 0;
  std::size_t num_without_return_ = 0;
};

void read(ConfigReader& reader, LidarInput::Config& config);

/// A fault of the window's section where the mesh asks for more weight than the ground band gives,
/// and so would have none of it.
void requireBandInMesh(ConfigReader& window_reader, const ActiveWindow::Config& window,
                       const LidarInput::Config& lidar);

}  // namespace hydrabench
