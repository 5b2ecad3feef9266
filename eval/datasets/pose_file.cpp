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
  const std::string text = readFile(path);
  std::vector<StampedPose> poses;
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::vector<std::string_view> columns = words(line.substr(0, line.find('#')));
    if (columns.empty()) continue;

    const std::string place = fmt::format("{}:{}", path.string(), number);
    StampedPose pose;
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    if (columns.size() == 13) {
      pose.stamp_ns = parse<std::int64_t>(columns[0], place, "a stamp in whole nanoseconds");
      for (int i = 0; i < 12; ++i) {
        matrix(i / 4, i % 4) =
            parse<double>(columns[static_cast<std::size_t>(i) + 1], place, "a number");
      }
    } else if (columns.size() == 8) {
      pose.stamp_ns = parseSeconds(columns[0], place);
      double values[7];
      for (std::size_t i = 0; i < 7; ++i) {
        values[i] = parse<double>(columns[i + 1], place, "a number");
      }
      matrix = matrixFromQuaternion(values, place);
    } else {
      throw InputError(
          fmt::format("{}: {} columns, expected 13 (stamp_ns and 3 x 4 matrix) or 8 (TUM)", place,
                      columns.size()));
    }
    pose.T_world_camera = checkedPose(matrix, place);
    if (!poses.empty() && pose.stamp_ns <= poses.back().stamp_ns) {
      throw InputError(fmt::format("{}: stamp {} ns does not come after the one before, {} ns",
                                   place, pose.stamp_ns, poses.back().stamp_ns));
    }
    poses.push_back(pose);
  }
  return poses;
}

void writePoses(const std::filesystem::path& path, const std::vector<StampedPose>& poses) {
  std::string text = "# stamp_ns, then T_world_camera (3 x 4) row by row [m]\n";
  for (const StampedPose& pose : poses) {
    text += fmt::format("{}", pose.stamp_ns);
    for (int i = 0; i < 12; ++i) text += fmt::format(" {}", pose.T_world_camera(i / 4, i % 4));
    text += '\n';
  }
  writeFileAtomic(path, text);
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
