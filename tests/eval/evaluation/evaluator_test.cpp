// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/evaluator.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/evaluation/self_test.h"
#include "eval/oracles/ground_truth_prediction.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr Label kChair = 5;
constexpr Label kBin = 18;
constexpr Label kDesk = 16;

LabelSpace labels() {
  LabelSpace space;
  space.entries = {{kChair, "chair", {}, true, true},
                   {kBin, "bin", {}, true, true},
                   {kDesk, "desk", {}, true, false}};
  return space;
}

GroundTruthObject cube(ObjectId id, Label label, double x) {
  GroundTruthObject object;
  object.id = id;
  object.label = label;
  object.name = "object_" + std::to_string(id);
  object.T_world_object.translation() = Eigen::Vector3d(x, 0, 0);
  object.mesh = std::make_shared<const Mesh>(
      boxMesh(Aabb(Eigen::Vector3d(-0.25, -0.25, 0), Eigen::Vector3d(0.25, 0.25, 0.5))));
  return object;
}

/// Four chairs and two bins in a row, 2 m apart, and a desk.
GroundTruth row() {
  GroundTruth truth;
  for (ObjectId i = 0; i < 4; ++i)
    truth.objects.push_back(cube(i, kChair, 2.0 * static_cast<double>(i)));
  for (ObjectId i = 4; i < 6; ++i)
    truth.objects.push_back(cube(i, kBin, 2.0 * static_cast<double>(i)));
  truth.objects.push_back(cube(6, kDesk, 20));
  return truth;
}

EvaluationConfig quickConfig() {
  EvaluationConfig config;
  config.samples = 500;
  config.jittered_origins = 2;
  config.bootstrap_resamples = 100;
  return config;
}

Evaluator evaluator(const GroundTruth& truth, const EvaluationConfig& config = quickConfig()) {
  return Evaluator("row", "1", labels(), truth, config);
}

std::optional<double> value(const MethodEvaluation& evaluation, const std::string& metric,
                            const std::string& class_name,
                            const std::string& matching = kMatchingExists, double threshold = 0.2) {
  for (const ScoreRow& score : evaluation.scores) {
    if (score.metric == metric && score.class_name == class_name && score.matching == matching &&
        score.threshold == threshold) {
      return score.value;
    }
  }
  ADD_FAILURE() << "no row " << metric << " " << class_name;
  return std::nullopt;
}

/// Ground truth as prediction, without the objects at `missing`, chairs moved by `shift` along x.
Prediction predicted(const GroundTruth& truth, double shift,
                     const std::vector<std::size_t>& missing = {}) {
  Prediction prediction = groundTruthPrediction(labels(), truth);
  for (ObjectNode& node : prediction.graph.objects) {
    if (node.label != kChair) continue;
    for (Eigen::Vector3d& vertex : node.mesh.vertices) vertex.x() += shift;
  }
  for (auto i = missing.rbegin(); i != missing.rend(); ++i) {
    prediction.graph.objects.erase(prediction.graph.objects.begin() +
                                   static_cast<std::ptrdiff_t>(*i));
  }
  return prediction;
}

TEST(Evaluator, CountsByHand) {
  const GroundTruth truth = row();
  // Chairs 1, 2, 3 found 0.1 m off; bin 4 missing.
  const MethodEvaluation evaluation = evaluator(truth).evaluate(predicted(truth, 0.1, {0, 4}));
  EXPECT_EQ(value(evaluation, "recall", kAllMicro), 4.0 / 6);
  EXPECT_EQ(value(evaluation, "precision", kAllMicro), 1.0);
  EXPECT_EQ(value(evaluation, "recall", "chair"), 3.0 / 4);
  EXPECT_EQ(value(evaluation, "recall", "bin"), 1.0 / 2);
  EXPECT_EQ(value(evaluation, "recall", kAllMacro), (3.0 / 4 + 1.0 / 2) / 2);
  EXPECT_EQ(value(evaluation, "truths", kAllMicro), 6);
}

TEST(Evaluator, AveragesGeometryOverPairsAndOverAllGroundTruth) {
  const GroundTruth truth = row();
  const MethodEvaluation evaluation = evaluator(truth).evaluate(predicted(truth, 0.1, {0, 4}));
  // A cube of 0.5 m moved by 0.1 m: IoU (0.5 - 0.1) / (0.5 + 0.1) = 2/3 for three chairs, 1 for the
  // bin.
  EXPECT_NEAR(*value(evaluation, "b_iou", kAllMicro), (3 * 2.0 / 3 + 1) / 4, 1e-12);
  EXPECT_NEAR(*value(evaluation, "b_iou_all_gt", kAllMicro), (3 * 2.0 / 3 + 1) / 6, 1e-12);
  EXPECT_NEAR(*value(evaluation, "v_iou_solid", "chair"), 2.0 / 3, 1e-12);
}

