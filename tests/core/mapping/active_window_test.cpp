// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/active_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 10 * kSecond;

/// A camera at (x, 0, 0) that looks along +y at a wall `depth` away.
Frame wall(double x, std::int64_t stamp_ns, float depth = 2) {
  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.camera = {64, 48, 40, 40, 31.5, 23.5};
  frame.T_world_camera = lookAt({x, 0, 0}, {x, 1, 0});
  frame.depth = Image<float>(64, 48, depth);
  frame.labels = Image<Label>(64, 48, 7);
  return frame;
}

void integrate(ActiveWindow& window, const Frame& frame) {
  window.integrate(sensorView(frame, 0.1, 5));
}

TEST(ActiveWindow, MeshesTheWallItSees) {
  ActiveWindow window{{}};
  integrate(window, wall(0, kStart));
  EXPECT_TRUE(window.mesh().mesh().empty());
  window.update(kStart, {0, 0, 0});
  std::vector<Label> labels;
  const Mesh mesh = window.mesh().mesh(&labels);
  ASSERT_GT(mesh.faces.size(), 500u);
  for (const Eigen::Vector3d& p : mesh.vertices) EXPECT_NEAR(p.y(), 2, 0.02);
  EXPECT_THAT(labels, testing::Each(7));
  EXPECT_EQ(analyzeTopology(mesh).components, 1u);
}

TEST(ActiveWindow, KeepsWhatIsSolidIfAskedTo) {
  for (const bool keep : {false, true}) {
    ActiveWindow::Config config;
    config.keep_occupied = keep;
    ActiveWindow window(config);
    integrate(window, wall(0, kStart));
    window.finish();
    const std::vector<Eigen::Vector3f> occupied = window.takeOccupied();
    EXPECT_EQ(occupied.empty(), !keep);
    // Behind the wall, up to the truncation distance of 0.3 m along the ray.
    for (const Eigen::Vector3f& p : occupied) {
      EXPECT_GT(p.y(), 2);
      EXPECT_LT(p.y(), 2.3);
    }
  }
}

TEST(ActiveWindow, UpdatesAtTheGivenSeparation) {
  ActiveWindow window{{}};  // 0.2 s
  EXPECT_TRUE(window.updateDue(kStart));
  window.update(kStart, {0, 0, 0});
  EXPECT_FALSE(window.updateDue(kStart + 100'000'000));
  EXPECT_TRUE(window.updateDue(kStart + 199'999'990));  // stamps jitter
  EXPECT_TRUE(window.updateDue(kStart + 200'000'000));
}

TEST(ActiveWindow, ArchivesBySpaceWhatIsFarAndNotUpdatedInThisFrame) {
  ActiveWindow window{{}};  // 8 m
  integrate(window, wall(0, kStart));
  EXPECT_TRUE(window.update(kStart, {0, 0, 0}).empty());
  EXPECT_TRUE(window.update(kStart, {0, -50, 0}).empty());  // updated in this very frame
  const std::size_t num_faces = window.mesh().mesh().faces.size();
  const std::vector<BlockIndex> blocks = window.volume().blockIndices();
  EXPECT_EQ(window.update(kStart + kSecond, {0, -50, 0}), blocks);
  EXPECT_EQ(window.volume().numBlocks(), 0u);
  EXPECT_TRUE(window.mesh().activeVertices().empty());
  EXPECT_EQ(window.mesh().mesh().faces.size(), num_faces);
}

TEST(ActiveWindow, KeepsBySpaceWhatIsNearHoweverOld) {
  ActiveWindow window{{}};
  integrate(window, wall(0, kStart));
  EXPECT_TRUE(window.update(kStart + 1000 * kSecond, {0, 0, 0}).empty());
}

TEST(ActiveWindow, ArchivesByTimeWhatWasNotObservedForTheWindow) {
  ActiveWindow::Config config;
  config.archive = "temporal";
  ActiveWindow window(config);  // 3 s
  integrate(window, wall(0, kStart));
  integrate(window, wall(20, kStart + 2 * kSecond));
  const std::size_t num_blocks = window.volume().numBlocks();
  EXPECT_TRUE(window.update(kStart + 3 * kSecond, {20, 0, 0}).empty());
  const std::vector<BlockIndex> left = window.update(kStart + 4 * kSecond, {20, 0, 0});
  EXPECT_EQ(left.size() + window.volume().numBlocks(), num_blocks);
  ASSERT_FALSE(left.empty());
  for (const BlockIndex& block : left)
    EXPECT_LT(window.volume().grid().centerOfBlock(block).x(), 10);
  EXPECT_FALSE(window.mesh().activeVertices().empty());
}

