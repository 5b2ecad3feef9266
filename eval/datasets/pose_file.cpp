// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/pose_file.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  constexpr std::string_view kSpace = " \t\r\n";
  for (std::size_t begin = line.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSpace, end);
  }
  return result;
}

template <typename Number>
Number parse(std::string_view word, const std::string& place, const char* expected) {
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw InputError(fmt::format("{}: expected {}, found '{}'", place, expected, word));
  }
  return number;
}

/// Decimal seconds to ns without a double in between, which has too few digits for the times of day
/// in TUM files.
std::int64_t parseSeconds(std::string_view word, const std::string& place) {
  const std::size_t dot = std::min(word.find('.'), word.size());
  const auto seconds = parse<std::int64_t>(word.substr(0, dot), place, "a stamp in seconds");
  std::string fraction(word.substr(std::min(dot + 1, word.size())));
  fraction.resize(9, '0');
  const auto nanoseconds = parse<std::int64_t>(fraction, place, "a stamp in seconds");
  if (seconds < 0 || seconds > 9'000'000'000 || nanoseconds < 0) {
    throw InputError(
        fmt::format("{}: expected a stamp in seconds from 0 on, found '{}'", place, word));
  }
  return seconds * 1'000'000'000 + nanoseconds;
}

Eigen::Matrix4d matrixFromQuaternion(const double (&v)[7], const std::string& place) {
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1) < 1e-3)) {
    throw InputError(fmt::format("{}: quaternion of length {}, expected 1", place, q.norm()));
  }
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = q.normalized().toRotationMatrix();
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d(v[0], v[1], v[2]);
  return matrix;
}

/// Calls line(columns, "file:line") for every line that is not empty or a comment.
template <typename Line>
void forEachLine(const std::filesystem::path& path, const Line& line) {
  const std::string text = readFile(path);
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view content = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::vector<std::string_view> columns = words(content.substr(0, content.find('#')));
    if (!columns.empty()) line(columns, fmt::format("{}:{}", path.string(), number));
  }
}

/// The upper 3 x 4 of a matrix in the twelve columns from `first` on.
Transform parsePose(const std::vector<std::string_view>& columns, std::size_t first,
                    const std::string& place) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < 12; ++i) {
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) =
        parse<double>(columns[first + i], place, "a number");
  }
  return checkedPose(matrix, place);
}

std::int64_t parseNanoseconds(std::string_view word, const std::string& place) {
  return parse<std::int64_t>(word, place, "a stamp in whole nanoseconds");
}

/// A line of 13 columns or of the 8 of TUM.
StampedPose parseStampedPose(const std::vector<std::string_view>& columns,
                             const std::string& place) {
  if (columns.size() == 13) {
    return {parseNanoseconds(columns[0], place), parsePose(columns, 1, place)};
  }
  const std::int64_t stamp_ns = parseSeconds(columns[0], place);
  double values[7];
  for (std::size_t i = 0; i < 7; ++i) {
    values[i] = parse<double>(columns[i + 1], place, "a number");
  }
  return {stamp_ns, checkedPose(matrixFromQuaternion(values, place), place)};
}

void requireAscending(std::int64_t before_ns, std::int64_t stamp_ns, const std::string& place) {
  if (stamp_ns > before_ns) return;
  throw InputError(fmt::format("{}: stamp {} ns does not come after the one before, {} ns", place,
                               stamp_ns, before_ns));
}

void requireForward(std::int64_t start_ns, std::int64_t stamp_ns, const std::string& place) {
  if (start_ns <= stamp_ns) return;
  throw InputError(
      fmt::format("{}: a sweep that ends at {} ns, before its start at {} ns; expected start, end",
                  place, stamp_ns, start_ns));
}

std::string matrixText(const Transform& pose) {
  std::string text;
  for (int i = 0; i < 12; ++i) text += fmt::format(" {}", pose(i / 4, i % 4));
  return text;
}

}  // namespace

Transform checkedPose(const Eigen::Matrix4d& matrix, const std::string& place) {
  std::string fault;
  const std::optional<Transform> pose = rigidFromMatrix(matrix, &fault);
  if (!pose) throw InputError(fmt::format("{}: no rigid motion: {}", place, fault));
  if ((pose->matrix() - matrix).cwiseAbs().maxCoeff() > 1e-12) return *pose;
  Transform exact;
  exact.matrix() = matrix;
  return exact;
}