TEST(Evaluator, LeavesOutEstimatesOfUnscoredClasses) {
  const GroundTruth truth = row();
  const Prediction prediction = predicted(truth, 0);
  EXPECT_EQ(prediction.graph.objects.size(), 7u);
  const MethodEvaluation evaluation = evaluator(truth).evaluate(prediction);
  EXPECT_EQ(evaluation.estimates.size(), 6u);
  EXPECT_EQ(evaluation.unscored_estimates, 1u);
}

TEST(Evaluator, NeitherRewardsNorPunishesWhatWasNeverInView) {
  GroundTruth truth = row();
  truth.objects[0].visible_fraction = 0.02;
  EvaluationConfig config = quickConfig();
  config.min_visible_fraction = 0.1;
  const MethodEvaluation found = evaluator(truth, config).evaluate(predicted(truth, 0));
  EXPECT_EQ(value(found, "truths", kAllMicro), 5);
  EXPECT_EQ(value(found, "precision", kAllMicro), 1.0);
  const MethodEvaluation missed = evaluator(truth, config).evaluate(predicted(truth, 0, {0}));
  EXPECT_EQ(value(missed, "recall", kAllMicro), 1.0);
}

TEST(Evaluator, CountsAnEstimateWithoutMeshByItsBoxButGivesItNoShape) {
  const GroundTruth truth = row();
  Prediction prediction = predicted(truth, 0);
  prediction.graph.objects[0].mesh = Mesh();
  const MethodEvaluation evaluation = evaluator(truth).evaluate(prediction);
  EXPECT_EQ(value(evaluation, "recall", kAllMicro), 1.0);
  EXPECT_NEAR(*value(evaluation, "v_iou_solid_all_gt", kAllMicro), 5.0 / 6, 1e-12);
  EXPECT_EQ(value(evaluation, "b_iou", kAllMicro), 1.0);
  EXPECT_EQ(evaluation.estimates_without_mesh, 1u);
}

TEST(Evaluator, RefusesAnObjectWithNeitherMeshNorBox) {
  const GroundTruth truth = row();
  Prediction prediction = predicted(truth, 0);
  prediction.graph.objects[2].mesh = Mesh();
  prediction.graph.objects[2].box = Aabb();
  const std::string message = messageOf<InputError>([&] { evaluator(truth).evaluate(prediction); });
  EXPECT_NE(message.find("'object_2': neither a mesh nor a bounding box"), std::string::npos)
      << message;
}

TEST(Evaluator, RefusesGroundTruthWithoutASurface) {
  GroundTruth truth = row();
  truth.objects[1].mesh = std::make_shared<const Mesh>();
  const std::string message = messageOf<InputError>([&] { evaluator(truth); });
  EXPECT_EQ(message,
            "dataset 'row': ground truth 'object_1': mesh without a surface, expected triangles");
}

TEST(Evaluator, AveragesTheAreaUnderF1OverClasses) {
  const GroundTruth truth = row();
  // No bin found, every chair exactly: the areas are 1 and 0.
  const MethodEvaluation evaluation = evaluator(truth).evaluate(predicted(truth, 0, {4, 5}));
  EXPECT_EQ(value(evaluation, "f1_kappa_auc", kAllMacro, kMatchingExists, 1.0), 0.5);
}

TEST(Evaluator, RefusesMillimetres) {
  const GroundTruth truth = row();
  Prediction prediction = predicted(truth, 0);
  for (ObjectNode& node : prediction.graph.objects) node.mesh = scaled(1000, node.mesh);
  const std::string message = messageOf<InputError>([&] { evaluator(truth).evaluate(prediction); });
  EXPECT_NE(message.find("1000 times as large"), std::string::npos) << message;
}

TEST(Evaluator, ScoresMillimetresAsTheyAreWhereTold) {
  const GroundTruth truth = row();
  Prediction prediction = predicted(truth, 0);
  for (ObjectNode& node : prediction.graph.objects) node.mesh = scaled(1000, node.mesh);
  const MethodEvaluation evaluation =
      evaluator(truth).evaluate(prediction, Evaluator::OtherUnits::kScoredAsIs);
  EXPECT_EQ(value(evaluation, "recall", kAllMicro), 0.0);
}

TEST(Evaluator, RefusesACoordinateThatIsNotANumber) {
  const GroundTruth truth = row();
  Prediction prediction = predicted(truth, 0);
  prediction.graph.objects[2].mesh.vertices[1].y() = std::nan("");
  const std::string message = messageOf<InputError>([&] { evaluator(truth).evaluate(prediction); });
  EXPECT_NE(message.find("'object_2': a coordinate is not a finite number"), std::string::npos)
      << message;
}

