// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/study.h"

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/experiment/plan.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class ReadStudy : public ::testing::Test {
 protected:
  ReadStudy() {
    const std::filesystem::path configs = std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs";
    writeText(
        folder_ / "base.yaml",
        "name: base\ndatasets:\n  - config: " + (configs / "datasets/office_quick.yaml").string() +
            "\n    seeds: [1, 2]\nmethods:\n  - config: " +
            (configs / "methods/hydra.yaml").string() +
            "\n  - config: " + (configs / "methods/oracle_shape.yaml").string() + "\n");
  }
  Study read(const std::string& yaml, const std::vector<std::string>& overrides = {}) {
    writeText(folder_ / "sweep.yaml", "experiment: base.yaml\n" + yaml);
    return readStudy(folder_ / "sweep.yaml", overrides);
  }
  void expectFault(const std::string& yaml, const std::string& text) {
    EXPECT_THAT(messageOf<InputError>([&] { read(yaml); }), HasSubstr(text));
  }

  TemporaryFolder folder_;
};

TEST_F(ReadStudy, AnExperimentIsAStudyOfOnePoint) {
  const Study study = readStudy(folder_ / "base.yaml");
  EXPECT_EQ(study.name, "base");
  ASSERT_THAT(study.points, SizeIs(1));
  EXPECT_THAT(study.points[0].values, SizeIs(0));
}

TEST_F(ReadStudy, AVeryLargeGridIsRefusedBeforeItIsLaidOut) {
  std::string yaml = "axes:\n";
  std::string values = "0";
  for (int i = 1; i < 100; ++i) values += ", " + std::to_string(i);
  for (const char* axis : {"a", "b", "c"}) {
    yaml += fmt::format("  - {{name: {}, values: [{}], set: ['evaluation.seed={{}}']}}\n", axis,
                        values);
  }
  expectFault(yaml,
              "sweep.yaml: axes: 100 x 100 x 100 points of 4 runs each are 4000000 runs; expected "
              "at most 10000, or --yes");
}

TEST_F(ReadStudy, TheLimitIsOnRunsAndCanBeLifted) {
  const std::string yaml = "axes:\n  - {name: a, values: [1, 2, 3], set: ['evaluation.seed={}']}\n";
  writeText(folder_ / "sweep.yaml", "experiment: base.yaml\n" + yaml);
  EXPECT_THAT(readStudy(folder_ / "sweep.yaml", {}, 12).points, SizeIs(3));
  EXPECT_THROW(readStudy(folder_ / "sweep.yaml", {}, 11), InputError);
  EXPECT_THAT(readStudy(folder_ / "sweep.yaml", {}, 0).points, SizeIs(3));
}

TEST_F(ReadStudy, AGridHasEveryCombinationTheLastAxisFirst) {
  const Study study = read(
      "axes:\n"
      "  - {name: voxel_m, values: [0.1, 0.2], set: "
      "['methods.hydra.window.tsdf.voxel_size_m={}']}\n"
      "  - {name: blank, values: [0, 0.5], set: ['dataset.masks.miss_probability={}']}\n");
  ASSERT_THAT(study.points, SizeIs(4));
  EXPECT_THAT(study.points[1].values, ElementsAre("0.1", "0.5"));
  EXPECT_THAT(study.points[1].experiment.methods[0].resolved_config,
              HasSubstr("voxel_size_m: 0.1"));
  EXPECT_THAT(study.points[1].experiment.datasets[0].overrides,
              ElementsAre("masks.miss_probability=0.5"));
}

TEST_F(ReadStudy, WhatAnAxisDoesNotTouchIsPlannedOnce) {
  const Study study = read(
      "axes:\n"
      "  - {name: voxel_m, values: [0.1, 0.2], set: "
      "['methods.hydra.window.tsdf.voxel_size_m={}']}\n");
  const Plan plan = planOf(study.experiments());
  EXPECT_THAT(plan.worlds, SizeIs(2));          // two seeds
  EXPECT_THAT(plan.worlds[0].runs, SizeIs(3));  // hydra twice, the oracle once
}

TEST_F(ReadStudy, AThresholdOfTheCheckNeverMapsAgain) {
  const Study study = read(
      "axes: [{name: tau, values: [0.1, 0.2, 0.3], set: "
      "['methods.oracle_shape.rmcc.min_overlap={}']}]");
  const Plan plan = planOf(study.experiments());
  EXPECT_THAT(plan.worlds[0].runs, SizeIs(2));
  EXPECT_THAT(plan.worlds[0].scores, SizeIs(4));  // hydra once, three decisions
}

TEST_F(ReadStudy, OverridesGoToTheSweepOrToItsExperiment) {
  const Study study = read("type: tau_o\n", {"method=oracle_shape", "datasets.0.seeds=[7]"});
  EXPECT_EQ(study.tau_o_method, "oracle_shape");
  ASSERT_THAT(study.points, SizeIs(1));
  EXPECT_THAT(study.points[0].experiment.methods, SizeIs(1));
  EXPECT_THAT(study.points[0].experiment.datasets[0].seeds, ElementsAre(7));
}

TEST_F(ReadStudy, NamesWhatIsWrong) {
  expectFault("axes: []\n", "axes: empty");
  expectFault("axes: [{name: a, values: [1]}]\n", "set: missing, must be given");
  expectFault("axes: [{name: a, values: [1, 1], set: ['x={}']}]\n", "a value occurs twice");
  expectFault("axes: [{name: a, values: [1], set: ['x=1']}]\n", "expected KEY={}");
  expectFault("axis: []\n", "did you mean axes?");
  expectFault("type: tau_o\nmethod: oracle_shap\n", "did you mean 'oracle_shape'?");
  expectFault("type: tau_o\nmethod: hydra\n", "'hydra' keeps no candidates");
  expectFault("axes: [{name: a, values: [1], set: ['methods.hydr.x={}']}]\n",
              "did you mean 'hydra'?");
}

TEST(ShippedSweeps, AreReadAndPlannedWithoutOpeningAWorld) {
  const std::filesystem::path folder =
      std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/sweeps";
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Study study = readStudy(entry.path());
    const Plan plan = planOf(study.experiments());
    EXPECT_EQ(plan.experiments.size(), study.points.size()) << entry.path();
    // Points differ: an axis that set no key of any method would plan the same again.
    std::size_t runs = 0;
    for (const Plan::World& world : plan.worlds) runs += world.runs.size();
    EXPECT_GE(runs, study.points.size()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 8u);
}

}  // namespace
}  // namespace hydrabench
