// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "eval/evaluation/method_scores.h"

namespace hydrabench {
namespace {

constexpr Label kChair = 5;

LabelSpace labels() {
  LabelSpace space;
  space.entries = {{kChair, "chair", {}, true, true}};
  return space;
}

EvaluationConfig quickConfig() {
  EvaluationConfig config;
  config.samples = 500;
  config.jittered_origins = 1;
  config.bootstrap_resamples = 50;
  return config;
}

Mesh cubeAt(double x) {
  return boxMesh(Aabb(Eigen::Vector3d(x - 0.25, -0.25, 0), Eigen::Vector3d(x + 0.25, 0.25, 0.5)));
}

/// Chairs at x = 0, 2, 4, ... and estimates at the given places.
MethodEvaluation world(const std::string& seed, int chairs, const std::vector<double>& estimates) {
  GroundTruth truth;
  for (int i = 0; i < chairs; ++i) {
    GroundTruthObject object;
    object.id = static_cast<ObjectId>(i);
    object.label = kChair;
    object.mesh = std::make_shared<const Mesh>(cubeAt(2.0 * i));
    truth.objects.push_back(object);
  }
  Prediction prediction;
  prediction.method = "mine";
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    ObjectNode node;
    node.id = i;
    node.label = kChair;
    node.mesh = cubeAt(estimates[i]);
    prediction.graph.objects.push_back(node);
  }
  return Evaluator("row", seed, labels(), truth, quickConfig()).evaluate(prediction);
}

std::optional<double> value(const MethodEvaluation& evaluation, const std::string& metric,
                            const std::string& matching) {
  for (const ScoreRow& score : evaluation.scores) {
    if (score.metric == metric && score.class_name == kAllMicro && score.matching == matching &&
        score.threshold == 0.2) {
      return score.value;
    }
  }
  return std::nullopt;
}

TEST(Pooling, CountsAddUpOverWorlds) {
  const MethodEvaluation a = world("1", 3, {0, 2});
  const MethodEvaluation b = world("2", 2, {0.1, 7});
  const MethodEvaluation* worlds[] = {&a, &b};
  const MethodEvaluation all = pooled(worlds, quickConfig());
  EXPECT_EQ(all.seed, kPooledSeed);
  EXPECT_EQ(value(all, "precision", kMatchingExists), 3.0 / 4);
  EXPECT_EQ(value(all, "recall", kMatchingExists), 3.0 / 5);
  EXPECT_EQ(value(all, "recall", kMatchingOneToOne), 3.0 / 5);
}

TEST(Pooling, MeansRunOverThePairsOfAllWorlds) {
  const MethodEvaluation a = world("1", 1, {0});
  const MethodEvaluation b = world("2", 2, {0.1, 2.1});
  const MethodEvaluation* worlds[] = {&a, &b};
  // A cube of 0.5 m shifted by 0.1 m along an edge: 0.4 / 0.6.
  EXPECT_NEAR(*value(pooled(worlds, quickConfig()), "b_iou", kMatchingExists),
              (1 + 2 * 0.4 / 0.6) / 3, 1e-9);
}

TEST(Pooling, AnObjectNeverMatchesOneOfAnotherWorld) {
  const MethodEvaluation a = world("1", 1, {});
  const MethodEvaluation b = world("2", 3, {0, 0.05});
  const MethodEvaluation* worlds[] = {&a, &b};
  const MethodEvaluation all = pooled(worlds, quickConfig());
  EXPECT_EQ(value(all, "found_truths", kMatchingExists), 1);
  EXPECT_EQ(value(all, "found_truths", kMatchingOneToOne), 1);
  for (const KappaCurve& curve : all.kappa_curves) {
    EXPECT_EQ(curve.sweep.at(0.5).found_truths, 1u);
  }
}

TEST(Pooling, OneWorldPooledScoresAsItself) {
  const MethodEvaluation a = world("1", 3, {0.1, 2, 2.05, 9});
  const MethodEvaluation* worlds[] = {&a};
  const MethodEvaluation all = pooled(worlds, quickConfig());
  ASSERT_EQ(all.scores.size(), a.scores.size());
  for (std::size_t i = 0; i < a.scores.size(); ++i) {
    EXPECT_EQ(all.scores[i].value, a.scores[i].value) << a.scores[i].metric;
    EXPECT_EQ(all.scores[i].ci95_low, a.scores[i].ci95_low) << a.scores[i].metric;
  }
}

}  // namespace
}  // namespace hydrabench