TEST(Evaluator, RefusesGroundTruthWithoutAnythingThatCounts) {
  GroundTruth truth;
  truth.objects.push_back(cube(0, kDesk, 0));
  const std::string message = messageOf<InputError>([&] { evaluator(truth); });
  EXPECT_EQ(message,
            "dataset 'row': ground truth: no object that counts (of 1), expected at least one");
}

TEST(Evaluator, WritesOneRowPerEstimateAndPerMiss) {
  const GroundTruth truth = row();
  const MethodEvaluation evaluation = evaluator(truth).evaluate(predicted(truth, 0.3, {4}));
  const auto count = [&](double tau, ObjectRow::Outcome outcome) {
    return std::count_if(
        evaluation.objects.begin(), evaluation.objects.end(), [&](const ObjectRow& object) {
          return object.threshold.value == tau && object.matching == Matching::kOneToOne &&
                 object.outcome == outcome;
        });
  };
  EXPECT_EQ(count(0.2, ObjectRow::Outcome::kMatched), 1);
  EXPECT_EQ(count(0.2, ObjectRow::Outcome::kUnmatched), 4);
  EXPECT_EQ(count(0.2, ObjectRow::Outcome::kMissed), 5);
  EXPECT_EQ(count(0.5, ObjectRow::Outcome::kMatched), 5);
  EXPECT_EQ(count(0.5, ObjectRow::Outcome::kMissed), 1);
}

TEST(Evaluator, GivesTheSameBytesForAnyNumberOfThreads) {
  const GroundTruth truth = row();
  const Prediction prediction = predicted(truth, 0.1, {2});
  std::vector<std::string> texts;
  for (const int threads : {1, 2, 7}) {
    setNumThreads(threads);
    texts.push_back(scoresCsv(evaluator(truth).evaluate(prediction).scores));
  }
  setNumThreads(0);
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_EQ(texts[0], texts[2]);
}

TEST(Evaluator, PutsEveryPointValueInsideItsInterval) {
  const GroundTruth truth = row();
  const MethodEvaluation evaluation = evaluator(truth).evaluate(predicted(truth, 0.1, {0, 4}));
  std::size_t with_interval = 0;
  for (const ScoreRow& score : evaluation.scores) {
    if (!score.ci95_low) continue;
    ++with_interval;
    EXPECT_LE(*score.ci95_low, *score.value + 1e-9) << score.metric << " " << score.class_name;
    EXPECT_GE(*score.ci95_high, *score.value - 1e-9) << score.metric << " " << score.class_name;
  }
  EXPECT_GT(with_interval, 100u);
}

TEST(SelfTest, PassesOnSoundGroundTruth) {
  const SelfTestReport report = runSelfTest("row", "1", labels(), row(), quickConfig());
  for (const SelfTestCheck& check : report.checks)
    EXPECT_TRUE(check.passed) << check.claim << ": " << check.detail;
  EXPECT_GE(report.checks.size(), 27u);
}

TEST(SelfTest, FailsWhereTwoObjectsOfAClassStandInOnePlace) {
  GroundTruth truth = row();
  truth.objects[1].T_world_object = truth.objects[0].T_world_object;
  truth.objects[1].mesh = std::make_shared<const Mesh>(
      boxMesh(Aabb(Eigen::Vector3d(-0.5, -0.5, -0.25), Eigen::Vector3d(0.5, 0.5, 0.75))));
  EXPECT_FALSE(runSelfTest("row", "1", labels(), truth, quickConfig()).passed());
}

TEST(SelfTest, SeesWhatBothSidesOfAComparisonShare) {
  GroundTruth twice = row();
  twice.objects.push_back(twice.objects[0]);
  twice.objects.back().id = 77;
  EXPECT_FALSE(runSelfTest("row", "1", labels(), twice, quickConfig()).passed());

  GroundTruth inverted = row();
  Mesh mesh = *inverted.objects[0].mesh;
  for (Eigen::Vector3i& face : mesh.faces) std::swap(face[0], face[1]);
  inverted.objects[0].mesh = std::make_shared<const Mesh>(mesh);
  EXPECT_FALSE(runSelfTest("row", "1", labels(), inverted, quickConfig()).passed());

  GroundTruth millimetres = row();
  for (GroundTruthObject& object : millimetres.objects) {
    object.mesh = std::make_shared<const Mesh>(scaled(1000, *object.mesh));
  }
  EvaluationConfig coarse = quickConfig();
  coarse.voxel_pitch_m = 10;
  EXPECT_FALSE(runSelfTest("row", "1", labels(), millimetres, coarse).passed());
}

}  // namespace
}  // namespace hydrabench