TEST(ActiveWindow, TakesTheMeshOfWhatChangedLastBeforeItArchives) {
  ActiveWindow window{{}};
  integrate(window, wall(0, kStart));
  EXPECT_FALSE(window.update(kStart + kSecond, {0, -50, 0}).empty());
  EXPECT_GT(window.mesh().mesh().faces.size(), 500u);
}

TEST(ActiveWindow, MeshesCubesThatReachIntoAChangedBlockAnew) {
  // The second camera stands at the border of two blocks and sees the right one only, where the
  // wall has moved a little. The cubes across the border belong to the block at the left.
  Frame right = wall(0.02, kStart + kSecond, 2.04f);
  right.camera.cx = 0;
  ActiveWindow stepwise{{}};
  ActiveWindow at_once{{}};
  integrate(stepwise, wall(0, kStart));
  stepwise.update(kStart, {0, 0, 0});
  integrate(stepwise, right);
  integrate(at_once, wall(0, kStart));
  integrate(at_once, right);
  for (const BlockIndex& block : stepwise.volume().blockIndices()) {
    const VoxelBlock* changed = stepwise.volume().find(block);
    EXPECT_EQ(changed->mesh_outdated, block.x() >= 0) << block.transpose();
  }
  stepwise.update(right.stamp_ns, {0, 0, 0});
  at_once.update(right.stamp_ns, {0, 0, 0});
  const Mesh mesh = stepwise.mesh().mesh();
  EXPECT_EQ(mesh.vertices, at_once.mesh().mesh().vertices);
  EXPECT_EQ(mesh.faces, at_once.mesh().mesh().faces);
}

double area(const Mesh& mesh) {
  double twice = 0;
  for (const Eigen::Vector3i& face : mesh.faces) {
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(face[k])]; };
    twice += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return twice / 2;
}

/// Area of the wall after a drive along 8 m of it, in steps of 0.1 s.
double areaAfterDrive(const ActiveWindow::Config& config, double direction) {
  ActiveWindow window(config);
  for (int i = 0; i < 60; ++i) {
    const Frame frame = wall(direction * (-4 + 8 * i / 59.0), kStart + i * kSecond / 10);
    integrate(window, frame);
    if (window.updateDue(frame.stamp_ns)) {
      window.update(frame.stamp_ns, frame.T_world_camera.translation());
    }
  }
  window.finish();
  return area(window.mesh().mesh());
}

TEST(ActiveWindow, LeavesNoCrackWhereBlocksLeaveWhicheverWayTheRobotDrives) {
  ActiveWindow::Config all;
  all.radius_m = 100;
  ActiveWindow::Config spatial;
  spatial.radius_m = 3;
  ActiveWindow::Config temporal;
  temporal.archive = "temporal";
  temporal.window_s = 0.5;
  for (const double direction : {1.0, -1.0}) {
    const double whole = areaAfterDrive(all, direction);
    // 8 m and the half images at the ends; a lost row of cubes would have 0.2 m^2.
    EXPECT_NEAR(whole, (8 + 2 * 1.575) * 2 * 1.175, 1.5);
    EXPECT_NEAR(areaAfterDrive(spatial, direction), whole, 0.01) << direction;
    EXPECT_NEAR(areaAfterDrive(temporal, direction), whole, 0.01) << direction;
  }
}

/// With three blocks along x: A [-1.6, 0) is seen all the time, B [0, 1.6) and C [1.6, 3.2) once.
class Border : public ::testing::Test {
 protected:
  Border() : window_(temporal()) {
    integrate(window_, wall(1.6, kStart));
    see(-2, 1);
    see(-2, 4);
  }
  static ActiveWindow::Config temporal() {
    ActiveWindow::Config config;
    config.archive = "temporal";  // 3 s
    return config;
  }
  void see(double x, int time_s, double focal = 40) {
    Frame frame = wall(x, kStart + time_s * kSecond);
    frame.camera.fx = focal;
    integrate(window_, frame);
    window_.update(frame.stamp_ns, {x, 0, 0});
  }
  bool exists(int x) const { return window_.volume().find({x, 1, 0}) != nullptr; }
  /// Triangles with their middle between two x.
  std::size_t facesBetween(double low, double high) const {
    const Mesh mesh = window_.mesh().mesh();
    std::size_t count = 0;
    for (const Eigen::Vector3i& face : mesh.faces) {
      double x = 0;
      for (int k = 0; k < 3; ++k) x += mesh.vertices[static_cast<std::size_t>(face[k])].x() / 3;
      count += x > low && x < high;
    }
    return count;
  }
  /// Those of the cubes between B and C.
  std::size_t facesAcross() const { return facesBetween(1.55, 1.65); }
  ActiveWindow window_;
};

