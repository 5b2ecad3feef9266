// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/object_reconstruction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/mapping/marching_cubes.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.25;
constexpr double kWallZ = 1.5;
constexpr std::uint16_t kId = 3;

/// A ball at (0, 0, 1) m in front of a wall, seen from `eye` along +z.
Frame ballFrame(const Vector3d& eye, std::int64_t stamp_ns) {
  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.camera = {96, 72, 90, 90, 47.5, 35.5};
  frame.T_world_camera.translation() = eye;
  frame.depth = Image<float>(96, 72);
  frame.color = Image<Rgb>(96, 72, Rgb{10, 20, 30});
  for (int v = 0; v < 72; ++v) {
    for (int u = 0; u < 96; ++u) {
      const Vector3d ray = frame.camera.backproject(u, v, 1);
      const Vector3d to_ball = Vector3d(0, 0, 1) - eye;
      const double along = ray.dot(to_ball) / ray.squaredNorm();
      const double gap2 = (to_ball - along * ray).squaredNorm();
      const double wall = kWallZ - eye.z();
      frame.depth(u, v) =
          static_cast<float>(gap2 < kRadius * kRadius
                                 ? along - std::sqrt((kRadius * kRadius - gap2) / ray.squaredNorm())
                                 : wall);
    }
  }
  return frame;
}

/// A track of the ball with the frames it was seen in.
struct Scene {
  Track track;
  FrameBuffer buffer{100};

  /// @param on_ball  whether the ball's pixels are the object's in this frame, or no one's
  /// @param u_end    from this column on they never are
  void see(const Vector3d& eye, bool on_ball = true, int u_end = 96) {
    const auto stamp = static_cast<std::int64_t>(track.observations.size() + 1);
    Frame frame = ballFrame(eye, stamp);
    Image<std::uint16_t> ids(96, 72);
    Observation observation;
    observation.stamp_ns = stamp;
    observation.candidate_id = kId;
    observation.region = {0, 0, 96, 72};
    for (int v = 0; v < 72; ++v) {
      for (int u = 0; u < 96; ++u) {
        if (frame.depth(u, v) > 1.1f) continue;
        if (on_ball && u < u_end) ids(u, v) = kId;
        observation.box.extend(frame.T_world_camera *
                               frame.camera.backproject(u, v, double{frame.depth(u, v)}));
      }
    }
    track.observations.push_back(observation);
    buffer.add(bufferedFrame(frame, ids));
  }
};

Scene ballFromThreeSides() {
  Scene scene;
  scene.see({0, 0, 0});
  scene.see({0.4, 0.1, 0.05});
  scene.see({-0.3, -0.2, 0});
  return scene;
}

std::optional<Mesh> reconstruct(const Scene& scene, const ObjectReconstruction::Config& config) {
  return ObjectReconstruction(config).reconstruct(std::array{scene.track}, scene.buffer, 0.1, 5)[0];
}

TEST(ObjectReconstruction, FindsTheSeenSideAndNothingElse) {
  const auto mesh = reconstruct(ballFromThreeSides(), {});
  ASSERT_TRUE(mesh);
  // Voxels are 2 % of half a metre: 1 cm. The wall is 0.25 m behind the ball.
  double worst = 0;
  for (const Vector3d& vertex : mesh->vertices) {
    worst = std::max(worst, std::abs((vertex - Vector3d(0, 0, 1)).norm() - kRadius));
  }
  EXPECT_LT(worst, 0.02);
  const Aabb box = bounds(*mesh);
  EXPECT_NEAR(box.min().z(), 0.75, 0.005);
  EXPECT_LT(box.max().z(), 1.05);  // the far side was never seen
  ASSERT_EQ(mesh->colors.size(), mesh->vertices.size());
  EXPECT_EQ(mesh->colors[0], (Rgb{10, 20, 30}));
}

TEST(ObjectReconstruction, FacesLookOutwards) {
  const auto mesh = reconstruct(ballFromThreeSides(), {});
  ASSERT_TRUE(mesh);
  std::size_t outward = 0;
  for (const Eigen::Vector3i& face : mesh->faces) {
    const Vector3d& a = mesh->vertices[static_cast<std::size_t>(face.x())];
    const Vector3d& b = mesh->vertices[static_cast<std::size_t>(face.y())];
    const Vector3d& c = mesh->vertices[static_cast<std::size_t>(face.z())];
    outward += (b - a).cross(c - a).dot(a - Vector3d(0, 0, 1)) > 0;
  }
  EXPECT_GT(outward, mesh->faces.size() * 19 / 20);
}

/// Corners of all faces, in an order of their own.
std::vector<std::array<double, 9>> sortedFaces(const std::vector<Vector3d>& corners) {
  std::vector<std::array<double, 9>> faces;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vector3d &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
    if (a == b || b == c || c == a) continue;
    faces.push_back({a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()});
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<Vector3d> cornersOf(const Mesh& mesh) {
  std::vector<Vector3d> corners;
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) corners.push_back(mesh.vertices[static_cast<std::size_t>(face[i])]);
  }
  return corners;
}

