// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// Scoring 88 estimates against 88 ground-truth objects with everything on: what `hydrabench
// evaluate` costs beyond reading files.

#include <benchmark/benchmark.h>

#include "core/parallel/parallel_for.h"
#include "eval/evaluation/evaluator.h"
#include "eval/oracles/ground_truth_prediction.h"

namespace hydrabench {
namespace {

LabelSpace labels() {
  LabelSpace space;
  space.entries = {{5, "chair", {}, true, true}};
  return space;
}

/// Spheres of 5120 faces, about as many as a generated chair has.
GroundTruth spheres(int count) {
  const auto mesh = std::make_shared<const Mesh>(sphereMesh(Eigen::Vector3d(0, 0, 0.5), 0.5, 4));
  GroundTruth truth;
  for (int i = 0; i < count; ++i) {
    GroundTruthObject object;
    object.id = static_cast<ObjectId>(i);
    object.label = 5;
    object.T_world_object.translation() = Eigen::Vector3d(1.5 * i, 0, 0);
    object.mesh = mesh;
    truth.objects.push_back(std::move(object));
  }
  return truth;
}

void Evaluate88Against88(benchmark::State& state) {
  const GroundTruth truth = spheres(88);
  Prediction prediction = groundTruthPrediction(labels(), truth);
  for (ObjectNode& node : prediction.graph.objects) {
    for (Eigen::Vector3d& vertex : node.mesh.vertices) vertex.y() += 0.05;
  }
  setNumThreads(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const Evaluator evaluator("spheres", "1", labels(), truth, {});
    benchmark::DoNotOptimize(evaluator.evaluate(prediction));
  }
  setNumThreads(0);
}
BENCHMARK(Evaluate88Against88)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace hydrabench