TEST_F(Border, ABlockStaysWhileALowerNeighborIsInTheWindow) {
  EXPECT_TRUE(exists(-1));
  EXPECT_TRUE(exists(0));
  EXPECT_FALSE(exists(1)) << "its lower neighbour left too";
  window_.update(kStart + 8 * kSecond, {-2, 0, 0});
  EXPECT_EQ(window_.volume().numBlocks(), 0u);
}

TEST_F(Border, ABlockThatIsSeenAgainKeepsItsCubesThatReachIntoAnArchivedOne) {
  const std::size_t across = facesAcross();
  EXPECT_GT(across, 20u);
  see(0.8, 5, 100);  // B alone
  EXPECT_FALSE(exists(1));
  EXPECT_EQ(facesAcross(), across);
}

TEST_F(Border, ABlockThatLeftIsNotMeshedAgainForItsNeighbor) {
  const std::size_t across = facesAcross();
  const std::size_t inside = facesBetween(0.2, 1.4);
  see(2.6, 5, 100);  // C alone, without the border
  EXPECT_TRUE(exists(1));
  EXPECT_EQ(facesAcross(), across);
  EXPECT_EQ(facesBetween(0.2, 1.4), inside);
}

TEST(ActiveWindow, RefusesAPoseWhoseVerticesCannotBeNumbered) {
  ActiveWindow window{{}};  // 5 mm: 2^30 cells are 5.4e6 m
  EXPECT_NO_THROW(integrate(window, wall(5e6, kStart)));
  EXPECT_THROW(integrate(window, wall(2e7, kStart)), InputError);
}

TEST(ActiveWindow, KeepsOfAPlaceSeenAgainFromAfarWhatWasSeenFromNear) {
  const auto nearest = [](const std::string& revisited) {
    ActiveWindow::Config config;
    config.revisited = revisited;
    ActiveWindow window(config);
    for (int i = 0; i < 3; ++i) integrate(window, wall(0, kStart));
    window.update(kStart, {0, 0, 0});
    integrate(window, wall(50, kStart + 60 * kSecond));
    window.update(kStart + 60 * kSecond, {50, 0, 0});    // the first place has left
    Frame afar = wall(0, kStart + 120 * kSecond, 4.4F);  // 10 cm too near
    afar.T_world_camera = lookAt({0, -2.5, 0}, {0, 0, 0});
    integrate(window, afar);
    window.finish();
    double least = 10;
    for (const Eigen::Vector3d& p : window.mesh().mesh().vertices) {
      if (std::abs(p.x()) < 1.4 && std::abs(p.z()) < 0.8) least = std::min(least, p.y());
    }
    return least;
  };
  EXPECT_NEAR(nearest("both"), 1.9, 0.02);
  EXPECT_NEAR(nearest("best"), 2, 0.02);
}

TEST(ActiveWindow, FinishFreezesAllThatIsLeft) {
  ActiveWindow window{{}};
  integrate(window, wall(0, kStart));
  window.finish();
  EXPECT_EQ(window.volume().numBlocks(), 0u);
  EXPECT_TRUE(window.mesh().activeVertices().empty());
  EXPECT_GT(window.mesh().mesh().faces.size(), 500u);
}

TEST(ActiveWindow, TracksFreeSpaceOnlyIfAsked) {
  for (const bool track : {false, true}) {
    ActiveWindow::Config config;
    config.track_freespace = track;
    ActiveWindow window(config);
    integrate(window, wall(0, kStart));
    bool any = false;
    for (const BlockIndex& block : window.volume().blockIndices()) {
      any = any || !window.volume().find(block)->freespace.empty();
    }
    EXPECT_EQ(any, track);
  }
}

TEST(ActiveWindow, GivesTheSameMeshForAnyNumberOfThreads) {
  std::vector<Mesh> meshes;
  for (int threads : {1, 2}) {
    setNumThreads(threads);
    ActiveWindow window{{}};
    for (int i = 0; i < 5; ++i) {
      integrate(window, wall(0.4 * i, kStart + i * kSecond));
      window.update(kStart + i * kSecond, {0, 0, 0});
    }
    meshes.push_back(window.mesh().mesh());
  }
  setNumThreads(0);
  EXPECT_EQ(meshes[0].vertices, meshes[1].vertices);
  EXPECT_EQ(meshes[0].faces, meshes[1].faces);
  EXPECT_EQ(meshes[0].colors, meshes[1].colors);
}

}  // namespace
}  // namespace hydrabench
