// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/datasets/kitti_raw_dataset.h"
#include "eval/datasets/open_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(KittiRaw, LasersAreToldApartByTheTurnThroughStraightAhead) {
  // Two lasers, each from straight ahead to the left, around and back; noise behind the car.
  const std::vector<Eigen::Vector3f> points = {{9, 1, 0},     {-9, 1, 0},  {-9, -1, 0},
                                               {-9, 0.5f, 0}, {-9, -1, 0}, {9, -1, 0},
                                               {9, 2, 0},     {-9, -1, 0}, {9, -2, 0}};
  EXPECT_EQ(ringsByOrder(points, 2), (std::vector<std::uint16_t>{0, 0, 0, 0, 0, 0, 1, 1, 1}));
  EXPECT_TRUE(ringsByOrder(points, 1).empty());
}

/// A drive of a root folder that holds the config too.
class SmallDrive : public ::testing::Test {
 protected:
  SmallDrive() {
    const float points[] = {1, 2, 3, 0.25f, 4, -5, 6, 0.5f};
    const std::string bytes(reinterpret_cast<const char*>(points), sizeof(points));
    writeText(folder_ / "drive/velodyne_points/data/0000000001.bin", bytes);
    writeText(folder_ / "drive/velodyne_points/data/0000000003.bin", bytes.substr(16));
    writeText(folder_ / "drive/poses.txt",
              "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 2 0 0 1 3\n"
              "1 0 0 2 0 1 0 4 0 0 1 6\n0 -1 0 3 1 0 0 6 0 0 1 9\n");
    writeText(folder_ / "d.yaml", "type: kitti_raw\nfolder: drive\nroot: " +
                                      folder_.path().string() + "\nrate_hz: 10\n");
  }
  TemporaryFolder folder_;
};

TEST_F(SmallDrive, ScanNHasLineNOfThePoses) {
  const OpenedDataset opened = openDataset(folder_ / "d.yaml");
  const Dataset& dataset = *opened.dataset;
  EXPECT_FALSE(dataset.hasGroundTruth());
  EXPECT_EQ(dataset.camera().width, 0);
  ASSERT_EQ(dataset.numFrames(), 2u);
  const Frame frame = dataset.frame(1);
  EXPECT_EQ(frame.stamp_ns, 300'000'000);
  ASSERT_EQ(frame.scans.size(), 1u);
  EXPECT_EQ(frame.scans.at(0).stamp_ns, 300'000'000);
  EXPECT_EQ(frame.scans.at(0).T_world_lidar.translation(), Eigen::Vector3d(3, 6, 9));
  EXPECT_EQ(frame.scans.at(0).points, (std::vector<Eigen::Vector3f>{{4, -5, 6}}));
  EXPECT_EQ(frame.scans.at(0).intensity, std::vector<float>{0.5f});
  EXPECT_EQ(dataset.frame(0).scans.at(0).points.size(), 2u);
}

TEST_F(SmallDrive, FaultsAreOneLineEach) {
  const auto fault = [&] {
    return messageOf<InputError>([&] { openDataset(folder_ / "d.yaml"); });
  };
  writeText(folder_ / "drive/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt: 2 poses, none for scan 3"));
  writeText(folder_ / "drive/poses.txt", "1 0 0 0 0 2 0 0 0 0 1 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt:1: no rigid motion"));
  writeText(folder_ / "drive/poses.txt", "0 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt:1: 13 columns, expected 12"));
  fs::remove_all(folder_ / "drive/velodyne_points/data");
  fs::create_directories(folder_ / "drive/velodyne_points/data");
  EXPECT_THAT(fault(), HasSubstr("no files NNNNNNNNNN.bin in this folder"));
}

/// The median of some numbers.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.at(values.size() / 2);
}

TEST(KittiRaw, TheRealDriveHasSixtyFourLasersFromTheHighestDown) {
  const char* const root = std::getenv("HYDRABENCH_DATA");
  if (!root || !fs::exists(fs::path(root) / "lidar/kitti_raw_2011_09_26_udacity")) {
    GTEST_SKIP() << "no lidar/kitti_raw_2011_09_26_udacity; set HYDRABENCH_DATA";
  }
  const OpenedDataset opened =
      openDataset(fs::path(HYDRABENCH_SOURCE_DIR) / "configs/datasets/kitti_raw.yaml",
                  {"root=" + fs::absolute(root).string()});
  const Dataset& dataset = *opened.dataset;
  ASSERT_EQ(dataset.numFrames(), 11u);
  for (std::size_t i = 0; i < 11; ++i) {
    const LidarScan scan = dataset.frame(i).scans.at(0);
    EXPECT_EQ(scan.stamp_ns, 300'000'000 * static_cast<std::int64_t>(i));
    EXPECT_GT(scan.points.size(), 100'000u);
    ASSERT_EQ(scan.rings.size(), scan.points.size());
    // Far away the lasers, which are spread over the height of the sensor, look as if from one
    // place.
    std::vector<std::vector<double>> elevations(64);
    for (std::size_t k = 0; k < scan.points.size(); ++k) {
      const Eigen::Vector3d p = scan.points[k].cast<double>();
      if (p.norm() > 7) elevations[scan.rings[k]].push_back(std::asin(p.z() / p.norm()));
    }
    const double row = 1 / scan.lidar.rowsPerRadian();
    for (std::size_t ring = 1; ring < 40; ++ring) {
      ASSERT_GT(elevations[ring].size(), 100u) << ring;
      EXPECT_GT(median(elevations[ring - 1]), median(elevations[ring])) << ring;
    }
    EXPECT_NEAR(median(elevations[0]), scan.lidar.top_rad, row);
  }
}

TEST(KittiRaw, PosesPutTheScansOfTheRealDriveOntoEachOther) {
  const char* const root = std::getenv("HYDRABENCH_DATA");
  if (!root || !fs::exists(fs::path(root) / "lidar/kitti_raw_2011_09_26_udacity")) {
    GTEST_SKIP() << "no lidar/kitti_raw_2011_09_26_udacity; set HYDRABENCH_DATA";
  }
  const OpenedDataset opened =
      openDataset(fs::path(HYDRABENCH_SOURCE_DIR) / "configs/datasets/kitti_raw.yaml",
                  {"root=" + fs::absolute(root).string()});
  // The road around the car is at one height in both: scans 0 and 30, 7 m apart.
  std::vector<double> heights[2];
  for (const std::size_t i : {0u, 1u}) {
    const LidarScan scan = opened.dataset->frame(10 * i).scans.at(0);
    for (const Eigen::Vector3f& point : scan.points) {
      const Eigen::Vector3d p = scan.T_world_lidar * point.cast<double>();
      if (std::abs(p.x() - 12) < 2 && std::abs(p.y()) < 2) heights[i].push_back(p.z());
    }
    ASSERT_GT(heights[i].size(), 100u);
  }
  EXPECT_NEAR(median(heights[0]), median(heights[1]), 0.05);
  EXPECT_NEAR(median(heights[0]), -1.73, 0.15);
}

}  // namespace
}  // namespace hydrabench