/// The same by the letter: every block of twice the extent, no block left out.
std::vector<std::array<double, 9>> plainFaces(const Scene& scene,
                                              const ObjectReconstruction::Config& config) {
  Aabb extent;
  for (const Observation& o : scene.track.observations) extent.extend(o.box);
  TsdfVolume::Config tsdf;
  tsdf.voxel_size_m = config.voxel_share * extent.sizes().maxCoeff();
  tsdf.truncation_m = config.truncation_voxels * tsdf.voxel_size_m;
  tsdf.voxels_per_side = config.voxels_per_side;
  tsdf.semantics.type = "binary";
  TsdfVolume volume(tsdf);
  const BlockIndex low = volume.grid().blockAt(extent.center() - extent.sizes());
  const BlockIndex high = volume.grid().blockAt(extent.center() + extent.sizes());
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) volume.allocate({x, y, z});
    }
  }
  const std::vector<BlockIndex> blocks = volume.blockIndices();
  for (const Observation& o : scene.track.observations) {
    const auto kept = scene.buffer.find(o.stamp_ns);
    SensorView view = sensorView(kept->frame, 0.1, 5);
    Image<Label> labels(96, 72);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      labels.data()[i] = kept->ids.data()[i] == o.candidate_id ? 1 : 0;
    }
    view.labels = &labels;
    TsdfIntegrator(config.integrator).integrateBlocks(view, blocks, volume);
  }
  std::vector<Vector3d> corners;
  for (const BlockIndex& index : blocks) {
    VoxelBlock& block = *volume.find(index);
    for (std::size_t i = 0; i < block.voxels.size(); ++i) {
      if (block.voxels[i].distance > 0) continue;
      const float confidence = block.semantics->share(i, 1).value_or(0.0f);
      if (confidence < config.min_confidence) {
        block.voxels[i].distance = static_cast<float>(tsdf.truncation_m);
      }
    }
  }
  for (const BlockIndex& index : blocks) {
    const TriangleSoup soup = marchingCubes(volume, index, config.mesh_min_weight);
    corners.insert(corners.end(), soup.vertices.begin(), soup.vertices.end());
  }
  return sortedFaces(corners);
}

TEST(ObjectReconstruction, LeavingOutBlocksChangesNothing) {
  const Scene scene = ballFromThreeSides();
  for (const char* interpolation : {"adaptive", "nearest", "bilinear"}) {
    for (const int side : {4, 8}) {
      ObjectReconstruction::Config config;
      config.integrator.interpolation = interpolation;
      config.voxels_per_side = side;
      const auto mesh = reconstruct(scene, config);
      ASSERT_TRUE(mesh);
      EXPECT_EQ(sortedFaces(cornersOf(*mesh)), plainFaces(scene, config))
          << interpolation << ' ' << side;
    }
  }
}

TEST(ObjectReconstruction, LeavingOutBlocksChangesNothingWhereTheObjectEndsOnASurface) {
  // Half the ball, and voxels several pixels wide: faces reach over the edge of the mask.
  Scene scene;
  scene.see({0, 0, 0}, true, 44);
  scene.see({0.1, 0, 0}, true, 40);
  ObjectReconstruction::Config config;
  for (const double share : {0.05, 0.1, 0.15}) {
    config.voxel_share = share;
    config.voxels_per_side = 2;
    const auto mesh = reconstruct(scene, config);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(sortedFaces(cornersOf(*mesh)), plainFaces(scene, config)) << share;
  }
}

TEST(ObjectReconstruction, SurfaceThatIsMostlyOthersIsClearedAway) {
  Scene half;  // 1 of 2 is not less than one half
  half.see({0, 0, 0}, true);
  half.see({0, 0, 0}, false);
  EXPECT_TRUE(reconstruct(half, {}));
  half.see({0, 0, 0}, false);  // 1 of 3
  EXPECT_FALSE(reconstruct(half, {}));
}

TEST(ObjectReconstruction, FramesThatLeftTheBufferAreMissing) {
  Scene scene = ballFromThreeSides();
  scene.buffer.keepOnly({1});
  const auto mesh = reconstruct(scene, {});
  ASSERT_TRUE(mesh);
  scene.buffer.keepOnly({});
  EXPECT_FALSE(reconstruct(scene, {}));
}

TEST(ObjectReconstruction, LimitsTheVolume) {
  const Scene scene = ballFromThreeSides();
  ObjectReconstruction::Config config;
  config.min_volume_m3 = 0.2;  // the seen part is about 0.5 x 0.5 x 0.2 m
  EXPECT_FALSE(reconstruct(scene, config));
  config.min_volume_m3 = 0;
  config.max_volume_m3 = 0.01;
  EXPECT_FALSE(reconstruct(scene, config));
}

TEST(ObjectReconstruction, TracksDoNotDependOnEachOtherOrOnThreads) {
  const Scene scene = ballFromThreeSides();
  Track shorter = scene.track;
  shorter.observations.pop_back();
  const ObjectReconstruction reconstruction({});
  setNumThreads(1);
  const auto one = reconstruction.reconstruct(std::array{shorter}, scene.buffer, 0.1, 5);
  setNumThreads(4);
  const auto both =
      reconstruction.reconstruct(std::array{scene.track, shorter}, scene.buffer, 0.1, 5);
  setNumThreads(0);
  ASSERT_TRUE(one[0] && both[0] && both[1]);
  EXPECT_EQ(one[0]->vertices, both[1]->vertices);
  EXPECT_EQ(one[0]->faces, both[1]->faces);
  EXPECT_EQ(one[0]->colors, both[1]->colors);
  EXPECT_NE(both[0]->vertices, both[1]->vertices);
}

}  // namespace
}  // namespace hydrabench
