// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/datasets/folder_export.h"
#include "eval/datasets/lidar_files.h"
#include "eval/datasets/open_dataset.h"
#include "eval/simulation/lidar_pattern.h"
#include "tests/eval/datasets/toy_lidar_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// To the bit: a point that is not a number equals itself here.
void expectSamePoints(const std::vector<Eigen::Vector3f>& a,
                      const std::vector<Eigen::Vector3f>& b) {
  ASSERT_EQ(a.size(), b.size());
  if (a.empty()) return;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
}

void expectSameScans(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    const LidarScan& x = a.scans[i];
    const LidarScan& y = b.scans[i];
    EXPECT_EQ(x.stamp_ns, y.stamp_ns);
    EXPECT_EQ(x.start_ns, y.start_ns);
    EXPECT_EQ(x.lidar, y.lidar);
    EXPECT_EQ(x.T_world_lidar.matrix(), y.T_world_lidar.matrix());
    EXPECT_EQ(x.T_world_lidar_start.matrix(), y.T_world_lidar_start.matrix());
    expectSamePoints(x.points, y.points);
    EXPECT_EQ(x.intensity, y.intensity);
    EXPECT_EQ(x.rings, y.rings);
    EXPECT_EQ(x.times, y.times);
    EXPECT_EQ(x.labels, y.labels);
  }
}

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = readText(entry.path());
    }
  }
  return files;
}

TEST(LidarFolder, ReadsBackTheScansThatWereExported) {
  TemporaryFolder folder;
  for (const bool with_lists : {true, false}) {
    ToyLidarDataset toy;
    toy.with_lists = with_lists;
    const fs::path out = folder / (with_lists ? "lists" : "points");
    exportDataset(toy, out);
    const OpenedDataset opened = openDataset(out);
    ASSERT_EQ(opened.dataset->numFrames(), 4u);
    for (const std::size_t i : {3u, 0u, 2u, 1u}) {
      const Frame frame = opened.dataset->frame(i);
      expectSameScans(frame, toy.frame(i));
      EXPECT_TRUE(frame.depth == toy.frame(i).depth);
    }
    EXPECT_EQ(opened.dataset->frame(1).scans[1].points.size(), 40u);
    EXPECT_EQ(fs::exists(out / "lidar/000005.ring"), with_lists);
  }
}

TEST(LidarFolder, ExportOfAnExportIsTheSameToTheByteForAnyNumberOfThreads) {
  TemporaryFolder folder;
  setNumThreads(1);
  exportDataset(ToyLidarDataset(), folder / "a");
  setNumThreads(4);
  exportDataset(*openDataset(folder / "a").dataset, folder / "b");
  setNumThreads(0);
  const auto a = contents(folder / "a");
  EXPECT_EQ(a, contents(folder / "b"));
  EXPECT_EQ(a.count("lidar/000000.bin"), 1u);
  EXPECT_EQ(a.count("lidar/000006.bin"), 0u) << "six scans, numbered through";
}

TEST(LidarFolder, WithoutACameraEverySweepIsAFrame) {
  TemporaryFolder folder;
  const ToyLidarOnlyDataset toy;
  exportDataset(toy, folder / "out");
  EXPECT_FALSE(fs::exists(folder / "out/poses.txt"));
  const OpenedDataset opened = openDataset(folder / "out");
  EXPECT_EQ(opened.dataset->camera().width, 0);
  ASSERT_EQ(opened.dataset->numFrames(), 3u);
  for (const std::size_t i : {0u, 1u, 2u}) {
    const Frame frame = opened.dataset->frame(i);
    EXPECT_EQ(frame.stamp_ns, toy.frame(i).stamp_ns);
    EXPECT_EQ(frame.T_world_camera.matrix(), toy.frame(i).T_world_camera.matrix());
    EXPECT_TRUE(frame.color.empty());
    expectSameScans(frame, toy.frame(i));
  }
}

TEST(LidarFolder, TheSensorsOfTheSimulationSurviveToTheLastBit) {
  for (const std::string& name : lidarPatternNames()) {
    const LidarDescription lidar{.model = lidarPattern(name).model()};
    const std::string yaml = lidarYaml(lidar);
    ConfigReader reader(ConfigDocument::fromString(yaml));
    EXPECT_EQ(readLidarDescription(reader), lidar) << yaml;
  }
}

