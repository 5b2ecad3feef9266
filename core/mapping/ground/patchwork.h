// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/ground/adaptive_thresholds.h"
#include "core/mapping/ground/concentric_zones.h"
#include "core/mapping/ground/ground_segmenter.h"
#include "core/mapping/ground/patch_fit.h"
#include "core/mapping/ground/temporal_revert.h"

namespace hydrabench {

/// Patchwork++ (Lee, Lim, Myung: Fast and Robust Ground Segmentation Solving Partial
/// Under-Segmentation Using 3D Point Cloud, IROS 2022), built anew from the paper and the public
/// program as of early 2026. Reflections below the ground are taken out (RNR), the rest is cut into
/// bins (concentric zones), every bin gets a plane after steep planes are taken away (R-VPF,
/// R-GPF), and planes are judged by normal, height and flatness with thresholds learned from scan
/// to scan (A-GLE), the refused ones once more by their ring (TGR).
///
/// Departures:
/// - Points out of range and in bins with too few points are not judged; there they are non-ground.
/// - A bin without three points on a plane is non-ground; there it takes over the plane of the bin
///   before. A ring with one sample adapts nothing; there its height becomes 0.
/// - The flatness of a ring is learned whatever the rings inside have; there the first ring with
///   fewer than two samples keeps all rings behind it from learning.
/// - Covariances in double, by an iterative solver; ties in a bin by the order of points.
/// - min_lines and the settings for a VLP-16 are ours; adapt_sensor_height can be turned off.
class Patchwork : public GroundSegmenter {
 public:
  /// RNR: weak returns from steeply below that seem to come from under the ground. Needs intensity;
  /// without it, nothing is taken out.
  struct ReflectionConfig {
    bool enabled = true;
    double max_angle_deg = -15;   ///< of the ray, to the horizontal; below it
    double max_intensity = 0.2;   ///< below it
    double below_ground_m = 0.8;  ///< more than that
  };
  struct Config {
    std::string sensor = "hdl64";  ///< hdl64, vlp16: which values are the defaults, see forSensor()
    int min_points = 10;           ///< that a bin needs to be judged
    int min_lines = 1;             ///< scan lines that it needs, where lines are known
    ReflectionConfig reflection;
    ConcentricZones::Config zones;
    PatchFitConfig fit;
    AdaptiveThresholds::Config adaptive;
    TemporalRevertConfig revert;

    /// hdl64: 64 lines at the height of a car, the published values (defaults of the library).
    /// vlp16: 16 lines at about 0.5 m. Needs one of sensors().
    static Config forSensor(const std::string& sensor);
    static std::vector<std::string> sensors();
  };
  explicit Patchwork(const Config& config);

  GroundMask segment(const GroundScan& scan) override;

  /// As learned from the scans so far.
  const AdaptiveThresholds& thresholds() const { return thresholds_; }

 private:
  /// The points of a scan, bin by bin.
  struct Bins {
    std::vector<BinPoint> points;
    std::vector<std::size_t> begins;  ///< of each bin in `points`, and the end
  };
  Bins sortIntoBins(const GroundScan& scan, double sensor_height_m, GroundMask& mask) const;
  bool hasEnough(std::span<const BinPoint> bin, const GroundScan& scan) const;
  void judgeRing(std::size_t ring, std::span<const std::optional<Patch>> patches, GroundMask& mask);

  Config config_;
  ConcentricZones zones_;
  AdaptiveThresholds thresholds_;
};

/// The key `sensor` sets all other values before they are read.
void read(ConfigReader& reader, Patchwork::Config& config);

}  // namespace hydrabench
