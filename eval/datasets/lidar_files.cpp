// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/lidar_files.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "files are read as they lie in memory");

constexpr double kDegree = std::numbers::pi / 180;
constexpr const char* kPoints = ".bin";
constexpr const char* kRings = ".ring";
constexpr const char* kTimes = ".time";
constexpr const char* kLabels = ".label";
constexpr std::uint32_t kClassBits = 0xffff;  // above: instances of SemanticKITTI

fs::path withExtension(const fs::path& stem, const char* extension) {
  return stem.parent_path() / (stem.filename().string() + extension);
}

template <typename Value>
void writeValues(const fs::path& path, const std::vector<Value>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  writeFileAtomic(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

template <typename Value>
std::vector<Value> valuesOf(const std::string& bytes) {
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
  return values;
}

/// One value per point.
template <typename Value>
std::vector<Value> readValues(const fs::path& path, std::size_t num_points) {
  const std::string bytes = readFile(path);
  if (bytes.size() != num_points * sizeof(Value)) {
    throw InputError(fmt::format(
        "{}: {} bytes, expected {}: {} for each of the {} points of the "
        ".bin beside it",
        path.string(), bytes.size(), num_points * sizeof(Value), sizeof(Value), num_points));
  }
  return valuesOf<Value>(bytes);
}

void readPoints(const fs::path& path, bool with_intensity, LidarScan& scan) {
  constexpr std::size_t kColumns = 4;
  const std::string bytes = readFile(path);
  if (bytes.size() % (kColumns * sizeof(float)) != 0) {
    throw InputError(fmt::format(
        "{}: {} bytes, expected a multiple of 16: x, y, z, intensity of a point as 32-bit floats",
        path.string(), bytes.size()));
  }
  const std::vector<float> values = valuesOf<float>(bytes);
  const std::size_t num_points = values.size() / kColumns;
  scan.points.reserve(num_points);
  for (std::size_t i = 0; i < num_points; ++i) {
    const float* const point = values.data() + kColumns * i;
    scan.points.emplace_back(point[0], point[1], point[2]);
    if (!with_intensity) continue;
    const float intensity = point[3];
    // A missing return may have anything here.
    if (scan.points.back().allFinite() && !(intensity >= 0 && intensity <= 1)) {
      throw InputError(
          fmt::format("{}: intensity {} at point {}, expected 0 to 1 (or intensity: "
                      "false in dataset.yaml)",
                      path.string(), intensity, i));
    }
    scan.intensity.push_back(intensity);
  }
}

void readRings(const fs::path& path, LidarScan& scan) {
  scan.rings = readValues<std::uint16_t>(path, scan.points.size());
  for (std::size_t i = 0; i < scan.rings.size(); ++i) {
    if (scan.rings[i] < scan.lidar.rows) continue;
    throw InputError(fmt::format("{}: ring {} at point {}, expected 0 to {}: the LiDAR has {} rows",
                                 path.string(), scan.rings[i], i, scan.lidar.rows - 1,
                                 scan.lidar.rows));
  }
}

void readTimes(const fs::path& path, LidarScan& scan) {
  scan.times = readValues<float>(path, scan.points.size());
  for (std::size_t i = 0; i < scan.times.size(); ++i) {
    if (scan.times[i] >= 0 && scan.times[i] <= 1) continue;
    throw InputError(fmt::format("{}: time {} at point {}, expected 0 to 1, a share of the sweep",
                                 path.string(), scan.times[i], i));
  }
}

/// The shortest number of degrees that is read back as these radians, to the bit where there is
/// one: of sensors that were described in degrees there is.
double degrees(double radians) {
  const double nearest = radians / kDegree;
  const double candidates[] = {std::round(nearest * 1e6) / 1e6, nearest,
                               std::nextafter(nearest, 360), std::nextafter(nearest, -360)};
  for (const double candidate : candidates) {
    if (candidate * kDegree == radians) return candidate;
  }
  return nearest;
}

}  // namespace

LidarDescription describe(const LidarScan& scan) {
  return {.model = scan.lidar,
          .intensity = !scan.intensity.empty(),
          .rings = !scan.rings.empty(),
          .times = !scan.times.empty(),
          .labels = !scan.labels.empty()};
}

void readLidarModel(ConfigReader& reader, LidarModel& model) {
  double top_deg = degrees(model.top_rad);
  double bottom_deg = degrees(model.bottom_rad);
  reader.field("rows", model.rows, {2, 65535});
  reader.field("columns", model.columns, {4, 65535});
  reader.field("top_deg", top_deg, {-90, 90});
  reader.field("bottom_deg", bottom_deg, {-90, 90});
  if (bottom_deg >= top_deg) {
    reader.fault("bottom_deg",
                 fmt::format("expected below top_deg, {}: elevations, up positive", top_deg));
  }
  model.top_rad = top_deg * kDegree;
  model.bottom_rad = bottom_deg * kDegree;
}

LidarDescription readLidarDescription(ConfigReader& reader) {
  LidarDescription lidar;
  ConfigReader section = reader.section("lidar");
  for (const char* key : {"rows", "columns", "top_deg", "bottom_deg"}) section.require(key);
  readLidarModel(section, lidar.model);
  section.field("intensity", lidar.intensity);
  section.field("rings", lidar.rings);
  section.field("times", lidar.times);
  section.field("labels", lidar.labels);
  return lidar;
}

std::string lidarYaml(const LidarDescription& lidar) {
  return fmt::format(
      "lidar:\n  rows: {}\n  columns: {}\n  top_deg: {}\n  bottom_deg: {}\n  intensity: {}\n"
      "  rings: {}\n  times: {}\n  labels: {}\n",
      lidar.model.rows, lidar.model.columns, degrees(lidar.model.top_rad),
      degrees(lidar.model.bottom_rad), lidar.intensity, lidar.rings, lidar.times, lidar.labels);
}

void writeScan(const fs::path& stem, const LidarScan& scan) {
  std::vector<float> values;
  values.reserve(4 * scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    values.insert(values.end(), {point.x(), point.y(), point.z(),
                                 scan.intensity.empty() ? 0.0f : scan.intensity[i]});
  }
  writeValues(withExtension(stem, kPoints), values);
  if (!scan.rings.empty()) writeValues(withExtension(stem, kRings), scan.rings);
  if (!scan.times.empty()) writeValues(withExtension(stem, kTimes), scan.times);
  if (scan.labels.empty()) return;
  std::vector<std::uint32_t> labels;
  for (const Label label : scan.labels) {
    if (label < 0 || label > static_cast<Label>(kClassBits)) {
      throw InputError(fmt::format("scan at {} ns: label {} does not fit the 16 bits of the export",
                                   scan.stamp_ns, label));
    }
    labels.push_back(static_cast<std::uint32_t>(label));
  }
  writeValues(withExtension(stem, kLabels), labels);
}

void renameScan(const fs::path& from, const fs::path& to, const LidarDescription& lidar) {
  const std::pair<const char*, bool> files[] = {
      {kPoints, true}, {kRings, lidar.rings}, {kTimes, lidar.times}, {kLabels, lidar.labels}};
  for (const auto& [extension, wanted] : files) {
    if (!wanted) continue;
    if (fs::exists(withExtension(from, extension))) {
      fs::rename(withExtension(from, extension), withExtension(to, extension));
    } else {
      writeFileAtomic(withExtension(to, extension), "");
    }
  }
}

LidarScan readScan(const fs::path& stem, const LidarDescription& lidar) {
  LidarScan scan;
  scan.lidar = lidar.model;
  readPoints(withExtension(stem, kPoints), lidar.intensity, scan);
  if (lidar.rings) readRings(withExtension(stem, kRings), scan);
  if (lidar.times) readTimes(withExtension(stem, kTimes), scan);
  if (lidar.labels) {
    for (const std::uint32_t value :
         readValues<std::uint32_t>(withExtension(stem, kLabels), scan.points.size())) {
      scan.labels.push_back(static_cast<Label>(value & kClassBits));
    }
  }
  return scan;
}

}  // namespace hydrabench
