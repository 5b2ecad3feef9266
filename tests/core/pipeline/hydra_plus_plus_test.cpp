// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/hydra_plus_plus.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/candidate_io.h"
#include "core/graph/spark_dsg_json.h"
#include "core/parallel/parallel_for.h"
#include "tests/support/miniature_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Path = MiniatureWorld::Path;
namespace label = miniature_label;

/// The world box around the points of the mask, in the best view or in all views.
class BoxEstimator : public ShapeEstimator {
 public:
  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override {
    if (before) before();
    Aabb box = boxOf(best);
    for (const ShapeObservation& other : others) box.extend(boxOf(other));
    ++calls;
    seeds ^= seed;
    num_others = others.size();
    ShapeOutcome outcome;
    outcome.times.add("box", {1.0, 1.0});
    if (box.volume() < min_volume_m3) {
      outcome.failure = "too flat";
      return outcome;
    }
    ShapeEstimate& estimate = outcome.estimate.emplace();
    estimate.scale = 0.5 * box.sizes().maxCoeff();
    estimate.T_camera_object =
        best.T_world_camera.inverse() * Eigen::Translation3d(box.center() + shift);
    const Vector3d half = 0.5 * box.sizes() / estimate.scale;
    estimate.mesh = boxMesh(Aabb(-half, half));
    return outcome;
  }
  int maxOtherViews() const override { return other_views; }

  std::function<void()> before;
  Vector3d shift = Vector3d::Zero();
  double min_volume_m3 = 0;
  int other_views = 0;
  mutable std::atomic<int> calls = 0;
  mutable std::atomic<std::uint64_t> seeds = 0;
  mutable std::atomic<std::size_t> num_others = 0;

 private:
  static Aabb boxOf(const ShapeObservation& view) {
    Aabb box;
    for (int v = 0; v < view.camera.height; ++v) {
      for (int u = 0; u < view.camera.width; ++u) {
        const float z = view.depth(u, v);
        if (view.mask(u, v) && z > 0) {
          box.extend(view.T_world_camera * view.camera.backproject(u, v, z));
        }
      }
    }
    return box;
  }
};

HydraPlusPlus::Config quick() {
  HydraPlusPlus::Config config;
  config.tracker.min_observations = 3;  // an object needs 4
  return config;
}

Path then(Path first, const Path& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}
std::int64_t after(const Path& path) { return path.back().stamp_ns + kMiniaturePeriodNs; }

/// A room with a bin at the origin.
MiniatureWorld roomWithBin() {
  MiniatureWorld world;
  world.addRoom(7, 7, 2.5);
  world.add(standingBox(0.4, 0.4, 0.6), label::kBin, 1);
  world.shuffleInstanceIds();
  return world;
}
Path atBin(int num_views, std::int64_t start_ns = kMiniatureStartNs) {
  return stillPath({1.6, 0.9, 1.5}, {0, 0, 0.3}, num_views, start_ns);
}
Path away(int num_views, std::int64_t start_ns) {
  return stillPath({1.6, 0.9, 1.5}, {3.4, 0, 1.5}, num_views, start_ns);
}

struct Mapped {
  SceneGraph graph;
  std::vector<ShapeCandidate> candidates;
  std::vector<std::string> notes;
  std::vector<std::string> stages;
};
Mapped drive(MiniatureWorld& world, const Path& path, const HydraPlusPlus::Config& config,
             std::shared_ptr<const ShapeEstimator> estimator = std::make_shared<BoxEstimator>()) {
  HydraPlusPlus method(config, miniatureLabelSpace(), std::move(estimator));
  Mapped run;
  run.graph = world.drive(path, method);
  run.notes = method.notes();
  for (const auto& stage : method.stageTimes().stages()) run.stages.push_back(stage.name);
  run.candidates = method.takeCandidates();
  return run;
}

/// Three objects in a row, seen one after the other; the tracks of the first end on the way.
MiniatureWorld row() {
  MiniatureWorld world;
  world.addRoom(20, 5, 2.5);
  for (int i = 0; i < 3; ++i) {
    world.add(transformed(pose(-6 + 6.0 * i, 0, 0, 0.3), standingBox(0.5, 0.4, 0.7)), label::kBin,
              i + 1);
  }
  world.shuffleInstanceIds();
  return world;
}
Path alongRow() { return straightPath({-8, 1.8, 1.3}, {8, 1.8, 1.3}, {0, -40, 0.3}, 32); }
HydraPlusPlus::Config shortWindow() {
  HydraPlusPlus::Config config = quick();
  config.tracker.temporal_window_s = 0.5;
  return config;
}

