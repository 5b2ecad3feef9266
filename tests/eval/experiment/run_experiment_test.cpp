// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/run_experiment.h"

#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/datasets/folder_export.h"
#include "tests/eval/datasets/toy_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Returns the ground-truth chair of the toy world, or throws from some frame on.
class ToyMethod : public MappingSystem {
 public:
  explicit ToyMethod(bool fails) : fails_(fails) {}
  void process(const RgbdFrame&) override {
    if (fails_) throw std::runtime_error("out of luck");
  }
  SceneGraph finish() override {
    const GroundTruthObject truth = ToyDataset().groundTruth().objects[0];
    SceneGraph graph;
    ObjectNode node;
    node.id = 7;
    node.label = truth.label;
    node.mesh = transformed(truth.T_world_object, *truth.mesh);
    node.box = bounds(node.mesh);
    graph.objects.push_back(node);
    return graph;
  }
  const StageTimes& stageTimes() const override { return times_; }

 private:
  bool fails_;
  StageTimes times_;  // none of its own: a method need not time anything
};

MethodConfig toyMethod(const std::string& name, bool fails = false) {
  return {name, "type: toy\n", [=](const Dataset&) { return std::make_unique<ToyMethod>(fails); }};
}

class RunExperiment : public ::testing::Test {
 protected:
  RunExperiment() {
    exportDataset(ToyDataset(), folder_ / "world", {});
    config_.datasets = {{folder_ / "world/dataset.yaml", "toy", {}, {}}};
    config_.methods = {toyMethod("good")};
    config_.evaluation.samples = 200;
    config_.evaluation.bootstrap_resamples = 10;
    config_.evaluation.jittered_origins = 1;
  }
  ExperimentOutcome run() { return runExperiment(config_, folder_ / "out", {}); }

  TemporaryFolder folder_;
  ExperimentConfig config_;
};

TEST_F(RunExperiment, ScoresTimesAndKeepsPredictions) {
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  EXPECT_TRUE(outcome.failures.empty());
  ASSERT_EQ(outcome.result.evaluations.size(), 1u);
  EXPECT_EQ(outcome.result.evaluations[0].dataset, "toy");
  std::vector<std::string> stages;
  for (const TimingRow& row : outcome.result.timing) stages.push_back(row.stage);
  EXPECT_THAT(stages, ElementsAre("frame", "finish"));
  EXPECT_TRUE(std::filesystem::exists(
      folder_ / "out/predictions/toy/18446744073709551615/good/scene_graph.json"));
}

TEST_F(RunExperiment, AFailedMethodIsNamedAndNotedAndTheOthersStay) {
  config_.methods.push_back(toyMethod("bad", true));
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  EXPECT_THAT(outcome.failures, ElementsAre("toy, seed 18446744073709551615, bad: out of luck"));
  EXPECT_THAT(outcome.result.notes,
              ElementsAre("bad: 1 of 1 worlds of toy failed and are not in the table"));
}

TEST_F(RunExperiment, AWorldThatBreaksLaterIsAFailureAndTheFirstIsKept) {
  config_.datasets.push_back({folder_ / "nowhere.yaml", "gone", {}, {}});
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_THAT(outcome.failures[0], HasSubstr("gone: "));
}

TEST_F(RunExperiment, AFirstWorldThatCannotBeOpenedIsBadInput) {
  config_.datasets[0].config = folder_ / "nowhere.yaml";
  EXPECT_THROW(run(), InputError);
}

TEST_F(RunExperiment, TwoDatasetsOfOneNameAreRefused) {
  config_.datasets.push_back(config_.datasets[0]);
  const ExperimentOutcome outcome = run();
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_THAT(outcome.failures[0], HasSubstr("another dataset is called 'toy'"));
}

TEST_F(RunExperiment, ADatasetsNameCannotLeaveTheFolder) {
  config_.datasets[0].name = "";
  config_.datasets[0].overrides = {"name=../../evil"};
  try {
    run();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("dataset name '../../evil', expected letters"));
  }
}

TEST_F(RunExperiment, ADatasetWithoutSeedsTakesNone) {
  config_.datasets[0].seeds = {1, 2};
  try {
    run();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("toy: not a generated world"));
  }
}

}  // namespace
}  // namespace hydrabench