std::vector<StampedPose> readPoses(const std::filesystem::path& path) {
  std::vector<StampedPose> poses;
  forEachLine(path, [&](const std::vector<std::string_view>& columns, const std::string& place) {
    if (columns.size() != 13 && columns.size() != 8) {
      throw InputError(
          fmt::format("{}: {} columns, expected 13 (stamp_ns and 3 x 4 matrix) or 8 (TUM)", place,
                      columns.size()));
    }
    const StampedPose pose = parseStampedPose(columns, place);
    if (!poses.empty()) requireAscending(poses.back().stamp_ns, pose.stamp_ns, place);
    poses.push_back(pose);
  });
  return poses;
}

void writePoses(const std::filesystem::path& path, const std::vector<StampedPose>& poses) {
  std::string text = "# stamp_ns, then T_world_camera (3 x 4) row by row [m]\n";
  for (const StampedPose& pose : poses) {
    text += fmt::format("{}{}\n", pose.stamp_ns, matrixText(pose.T_world_camera));
  }
  writeFileAtomic(path, text);
}

std::vector<ScanPose> readScanPoses(const std::filesystem::path& path) {
  std::vector<ScanPose> poses;
  forEachLine(path, [&](const std::vector<std::string_view>& columns, const std::string& place) {
    ScanPose pose;
    if (columns.size() == 26) {
      pose.start_ns = parseNanoseconds(columns[0], place);
      pose.stamp_ns = parseNanoseconds(columns[1], place);
      pose.T_world_lidar_start = parsePose(columns, 2, place);
      pose.T_world_lidar = parsePose(columns, 14, place);
      requireForward(pose.start_ns, pose.stamp_ns, place);
    } else if (columns.size() == 13 || columns.size() == 8) {
      const StampedPose instant = parseStampedPose(columns, place);
      pose = {instant.stamp_ns, instant.stamp_ns, instant.T_world_camera, instant.T_world_camera};
    } else {
      throw InputError(fmt::format(
          "{}: {} columns, expected 26 (start_ns, stamp_ns and two 3 x 4 matrices), 13 (stamp_ns "
          "and one matrix) or 8 (TUM)",
          place, columns.size()));
    }
    if (!poses.empty()) requireAscending(poses.back().stamp_ns, pose.stamp_ns, place);
    poses.push_back(pose);
  });
  return poses;
}

void writeScanPoses(const std::filesystem::path& path, const std::vector<ScanPose>& poses) {
  std::string text =
      "# start_ns, stamp_ns, then T_world_lidar (3 x 4) row by row [m] at the start, at the end\n";
  for (const ScanPose& pose : poses) {
    text += fmt::format("{} {}{}{}\n", pose.start_ns, pose.stamp_ns,
                        matrixText(pose.T_world_lidar_start), matrixText(pose.T_world_lidar));
  }
  writeFileAtomic(path, text);
}

std::vector<Interval> readStamps(const std::filesystem::path& path) {
  std::vector<Interval> stamps;
  forEachLine(path, [&](const std::vector<std::string_view>& columns, const std::string& place) {
    if (columns.size() > 2) {
      throw InputError(fmt::format("{}: {} columns, expected a stamp, or start and end of a sweep",
                                   place, columns.size()));
    }
    const auto stampIn = [&](std::string_view word) {
      return word.find('.') == std::string_view::npos ? parseNanoseconds(word, place)
                                                      : parseSeconds(word, place);
    };
    const Interval interval{stampIn(columns.front()), stampIn(columns.back())};
    requireForward(interval.start_ns, interval.stamp_ns, place);
    if (!stamps.empty()) requireAscending(stamps.back().stamp_ns, interval.stamp_ns, place);
    stamps.push_back(interval);
  });
  return stamps;
}

std::vector<Transform> readKittiPoses(const std::filesystem::path& path) {
  std::vector<Transform> poses;
  forEachLine(path, [&](const std::vector<std::string_view>& columns, const std::string& place) {
    if (columns.size() != 12) {
      throw InputError(
          fmt::format("{}: {} columns, expected 12 (3 x 4 matrix)", place, columns.size()));
    }
    poses.push_back(parsePose(columns, 0, place));
  });
  return poses;
}

Transform readPoseMatrix(const std::filesystem::path& path) {
  const std::string text = readFile(path);
  const std::vector<std::string_view> numbers = words(text);
  if (numbers.size() != 16) {
    throw InputError(
        fmt::format("{}: {} numbers, expected a 4 x 4 matrix", path.string(), numbers.size()));
  }
  Eigen::Matrix4d matrix;
  for (std::size_t i = 0; i < 16; ++i) {
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) =
        parse<double>(numbers[i], path.string(), "a number");
  }
  return checkedPose(matrix, path.string());
}

}  // namespace hydrabench
