// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/folder_poses.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/geometry/pose_interpolation.h"
#include "core/types/error.h"
#include "eval/datasets/folder_layout.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace layout = folder_layout;
namespace {

std::optional<Transform> readRigid(ConfigReader& reader, const char* key) {
  if (!reader.has(key)) return std::nullopt;
  std::vector<double> numbers;
  reader.field(key, numbers);
  if (numbers.size() != 12) {
    reader.fault(key, "expected 12 numbers, the upper 3 x 4 row by row");
    return std::nullopt;
  }
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < 12; ++i) {
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = numbers[i];
  }
  std::string fault;
  if (!rigidFromMatrix(matrix, &fault)) {
    reader.fault(key, "no rigid motion: " + fault);
    return std::nullopt;
  }
  return checkedPose(matrix, key);
}

/// Poses of a sensor, interpolated between those of the body.
class Odometry {
 public:
  explicit Odometry(const fs::path& folder) : path_(folder / layout::kOdometry) {
    for (const StampedPose& pose : readPoses(path_)) {
      poses_.push_back({pose.stamp_ns, pose.T_world_camera});
    }
    if (poses_.empty()) throw InputError(fmt::format("{}: no poses", path_.string()));
  }

  /// The extrinsics of a sensor whose poses are to come from here.
  const Transform& require(const std::optional<Transform>& T_body_sensor, const char* key) const {
    if (T_body_sensor) return *T_body_sensor;
    throw InputError(
        fmt::format("{}: {} missing, expected how the sensor sits on the body that {} "
                    "tells of",
                    (path_.parent_path() / layout::kDescription).string(), key, layout::kOdometry));
  }
  std::optional<Transform> at(std::int64_t stamp_ns, const Transform& T_body_sensor) const {
    const std::optional<Transform> T_world_body = poseAt(poses_, stamp_ns);
    return T_world_body ? std::optional<Transform>(*T_world_body * T_body_sensor) : std::nullopt;
  }
  std::string span() const {
    return fmt::format("{} to {} ns", poses_.front().stamp_ns, poses_.back().stamp_ns);
  }

 private:
  fs::path path_;
  std::vector<TimedPose> poses_;
};

/// True where a file of poses is to be replaced by stamps along odometry.txt.
bool fromOdometry(const fs::path& folder, const char* poses) {
  return !fs::exists(folder / poses) && fs::exists(folder / layout::kOdometry);
}

std::vector<StampedPose> readFrames(const fs::path& folder, const Extrinsics& extrinsics) {
  std::vector<StampedPose> frames;
  fs::path path = folder / layout::kPoses;
  if (fromOdometry(folder, layout::kPoses)) {
    const Odometry odometry(folder);
    const Transform& T_body_camera =
        odometry.require(extrinsics.T_body_camera, layout::kBodyCamera);
    path = folder / layout::kCameraStamps;
    for (const Interval& interval : readStamps(path)) {
      const auto T_world_camera = odometry.at(interval.stamp_ns, T_body_camera);
      if (!T_world_camera) {
        throw InputError(fmt::format("{}: frame {} at {} ns lies outside of {}, {}", path.string(),
                                     frames.size(), interval.stamp_ns, layout::kOdometry,
                                     odometry.span()));
      }
      frames.push_back({interval.stamp_ns, *T_world_camera});
    }
  } else {
    frames = readPoses(path);
  }
  if (frames.empty()) {
    throw InputError(fmt::format("{}: no poses, expected one a frame", path.string()));
  }
  return frames;
}

std::vector<FolderScan> readScans(const fs::path& folder, const Extrinsics& extrinsics) {
  std::vector<FolderScan> scans;
  fs::path path = folder / layout::kLidarPoses;
  if (!fromOdometry(folder, layout::kLidarPoses)) {
    for (const ScanPose& pose : readScanPoses(path)) scans.push_back({scans.size(), pose});
    if (scans.empty()) {
      throw InputError(fmt::format("{}: no poses, expected one a sweep", path.string()));
    }
    return scans;
  }
  const Odometry odometry(folder);
  const Transform& T_body_lidar = odometry.require(extrinsics.T_body_lidar, layout::kBodyLidar);
  path = folder / layout::kLidarStamps;
  const std::vector<Interval> stamps = readStamps(path);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const Interval& sweep = stamps[i];
    const auto start = odometry.at(sweep.start_ns, T_body_lidar);
    const auto end = odometry.at(sweep.stamp_ns, T_body_lidar);
    if (start && end) scans.push_back({i, {sweep.start_ns, sweep.stamp_ns, *start, *end}});
  }
  if (stamps.empty()) throw InputError(fmt::format("{}: no stamps", path.string()));
  if (scans.empty()) {
    throw InputError(fmt::format("{}: sweeps from {} to {} ns, none within {}, {}", path.string(),
                                 stamps.front().start_ns, stamps.back().stamp_ns, layout::kOdometry,
                                 odometry.span()));
  }
  return scans;
}

void requireOverlap(const fs::path& folder, const FolderPoses& poses) {
  const std::int64_t frames_begin = poses.frames.front().stamp_ns;
  const std::int64_t frames_end = poses.frames.back().stamp_ns;
  const std::int64_t scans_begin = poses.scans.front().pose.start_ns;
  const std::int64_t scans_end = poses.scans.back().pose.stamp_ns;
  if (scans_begin <= frames_end && scans_end >= frames_begin) return;
  throw InputError(
      fmt::format("{}: sweeps from {} to {} ns, frames from {} to {} ns: they never overlap; both "
                  "sensors must tell the time of one clock",
                  folder.string(), scans_begin, scans_end, frames_begin, frames_end));
}

}  // namespace

Extrinsics readExtrinsics(ConfigReader& reader) {
  return {readRigid(reader, layout::kBodyCamera), readRigid(reader, layout::kBodyLidar)};
}

FolderPoses readFolderPoses(const fs::path& folder, bool has_camera, bool has_lidar,
                            const Extrinsics& extrinsics) {
  FolderPoses poses;
  if (has_lidar) poses.scans = readScans(folder, extrinsics);
  if (has_camera) {
    poses.frames = readFrames(folder, extrinsics);
  } else {
    for (const FolderScan& scan : poses.scans) {
      poses.frames.push_back({scan.pose.stamp_ns, scan.pose.T_world_lidar});
    }
  }
  if (has_lidar) requireOverlap(folder, poses);
  // Stamps of both ascend: the sweeps of a frame are those that ended since the frame before.
  poses.first_scan = {0};
  for (const StampedPose& frame : poses.frames) {
    std::size_t next = poses.first_scan.back();
    while (next < poses.scans.size() && poses.scans[next].pose.stamp_ns <= frame.stamp_ns) ++next;
    poses.first_scan.push_back(next);
  }
  return poses;
}

}  // namespace hydrabench
