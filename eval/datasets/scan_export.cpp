// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/scan_export.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/datasets/folder_layout.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace layout = folder_layout;

ScanExport::ScanExport(fs::path folder, std::size_t num_frames)
    : folder_(std::move(folder)), frames_(num_frames) {}

void ScanExport::write(std::size_t index, const Frame& frame) {
  for (const LidarScan& scan : frame.scans) {
    // How many sweeps the frames before hold is not known yet.
    const fs::path stem =
        folder_ / layout::kLidar / fmt::format("{}-{}", index, frames_[index].size());
    writeScan(stem, scan);
    frames_[index].push_back(
        {stem,
         {scan.start_ns, scan.stamp_ns, scan.T_world_lidar_start, scan.T_world_lidar},
         describe(scan),
         !scan.points.empty()});
  }
}

std::optional<LidarDescription> ScanExport::finish() {
  std::vector<Written> scans;
  for (const std::vector<Written>& frame : frames_) {
    scans.insert(scans.end(), frame.begin(), frame.end());
  }
  if (scans.empty()) return std::nullopt;
  const auto telling =
      std::find_if(scans.begin(), scans.end(), [](const Written& scan) { return scan.has_points; });
  const LidarDescription lidar = (telling == scans.end() ? scans.front() : *telling).lidar;
  std::vector<ScanPose> poses;
  for (const Written& scan : scans) {
    if (scan.has_points ? scan.lidar != lidar : scan.lidar.model != lidar.model) {
      throw InputError(
          fmt::format("the sweep at {} ns is of another sensor, or has other lists (intensity, "
                      "rings, times, labels), than the one at {} ns: the layout holds one kind",
                      scan.pose.stamp_ns, telling->pose.stamp_ns));
    }
    renameScan(scan.stem, folder_ / layout::scan(poses.size()), lidar);
    poses.push_back(scan.pose);
  }
  writeScanPoses(folder_ / layout::kLidarPoses, poses);
  return lidar;
}

}  // namespace hydrabench
