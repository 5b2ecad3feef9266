// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/tau_o_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/experiment/result_worlds.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

constexpr Label kChair = 5;

Mesh cubeAt(double x) {
  return boxMesh(Aabb(Eigen::Vector3d(x, 0, 0), Eigen::Vector3d(x + 1, 1, 1)));
}

/// Chairs at 0 m and at 10 m.
Counting twoChairs() {
  Counting counting;
  counting.label_space = {{{kChair, "chair", {}, true, true}}};
  counting.truths = {detectionObject(1, kChair, cubeAt(0)), detectionObject(2, kChair, cubeAt(10))};
  return counting;
}

ShapeCandidate candidate(double x, double overlap) {
  static std::uint64_t track = 0;
  ShapeCandidate result;
  result.track = track++;
  result.label = kChair;
  result.mesh = cubeAt(x);
  result.box = bounds(result.mesh);
  result.overlap = overlap;
  return result;
}

EvaluationConfig smallConfig() {
  EvaluationConfig config;
  config.thresholds_m = {0.2};
  config.bootstrap_resamples = 0;
  config.samples = 100;
  config.jittered_origins = 0;
  return config;
}

/// Right with O = 0.9, right with 0.3, wrong with 0.1.
class TauOSweep : public ::testing::Test {
 protected:
  TauOSweep()
      : worlds_{{{candidate(0, 0.9), candidate(10, 0.3), candidate(50, 0.1)}, twoChairs()}} {}

  std::vector<TauOWorld> worlds_;
};

TEST_F(TauOSweep, ChangesWhereTheThresholdReachesAnOverlap) {
  const auto steps = sweepTauO(worlds_, {}, smallConfig());
  std::vector<double> taus;
  std::vector<double> p, r;
  for (const TauOStep& step : steps) {
    taus.push_back(step.tau_o);
    p.push_back(precision(step.scores[0].counts).value_or(-1));
    r.push_back(*recall(step.scores[0].counts));
  }
  EXPECT_EQ(taus, (std::vector<double>{0, 0.1, 0.3, 0.9}));
  // The check is strict: at 0.1 the candidate of 0.1 is out.
  EXPECT_EQ(p, (std::vector<double>{2.0 / 3, 1, 1, -1}));
  EXPECT_EQ(r, (std::vector<double>{1, 1, 0.5, 0}));
}

TEST_F(TauOSweep, AddsWorldsUp) {
  worlds_.push_back(worlds_.front());
  const auto steps = sweepTauO(worlds_, {}, smallConfig());
  EXPECT_EQ(steps[0].scores[0].counts, (DetectionCounts{6, 4, 4, 4}));
}

TEST_F(TauOSweep, NamesTheBestThresholdAndTheOneInUse) {
  const auto steps = sweepTauO(worlds_, {}, smallConfig());
  EXPECT_THAT(tauOMarkdown(steps, 0.21),
              HasSubstr("| 0.2 m | exists | 1.000 | 0.100 to 0.300 | 1.000, 1.000 | 0.800 | 1.000 "
                        "| 1.000, 1.000 |"));
}

TEST_F(TauOSweep, PlotsAPanelForEachThreshold) {
  const Plot plot = tauOPlot(sweepTauO(worlds_, {}, smallConfig()), Matching::kOneToOne, 0.21);
  ASSERT_EQ(plot.panels.size(), 1u);
  EXPECT_EQ(plot.panels[0].curves.size(), 3u);
  EXPECT_EQ(plot.panels[0].curves[1].points,
            (std::vector<Eigen::Vector2d>{{0, 1}, {0.1, 1}, {0.3, 0.5}, {0.9, 0}}));
}

TEST(DecisionOfARun, IsReadFromItsConfigWhateverElseStandsThere) {
  const TemporaryFolder folder;
  writeText(folder / "config.yaml",
            "type: hydra_plus_plus\nrmcc:\n  min_overlap: 0.4\nmerge_revisited: false\n");
  const DecisionConfig config = readDecisionOf(folder.path());
  EXPECT_EQ(config.rmcc.min_overlap, 0.4);
  EXPECT_FALSE(config.merge_revisited);
}

TEST(ResultWorlds, FindsPredictionsAndTheConfigOfTheirWorld) {
  const TemporaryFolder folder;
  for (const char* path : {"office/10/hydra", "office/2/hydra", "office/2/mine", "toy/0/hydra"}) {
    std::filesystem::create_directories(folder / "predictions" / path);
  }
  writeText(
      folder / "config.yaml",
      "experiment:\n  name: x\ndatasets:\n  office_2:\n    type: simulated\n    masks:\n"
      "      a: 1\n  office_10:\n    type: simulated\n    seed: 10\n  toy_0:\n    type: folder\n");
  const std::vector<ResultWorld> worlds = resultWorlds(folder.path());
  ASSERT_EQ(worlds.size(), 3u);
  EXPECT_EQ(worlds[0].label(), "office_2");
  EXPECT_EQ(worlds[0].config, "type: simulated\nmasks:\n  a: 1\n");
  EXPECT_EQ(worlds[0].predictions.size(), 2u);
  EXPECT_EQ(worlds[1].config, "type: simulated\nseed: 10\n");
  EXPECT_THAT(messageOf<InputError>([&] { worlds[2].open(); }), HasSubstr("camera"));
}

TEST(ResultWorlds, RefusesAFolderThatIsNoResult) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf<InputError>([&] { resultWorlds(folder.path()); }),
              HasSubstr("expected a result folder of 'run'"));
}

}  // namespace
}  // namespace hydrabench