std::string bytesOf(const Mapped& run) {
  const TemporaryFolder folder;
  Prediction prediction;
  prediction.graph = run.graph;
  prediction.notes = run.notes;
  prediction.candidates = run.candidates;
  writePrediction(folder / "out", prediction);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out")) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::string bytes;
  for (const auto& file : files) bytes += file.filename().string() + "\n" + readText(file);
  return bytes;
}

TEST(HydraPlusPlus, OneObjectSeenGivesOneNode) {
  MiniatureWorld world = roomWithBin();
  const Mapped run = drive(world, atBin(10), quick());
  ASSERT_EQ(run.graph.objects.size(), 1u);
  const ObjectNode& bin = run.graph.objects[0];
  EXPECT_EQ(bin.label, label::kBin);
  EXPECT_EQ(bin.name, "bin");
  EXPECT_LT((bin.box.min() - Vector3d(-0.2, -0.2, 0)).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LT((bin.box.max() - Vector3d(0.2, 0.2, 0.6)).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_NEAR(bin.scale, 0.3, 0.02);
  EXPECT_LT((bin.T_world_object.translation() - bin.box.center()).norm(), 1e-6);
  EXPECT_LT(rotationAngle(bin.T_world_object.linear(), Eigen::Matrix3d::Identity()), 1e-9);
  EXPECT_EQ(bin.first_observed_ns, kMiniatureStartNs);
  EXPECT_EQ(bin.last_observed_ns, kMiniatureStartNs + 9 * kMiniaturePeriodNs);
  EXPECT_GT(run.graph.scene_mesh.faces.size(), 100u);

  ASSERT_EQ(run.candidates.size(), 1u);
  const ShapeCandidate& candidate = run.candidates[0];
  EXPECT_TRUE(candidate.accepted);
  EXPECT_EQ(candidate.object, bin.id);
  EXPECT_EQ(candidate.observations, 10u);
  EXPECT_GT(candidate.overlap, 0.85);
  EXPECT_GT(candidate.coverage, 0.85);
  EXPECT_LT(*candidate.depth_residual_m, 0.05);
  EXPECT_THAT(run.notes,
              ElementsAre(HasSubstr("shapes: 1 of 1 accepted, in 1 objects; rejected: none"),
                          HasSubstr("no shape asked for: ")));
  EXPECT_THAT(run.stages,
              ::testing::IsSupersetOf({"motion", "candidates", "track", "integrate", "views",
                                       "mesh", "estimate", "estimate.box", "rmcc"}));
}

TEST(HydraPlusPlus, ATrackSeenTooBrieflyIsNotAskedFor) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  const Mapped run = drive(world, atBin(3), quick(), estimator);
  EXPECT_THAT(run.graph.objects, IsEmpty());
  EXPECT_THAT(run.candidates, IsEmpty());
  EXPECT_EQ(estimator->calls, 0);
  EXPECT_THAT(run.notes[1], HasSubstr("1 tracks seen too briefly"));
}

TEST(HydraPlusPlus, TheShapeIsThatOfTheViewWithTheLargestBox) {
  // From afar and near the floor first, then from above, where top and two sides are seen.
  MiniatureWorld world = roomWithBin();
  Path path = stillPath({3.2, 0, 0.3}, {0, 0, 0.3}, 6);
  path = then(path, atBin(6, after(path)));
  path = then(path, stillPath({3.2, 0, 0.3}, {0, 0, 0.3}, 6, after(path)));
  const Mapped run = drive(world, path, quick());
  ASSERT_EQ(run.candidates.size(), 1u);
  EXPECT_EQ(run.candidates[0].view_stamp_ns, path[6].stamp_ns);
  EXPECT_EQ(run.candidates[0].T_world_camera.matrix(), path[6].T_world_camera.matrix());
  EXPECT_GT(run.candidates[0].mask.size(), 400u);
}

TEST(HydraPlusPlus, ARejectedShapeIsDroppedOrReplacedByWhatWasSeen) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->shift = Vector3d(0, 0, 0.9);  // above itself
  const Mapped dropped = drive(world, atBin(10), quick(), estimator);
  EXPECT_THAT(dropped.graph.objects, IsEmpty());
  ASSERT_EQ(dropped.candidates.size(), 1u);
  EXPECT_EQ(dropped.candidates[0].reason, "overlap");
  EXPECT_FALSE(dropped.candidates[0].mesh.empty());
  EXPECT_THAT(dropped.notes[0], HasSubstr("rejected: 1 overlap"));

  HydraPlusPlus::Config config = quick();
  config.decision.rejected = "partial_mesh";
  const Mapped replaced = drive(world, atBin(10), config, estimator);
  ASSERT_EQ(replaced.graph.objects.size(), 1u);
  const Aabb& box = replaced.graph.objects[0].box;
  EXPECT_NEAR(box.max().z(), 0.6, 0.03);
  EXPECT_NEAR(box.max().x(), 0.2, 0.03);
  EXPECT_FALSE(replaced.candidates[0].accepted);

  config.decision.rmcc.check = "none";
  EXPECT_NEAR(drive(world, atBin(10), config, estimator).graph.objects[0].box.max().z(), 1.5, 0.03);
}

