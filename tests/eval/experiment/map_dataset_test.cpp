// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/map_dataset.h"

#include <atomic>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

/// Ten empty frames, 100 ms apart, that count how often they are made.
class CountingDataset : public Dataset {
 public:
  std::string name() const override { return "counting"; }
  const LabelSpace& labelSpace() const override { return label_space_; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return 10; }
  Frame frame(std::size_t index) const override {
    ++frames_made;
    Frame frame;
    frame.stamp_ns = static_cast<std::int64_t>(index) * 100'000'000;
    return frame;
  }
  const GroundTruth& groundTruth() const override { return truth_; }
  mutable std::atomic<int> frames_made = 0;

 private:
  LabelSpace label_space_;
  Camera camera_;
  GroundTruth truth_;
};

/// Puts one object per frame into its graph; throws at a frame of choice.
class CountingMethod : public MappingSystem {
 public:
  explicit CountingMethod(std::size_t throw_at) : throw_at_(throw_at) {}
  void process(const Frame&) override {
    const StageTimes::Scope scope(times_, "count");
    if (frames_++ == throw_at_) throw std::runtime_error("out of luck");
  }
  SceneGraph finish() override {
    SceneGraph graph;
    for (std::size_t i = 0; i < frames_; ++i) {
      ObjectNode node;
      node.id = objectNodeId(i);
      node.box = Aabb(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
      graph.objects.push_back(node);
    }
    return graph;
  }
  const StageTimes& stageTimes() const override { return times_; }
  std::vector<std::string> notes() const override { return {"counts"}; }

 private:
  std::size_t throw_at_;
  std::size_t frames_ = 0;
  StageTimes times_;
};

MethodConfig counting(const std::string& name, std::size_t throw_at = 1000) {
  MethodConfig method;
  method.name = name;
  method.resolved_config = "type: counting\n";
  method.start = [=](const Dataset&) { return std::make_unique<CountingMethod>(throw_at); };
  return method;
}

TEST(MapDataset, MakesEachFrameOnceForAllMethods) {
  const CountingDataset dataset;
  const DatasetRun run = mapDataset(dataset, {counting("a"), counting("b")}, 0);
  EXPECT_EQ(dataset.frames_made, 10);
  ASSERT_EQ(run.methods.size(), 2u);
  for (const MethodRun& method : run.methods) {
    EXPECT_EQ(method.prediction->graph.objects.size(), 10u);
    EXPECT_EQ(method.prediction->notes, std::vector<std::string>{"counts"});
  }
  EXPECT_DOUBLE_EQ(run.frame_period_s, 0.1);
}

TEST(MapDataset, TimesAYardstickBesideEveryFrame) {
  const DatasetRun run = mapDataset(CountingDataset(), {counting("a"), counting("b")}, 0);
  for (const MethodRun& method : run.methods) {
    ASSERT_EQ(method.frame_times.wall_ms.size(), 10u);
    ASSERT_EQ(method.frame_times.yardstick_ms.size(), 10u);
    EXPECT_THAT(method.frame_times.yardstick_ms, testing::Each(testing::Gt(0)));
  }
}

TEST(MapDataset, AMethodThatThrowsLeavesTheOthersAlone) {
  const DatasetRun run = mapDataset(CountingDataset(), {counting("bad", 3), counting("good")}, 0);
  EXPECT_FALSE(run.methods[0].prediction);
  EXPECT_EQ(run.methods[0].failure, "out of luck");
  EXPECT_EQ(run.methods[1].prediction->graph.objects.size(), 10u);
}

TEST(MapDataset, StopsAfterTheFramesAskedFor) {
  const CountingDataset dataset;
  const DatasetRun run = mapDataset(dataset, {counting("a")}, 4);
  EXPECT_EQ(dataset.frames_made, 4);
  EXPECT_EQ(run.methods[0].prediction->graph.objects.size(), 4u);
}

TEST(MapDataset, ARunIsAPredictionFolderWithTimesAndConfig) {
  const TemporaryFolder folder;
  const DatasetRun run = mapDataset(CountingDataset(), {counting("a")}, 0);
  fillRunFolder(folder / "a", run.methods[0]);
  const Prediction read = readPrediction(folder / "a");
  EXPECT_EQ(read.method, "a");
  EXPECT_EQ(read.notes, std::vector<std::string>{"counts"});
  EXPECT_EQ(read.graph.objects.size(), 10u);
  EXPECT_TRUE(std::filesystem::exists(folder / "a/timing.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "a/config.yaml"));
}

}  // namespace
}  // namespace hydrabench