/// A sensor that changes between sweeps does not fit into one description.
class TwoSensors : public ToyLidarDataset {
 public:
  Frame frame(std::size_t index) const override {
    Frame frame = ToyLidarDataset::frame(index);
    if (index == 3) frame.scans.at(0).lidar.rows = 6;
    return frame;
  }
};

TEST(LidarFolder, AnExportOfTwoSensorsIsRefused) {
  TemporaryFolder folder;
  EXPECT_THAT(messageOf<InputError>([&] { exportDataset(TwoSensors(), folder / "out"); }),
              HasSubstr("is of another sensor"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

// From here on, files as a user would write them: by hand.

std::string floats(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) {
    const auto* begin = reinterpret_cast<const char*>(&value);
    bytes.append(begin, begin + sizeof(float));
  }
  return bytes;
}

/// Two sweeps of two points.
class HandWritten : public ::testing::Test {
 protected:
  HandWritten() {
    writeText(file("dataset.yaml"), kDescription);
    writeText(file("lidar/000000.bin"), floats({1, 2, 3, 0.5f, -4, 5, -6, 1}));
    writeText(file("lidar/000001.bin"), floats({7, 8, 9, 0, 0, 0, 0, 0}));
    writeText(file("lidar/000000.ring"), std::string("\0\0\1\0", 4));
    writeText(file("lidar/000001.ring"), std::string("\1\0\1\0", 4));
    writeText(file("lidar_poses.txt"),
              "100 1 0 0 4 0 1 0 5 0 0 1 6\n"
              "300 1 0 0 7 0 1 0 8 0 0 1 9\n");
  }
  fs::path file(const std::string& name) const { return folder_ / ("d/" + name); }
  OpenedDataset open() const { return openDataset(folder_ / "d"); }
  std::string fault() {
    std::string message = messageOf<InputError>([&] {
      const OpenedDataset opened = open();
      for (std::size_t i = 0; i < opened.dataset->numFrames(); ++i) opened.dataset->frame(i);
    });
    EXPECT_THAT(message, ::testing::Not(HasSubstr("\n")));
    const std::string prefix = (folder_ / "d").string();
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
      message.erase(at, prefix.size());
    }
    return message;
  }
  /// Poses come from odometry: the body goes 1 m a second along x, turned to the left by 90
  /// degrees.
  void useOdometry() {
    fs::remove(file("lidar_poses.txt"));
    writeText(file("odometry.txt"),
              "0 0 -1 0 0 1 0 0 0 0 0 1 0\n1000000000 0 -1 0 1 1 0 0 0 0 0 1 0\n");
    writeText(file("lidar_stamps.txt"), "0.1 0.2\n0.2 0.3\n");
    writeText(file("camera_stamps.txt"), "150000000\n0.25\n0.5\n");
    writeText(file("dataset.yaml"),
              std::string(kDescription) +
                  "camera: {width_px: 4, height_px: 2, fx_px: 3, fy_px: 3, cx_px: 2, cy_px: 1}\n"
                  "T_body_camera: [0, 0, 1, 0.5, -1, 0, 0, 0, 0, -1, 0, 1]\n"
                  "T_body_lidar: [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 3]\n");
  }

  static constexpr const char* kDescription =
      "type: folder\nname: by_hand\nlabel_space: []\n"
      "lidar: {rows: 2, columns: 8, top_deg: 10, bottom_deg: -10, rings: true}\n";
  TemporaryFolder folder_;
};

TEST_F(HandWritten, ScansAreReadAsTheyWereWritten) {
  const OpenedDataset opened = open();
  ASSERT_EQ(opened.dataset->numFrames(), 2u);
  const Frame frame = opened.dataset->frame(0);
  ASSERT_EQ(frame.scans.size(), 1u);
  const LidarScan& scan = frame.scans[0];
  EXPECT_EQ(scan.points, (std::vector<Eigen::Vector3f>{{1, 2, 3}, {-4, 5, -6}}));
  EXPECT_EQ(scan.intensity, (std::vector<float>{0.5f, 1}));
  EXPECT_EQ(scan.rings, (std::vector<std::uint16_t>{0, 1}));
  EXPECT_TRUE(scan.times.empty());
  EXPECT_EQ(scan.stamp_ns, 100);
  EXPECT_EQ(scan.start_ns, 100);
  EXPECT_EQ(scan.T_world_lidar.translation(), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(scan.T_world_lidar_start.translation(), Eigen::Vector3d(4, 5, 6));
  EXPECT_NEAR(scan.lidar.top_rad, 0.174533, 1e-6);
}

TEST_F(HandWritten, ClassesAreTheLowerHalfOfSemanticKittisNumbers) {
  writeText(file("dataset.yaml"),
            "type: folder\nlabel_space: []\n"
            "lidar: {rows: 2, columns: 8, top_deg: 10, bottom_deg: -10, labels: true}\n");
  for (const char* scan : {"lidar/000000.label", "lidar/000001.label"}) {
    writeText(file(scan), std::string("\x28\0\1\0\x2c\1\0\0", 8));
  }
  EXPECT_EQ(open().dataset->frame(0).scans.at(0).labels, (std::vector<Label>{40, 300}));
}

TEST_F(HandWritten, PosesOfSensorsThatAreNotSynchronisedComeFromOdometry) {
  useOdometry();
  const OpenedDataset opened = open();
  const Dataset& dataset = *opened.dataset;
  ASSERT_EQ(dataset.numFrames(), 3u);
  EXPECT_TRUE(dataset.frame(0).scans.empty());
  // The sweep from 0.1 to 0.2 s ended before the frame at 0.25 s.
  const Frame frame = dataset.frame(1);
  ASSERT_EQ(frame.scans.size(), 1u);
  EXPECT_EQ(frame.scans.at(0).start_ns, 100'000'000);
  EXPECT_EQ(frame.scans.at(0).stamp_ns, 200'000'000);
  // 2 m ahead of the body, which looks along y: (0.2, 2, 3).
  EXPECT_TRUE(frame.scans.at(0).T_world_lidar.translation().isApprox(Eigen::Vector3d(0.2, 2, 3)));
  EXPECT_TRUE(
      frame.scans.at(0).T_world_lidar_start.translation().isApprox(Eigen::Vector3d(0.1, 2, 3)));
  EXPECT_TRUE(frame.T_world_camera.translation().isApprox(Eigen::Vector3d(0.25, 0.5, 1)));
  EXPECT_TRUE((frame.T_world_camera.linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_EQ(dataset.frame(2).scans.at(0).points[0], Eigen::Vector3f(7, 8, 9));
}

TEST_F(HandWritten, SweepsThatOdometryDoesNotCoverAreLeftOut) {
  useOdometry();
  writeText(file("lidar_stamps.txt"), "-5 200000000\n0.2 0.3\n");
  const OpenedDataset opened = open();
  EXPECT_TRUE(opened.dataset->frame(1).scans.empty());
  EXPECT_EQ(opened.dataset->frame(2).scans.at(0).points[0], Eigen::Vector3f(7, 8, 9))
      << "the second sweep is still that of the second file";
}

TEST_F(HandWritten, PointsWithoutAMeasurementAreNoFault) {
  writeText(file("lidar/000000.bin"), floats({std::nanf(""), 0, 0, std::nanf(""), 0, 0, 0, 1}));
  EXPECT_EQ(open().dataset->frame(0).scans.at(0).points.size(), 2u);
}

TEST_F(HandWritten, WrongNumberOfBytes) {
  writeText(file("lidar/000001.bin"), floats({1, 2, 3, 0.5f, 6}));
  EXPECT_EQ(fault(),
            "/lidar/000001.bin: 20 bytes, expected a multiple of 16: x, y, z, intensity of a point "
            "as 32-bit floats");
  writeText(file("lidar/000000.ring"), "123");
  EXPECT_EQ(
      fault(),
      "/lidar/000000.ring: 3 bytes, expected 4: 2 for each of the 2 points of the .bin beside "
      "it");
  fs::remove(file("lidar/000000.ring"));
  EXPECT_EQ(fault(), "/lidar/000000.ring: cannot read: No such file or directory");
}

TEST_F(HandWritten, ARingThatTheSensorDoesNotHave) {
  writeText(file("lidar/000001.ring"), std::string("\0\0\2\0", 4));
  EXPECT_EQ(fault(),
            "/lidar/000001.ring: ring 2 at point 1, expected 0 to 1: the LiDAR has 2 rows");
}

TEST_F(HandWritten, IntensityAndTimeOutOfRange) {
  writeText(file("lidar/000000.bin"), floats({1, 2, 3, 173, -4, 5, -6, 1}));
  EXPECT_EQ(fault(),
            "/lidar/000000.bin: intensity 173 at point 0, expected 0 to 1 (or intensity: false in "
            "dataset.yaml)");
  writeText(file("dataset.yaml"),
            "type: folder\nlabel_space: []\n"
            "lidar: {rows: 2, columns: 8, top_deg: 10, bottom_deg: -10, intensity: false, times: "
            "true}\n");
  writeText(file("lidar/000000.time"), floats({0.5f, 1.5f}));
  EXPECT_EQ(fault(),
            "/lidar/000000.time: time 1.5 at point 1, expected 0 to 1, a share of the sweep");
}

TEST_F(HandWritten, StampsThatNeverOverlap) {
  useOdometry();
  fs::remove(file("odometry.txt"));
  writeText(file("poses.txt"), "1000 1 0 0 0 0 1 0 0 0 0 1 0\n");
  writeText(file("lidar_poses.txt"), "1001 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(fault(),
            ": sweeps from 1001 to 1001 ns, frames from 1000 to 1000 ns: they never overlap; both "
            "sensors must tell the time of one clock");
}

TEST_F(HandWritten, StampsThatOdometryDoesNotReach) {
  useOdometry();
  writeText(file("lidar_stamps.txt"), "5.0 5.1\n5.1 5.2\n");
  EXPECT_EQ(fault(),
            "/lidar_stamps.txt: sweeps from 5000000000 to 5200000000 ns, none within odometry.txt, "
            "0 to 1000000000 ns");
  writeText(file("lidar_stamps.txt"), "0.1 0.2\n");
  writeText(file("camera_stamps.txt"), "0.2\n1.5\n");
  EXPECT_EQ(fault(),
            "/camera_stamps.txt: frame 1 at 1500000000 ns lies outside of odometry.txt, 0 to "
            "1000000000 ns");
}

TEST_F(HandWritten, MissingExtrinsics) {
  useOdometry();
  const std::string text = readText(file("dataset.yaml"));
  writeText(file("dataset.yaml"), text.substr(0, text.find("T_body_lidar")));
  EXPECT_EQ(fault(),
            "/dataset.yaml: T_body_lidar missing, expected how the sensor sits on the body that "
            "odometry.txt tells of");
}

TEST_F(HandWritten, AnExtrinsicRotationThatIsNone) {
  useOdometry();
  std::string text = readText(file("dataset.yaml"));
  const std::string good = "T_body_lidar: [1, 0, 0, 2,";
  writeText(file("dataset.yaml"),
            text.replace(text.find(good), good.size(), "T_body_lidar: [1.1, 0, 0, 2,"));
  EXPECT_THAT(fault(), HasSubstr("/dataset.yaml:7: T_body_lidar: no rigid motion: has a rotation "
                                 "that is not orthonormal"));
}

TEST_F(HandWritten, ASweepThatEndsBeforeItBegins) {
  useOdometry();
  writeText(file("lidar_stamps.txt"), "0.2 0.1\n");
  EXPECT_THAT(fault(), HasSubstr("/lidar_stamps.txt:1: a sweep that ends at 100000000 ns, before "
                                 "its start at 200000000 ns"));
  writeText(file("lidar_poses.txt"), "1 2 3\n");
  EXPECT_THAT(fault(), HasSubstr("/lidar_poses.txt:1: 3 columns, expected 26"));
}

TEST_F(HandWritten, ScansWithoutADescriptionOfTheSensor) {
  writeText(file("dataset.yaml"),
            "type: folder\nlabel_space: []\n"
            "camera: {width_px: 4, height_px: 2, fx_px: 3, fy_px: 3, cx_px: 2, cy_px: 1}\n");
  EXPECT_THAT(fault(), HasSubstr("lidar: missing, expected rows, columns, top_deg and bottom_deg"));
  writeText(file("dataset.yaml"),
            "type: folder\nlabel_space: []\n"
            "lidar: {rows: 2, columns: 8, top_deg: -10, bottom_deg: 10}\n");
  EXPECT_THAT(fault(), HasSubstr("lidar.bottom_deg: expected below top_deg, -10"));
}

}  // namespace
}  // namespace hydrabench