TEST(HydraPlusPlus, AnEstimatorWithoutAnEstimateIsCounted) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->min_volume_m3 = 100;
  const Mapped run = drive(world, atBin(10), quick(), estimator);
  EXPECT_THAT(run.graph.objects, IsEmpty());
  ASSERT_EQ(run.candidates.size(), 1u);
  EXPECT_EQ(run.candidates[0].failure, "too flat");
  EXPECT_THAT(run.notes[0], HasSubstr("rejected: 1 failure: too flat"));
}

TEST(HydraPlusPlus, AnEstimateThatIsNotFiniteIsNone) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->shift.x() = std::numeric_limits<double>::quiet_NaN();
  const Mapped run = drive(world, atBin(10), quick(), estimator);
  EXPECT_THAT(run.graph.objects, IsEmpty());
  EXPECT_EQ(run.candidates.at(0).failure, "unusable estimate");
}

TEST(HydraPlusPlus, WhatTheEstimatorThrowsReachesTheCaller) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->before = [] { throw std::runtime_error("no memory on the device"); };
  HydraPlusPlus method(quick(), miniatureLabelSpace(), estimator);
  EXPECT_THROW(world.drive(atBin(10), method), std::runtime_error);
}

TEST(HydraPlusPlus, AnObjectSeenAgainLaterIsOneNode) {
  MiniatureWorld world = roomWithBin();
  HydraPlusPlus::Config config = shortWindow();
  Path path = atBin(8);
  path = then(path, away(14, after(path)));
  path = then(path, stillPath({-1.6, 0.9, 1.2}, {0, 0, 0.3}, 8, after(path)));
  const Mapped merged = drive(world, path, config);
  ASSERT_EQ(merged.candidates.size(), 2u);
  ASSERT_EQ(merged.graph.objects.size(), 1u);
  EXPECT_EQ(merged.graph.objects[0].first_observed_ns, path.front().stamp_ns);
  EXPECT_EQ(merged.graph.objects[0].last_observed_ns, path.back().stamp_ns);
  EXPECT_EQ(merged.candidates[0].object, merged.candidates[1].object);
  config.decision.merge_revisited = false;
  EXPECT_EQ(drive(world, path, config).graph.objects.size(), 2u);
}

