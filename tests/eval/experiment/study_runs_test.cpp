// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// From a plan over jobs and the store to a result.
#include <atomic>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/datasets/folder_export.h"
#include "eval/experiment/assemble.h"
#include "eval/experiment/job_runner.h"
#include "eval/experiment/plan.h"
#include "tests/eval/datasets/toy_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Returns the ground-truth chair of the toy world, or throws from some frame on.
class ToyMethod : public MappingSystem {
 public:
  explicit ToyMethod(bool fails) : fails_(fails) {}
  void process(const Frame&) override {
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

class StudyRuns : public ::testing::Test {
 protected:
  StudyRuns() : store_(folder_ / "store") {
    exportDataset(ToyDataset(), folder_ / "world", {});
    config_.datasets = {{folder_ / "world/dataset.yaml", "toy", {}, {}}};
    config_.methods = {method("good")};
    config_.evaluation.samples = 200;
    config_.evaluation.bootstrap_resamples = 10;
    config_.evaluation.jittered_origins = 1;
  }

  MethodConfig method(const std::string& name, const std::string& mapping_config = "works") {
    MethodConfig config;
    config.name = name;
    config.resolved_config = "type: toy\n";
    config.mapping_config = mapping_config;
    return config;
  }

  std::vector<Job> missing() { return missingJobs(planOf({config_}), store_, 8); }

  /// Does what is missing, and gathers everything.
  ExperimentOutcome run() {
    const Plan plan = planOf({config_});
    JobRunner runner(store_, [&](const std::string& mapping_config) {
      MethodConfig toy = method("toy", mapping_config);
      if (mapping_config == "refuses") throw InputError("refused");
      toy.start = [this, mapping_config](const Dataset&) {
        ++started_;
        return std::make_unique<ToyMethod>(mapping_config == "fails");
      };
      return toy;
    });
    for (const Job& job : missingJobs(plan, store_, 8)) runner.run(job);
    return assembled(config_, plan.experiments[0], plan, store_);
  }

  TemporaryFolder folder_;
  ExperimentConfig config_;
  UnitStore store_;
  int started_ = 0;
};

TEST_F(StudyRuns, ScoresTimesAndKeepsPredictions) {
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  EXPECT_TRUE(outcome.failures.empty());
  ASSERT_THAT(outcome.result.evaluations, SizeIs(1));
  EXPECT_EQ(outcome.result.evaluations[0].dataset, "toy");
  EXPECT_EQ(outcome.result.evaluations[0].method, "good");
  EXPECT_FALSE(outcome.result.evaluations[0].scores.empty());
  std::vector<std::string> stages;
  for (const TimingRow& row : outcome.result.timing) stages.push_back(row.stage);
  EXPECT_THAT(stages, ElementsAre("frame", "finish"));

  const Plan plan = planOf({config_});
  linkPredictions(config_, plan.experiments[0], plan, store_, folder_ / "out");
  const auto prediction = folder_ / "out/predictions/toy/18446744073709551615/good";
  EXPECT_TRUE(std::filesystem::exists(prediction / "scene_graph.json"));
  EXPECT_THAT(readText(prediction / "prediction.json"), HasSubstr("\"good\""));
  EXPECT_THAT(readText(prediction / "timing.csv"), HasSubstr(",good,frame,"));
  EXPECT_FALSE(std::filesystem::exists(prediction / "run.json"));
}

TEST_F(StudyRuns, WhatIsInTheStoreIsNotDoneAgain) {
  const std::string scores = scoresCsv(allScores(run().result));
  EXPECT_EQ(started_, 1);
  EXPECT_EQ(scoresCsv(allScores(run().result)), scores);
  EXPECT_EQ(started_, 1);
}

TEST_F(StudyRuns, MethodsThatMapAlikeShareARunAndEachHasItsRow) {
  config_.methods.push_back(method("twin"));
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(started_, 1);
  ASSERT_THAT(outcome.result.evaluations, SizeIs(2));
  EXPECT_EQ(outcome.result.evaluations[1].method, "twin");
}

TEST_F(StudyRuns, AnotherThresholdOrMetricNeverMapsAgain) {
  run();
  config_.evaluation.thresholds_m = {0.7};
  config_.evaluation.voxel_pitch_m = 0.1;
  const std::vector<Job> jobs = missing();
  ASSERT_THAT(jobs, SizeIs(1));
  EXPECT_THAT(jobs[0].runs, SizeIs(0));
  EXPECT_THAT(jobs[0].scores, SizeIs(1));
  EXPECT_EQ(run().result.evaluations[0].objects[0].threshold, Threshold::tau(0.7));
  EXPECT_EQ(started_, 1);
}

TEST_F(StudyRuns, OtherKappasAndIntervalsAreNotEvenScoredAgain) {
  run();
  config_.evaluation.kappas = {0.33};
  config_.evaluation.bootstrap_resamples = 20;
  EXPECT_THAT(missing(), SizeIs(0));
  bool found = false;
  for (const ScoreRow& row : allScores(run().result)) found |= row.threshold == 0.33;
  EXPECT_TRUE(found);
}

TEST_F(StudyRuns, AChangedRecordingIsMappedAgain) {
  run();
  writeText(folder_ / "world/notes.txt", "new");
  EXPECT_THAT(missing(), SizeIs(1));
}

TEST_F(StudyRuns, AFailedMethodIsNamedAndNotedAndTheOthersStay) {
  config_.methods.push_back(method("bad", "fails"));
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  ASSERT_THAT(outcome.failures, SizeIs(1));
  EXPECT_EQ(outcome.failures[0].unit, "toy, seed 18446744073709551615, bad");
  EXPECT_EQ(outcome.failures[0].message, "out of luck");
  const Job again = readJob(outcome.failures[0].job);
  EXPECT_EQ(again.label(), "toy, seed 18446744073709551615: bad");
  EXPECT_THAT(outcome.result.notes,
              ElementsAre("bad: 1 of 1 worlds of toy failed and are not in the table"));
}

TEST_F(StudyRuns, SettingsThatOneMethodRefusesLeaveTheOthersAlone) {
  config_.methods.push_back(method("bad", "refuses"));
  const ExperimentOutcome outcome = run();
  EXPECT_EQ(outcome.predictions, 1u);
  ASSERT_THAT(outcome.failures, SizeIs(1));
  EXPECT_EQ(outcome.failures[0].message, "refused");
}

TEST_F(StudyRuns, AFailureIsForgottenOnceItWorks) {
  config_.methods = {method("bad", "fails")};
  const std::string hash = planOf({config_}).worlds[0].runs[0].hash;
  run();
  EXPECT_EQ(store_.state(hash), UnitStore::State::kFailed);
  JobRunner runner(store_, [&](const std::string&) {
    MethodConfig toy = method("bad");
    toy.start = [](const Dataset&) { return std::make_unique<ToyMethod>(false); };
    return toy;
  });
  for (const Job& job : missing()) runner.run(job);
  EXPECT_EQ(store_.state(hash), UnitStore::State::kDone);
  EXPECT_EQ(store_.failure(hash), std::nullopt);
}

TEST_F(StudyRuns, AUnitInWorkIsSeenAsRunning) {
  const std::string hash = planOf({config_}).worlds[0].runs[0].hash;
  EXPECT_EQ(store_.state(hash), UnitStore::State::kMissing);
  {
    const UnitStore::Lock lock = store_.lock(hash);
    EXPECT_EQ(store_.state(hash), UnitStore::State::kRunning);
  }
  EXPECT_EQ(store_.state(hash), UnitStore::State::kMissing);
}

TEST_F(StudyRuns, ADatasetThatIsNotThereIsToldBeforeAnythingRuns) {
  config_.datasets.push_back({folder_ / "nowhere.yaml", "gone", {}, {}});
  EXPECT_THROW(planOf({config_}), InputError);
}

TEST_F(StudyRuns, TwoDatasetsOfOneNameAreRefused) {
  config_.datasets.push_back(config_.datasets[0]);
  EXPECT_THAT(messageOf<InputError>([&] { planOf({config_}); }),
              HasSubstr("another dataset is called 'toy'"));
}

TEST_F(StudyRuns, ADatasetsNameCannotLeaveTheFolder) {
  config_.datasets[0].name = "";
  config_.datasets[0].overrides = {"name=../../evil"};
  EXPECT_THAT(messageOf<InputError>([&] { planOf({config_}); }),
              HasSubstr("dataset name '../../evil', expected letters"));
}

TEST_F(StudyRuns, ADatasetWithoutSeedsTakesNone) {
  config_.datasets[0].seeds = {1, 2};
  EXPECT_THAT(messageOf<InputError>([&] { planOf({config_}); }),
              HasSubstr("toy: not a generated world"));
}

TEST_F(StudyRuns, AJobReadsBackAsItWasWritten) {
  config_.methods.push_back(method("twin"));
  const Job job = missing().at(0);
  const Job read = jobFromJson(jobJson(job), "test");
  EXPECT_EQ(jobJson(read), jobJson(job));
  EXPECT_EQ(read.runs[0].methods, (std::vector<std::string>{"good", "twin"}));
}

}  // namespace
}  // namespace hydrabench