TEST(HydraPlusPlus, WhatMovesGivesNoShape) {
  MiniatureWorld world;
  world.addRoom(7, 7, 2.5);
  // Stands until space around it is known to be free, then crosses the view at 1.2 m/s.
  world.add(transformed(pose(0, -2.4, 0, 0), standingBox(0.5, 0.5, 0.9)), label::kBin, 1,
            [](std::int64_t stamp_ns) {
              const double t = std::max(0.0, 1e-9 * double(stamp_ns - kMiniatureStartNs) - 3);
              return pose(0, 1.2 * t, 0, 0);
            });
  HydraPlusPlus::Config config = quick();
  config.motion.min_pixels = 20;
  const Mapped run = drive(world, stillPath({2.8, 0, 1.6}, {0, 0, 0.4}, 65), config);
  for (const ShapeCandidate& candidate : run.candidates) {
    EXPECT_LT(candidate.last_observed_ns, kMiniatureStartNs + 4'000'000'000);  // while it stood
  }
  EXPECT_THAT(run.notes[1], ::testing::Not(HasSubstr(" 0 moving")));
}

TEST(HydraPlusPlus, WorkersAndThreadsChangeNoByte) {
  MiniatureWorld world = row();
  HydraPlusPlus::Config config = shortWindow();
  config.decision.rejected = "partial_mesh";
  const auto estimator = std::make_shared<BoxEstimator>();
  std::atomic<int> call = 0;
  const Mapped one = drive(world, alongRow(), config, estimator);
  EXPECT_EQ(one.candidates.size(), 3u);
  EXPECT_EQ(one.graph.objects.size(), 3u);
  estimator->before = [&call] {  // later jobs overtake earlier ones
    std::this_thread::sleep_for(std::chrono::milliseconds(call++ % 2 == 0 ? 40 : 0));
  };
  config.estimation.workers = 3;
  config.estimation.queue = 1;
  setNumThreads(3);
  const Mapped three = drive(world, alongRow(), config, estimator);
  setNumThreads(0);
  EXPECT_EQ(bytesOf(one), bytesOf(three));
  EXPECT_EQ(estimator->seeds, 0u);  // each track's was drawn twice
  config.estimation.workers = 0;    // on the mapping thread
  EXPECT_EQ(bytesOf(one), bytesOf(drive(world, alongRow(), config, estimator)));
}

TEST(HydraPlusPlus, ASlowEstimatorDoesNotHoldUpMapping) {
  // Every track ends while the estimator stands still at the first of them.
  MiniatureWorld world = row();
  const auto estimator = std::make_shared<BoxEstimator>();
  std::atomic<bool> open = false;
  estimator->before = [&] {
    while (!open) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  HydraPlusPlus method(shortWindow(), miniatureLabelSpace(), estimator);
  for (const MiniatureWorld::View& view : alongRow()) {
    method.process(world.frame(view.T_world_camera, view.stamp_ns));
  }
  EXPECT_EQ(estimator->calls, 0);
  open = true;
  EXPECT_EQ(method.finish().objects.size(), 3u);
}

TEST(HydraPlusPlus, KeepsFewFramesOfALongTrack) {
  MiniatureWorld world = roomWithBin();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->other_views = 4;
  HydraPlusPlus method(quick(), miniatureLabelSpace(), estimator);
  const Path path = orbitPath({0, 0, 0.3}, 1.7, 1.3, 60);
  for (const MiniatureWorld::View& view : path) {
    method.process(world.frame(view.T_world_camera, view.stamp_ns));
    EXPECT_LE(method.numKeptFrames(), 5u);
  }
  EXPECT_EQ(method.finish().objects.size(), 1u);
  EXPECT_GE(estimator->num_others, 2u);
  EXPECT_LE(estimator->num_others, 4u);
}

TEST(HydraPlusPlus, DecidingAfterwardsGivesWhatARunWithThoseKeysGives) {
  MiniatureWorld world = row();
  const auto estimator = std::make_shared<BoxEstimator>();
  estimator->shift = Vector3d(0.1, 0, 0.1);
  HydraPlusPlus::Config config = shortWindow();
  const TemporaryFolder folder;
  writeCandidates(folder.path(), drive(world, alongRow(), config, estimator).candidates);
  const std::vector<ShapeCandidate> candidates = readCandidates(folder.path());
  for (const double min_overlap : {0.0, candidates.at(1).overlap, 1.0}) {
    config.decision.rmcc.min_overlap = min_overlap;
    const Mapped run = drive(world, alongRow(), config, estimator);
    const auto nodes =
        objectNodes(candidates, decide(candidates, config.decision), miniatureLabelSpace());
    ASSERT_EQ(nodes.size(), run.graph.objects.size()) << min_overlap;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_EQ(nodes[i].id, run.graph.objects[i].id);
      EXPECT_EQ(nodes[i].mesh.vertices, run.graph.objects[i].mesh.vertices);
      EXPECT_EQ(nodes[i].T_world_object.matrix(), run.graph.objects[i].T_world_object.matrix());
    }
  }
}

TEST(HydraPlusPlus, TheScoresCanBeMadeAgainFromTheRecord) {
  MiniatureWorld world = roomWithBin();
  const Mapped run = drive(world, atBin(10), quick());
  const ShapeCandidate& candidate = run.candidates.at(0);
  const Image<std::uint8_t> projected = projectedMask(
      transformed(candidate.T_world_camera.inverse(), candidate.mesh), candidate.camera, {});
  std::size_t both = 0, all = 0;
  for (int v = 0; v < projected.height(); ++v) {
    for (int u = 0; u < projected.width(); ++u) {
      if (projected(u, v) == 0) continue;
      ++all;
      const int mask_u = u - candidate.mask_u;
      const int mask_v = v - candidate.mask_v;
      both += candidate.mask.contains(mask_u, mask_v) && candidate.mask(mask_u, mask_v);
    }
  }
  EXPECT_EQ(candidate.overlap, static_cast<double>(both) / static_cast<double>(all));
}

}  // namespace
}  // namespace hydrabench
