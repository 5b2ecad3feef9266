// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Shape estimation by stage: pose and mesh on analytic input, the estimator as a whole on a view of
// the office. HYDRABENCH_CRISP names a manifest (or its folder) to time end to end; without it only
// the published network is, with random weights.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/crisp_estimator.h"
#include "core/shape/crisp/crisp_model.h"
#include "core/shape/crisp/crisp_models.h"
#include "core/shape/nocs_pose.h"
#include "core/shape/sdf_mesher.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

/// The front of a box in front of a camera, in the middle of a 640 x 480 image.
ShapeObservation viewOfABox() {
  ShapeObservation view;
  view.camera = {.width = 640, .height = 480, .fx = 525, .fy = 525, .cx = 319.5, .cy = 239.5};
  view.T_world_camera = lookAt(Eigen::Vector3d(0, 0, 0.7), Eigen::Vector3d(2, 0, 0.4));
  view.color = Image<Rgb>(640, 480, Rgb{120, 110, 100});
  view.depth = Image<float>(640, 480, 3);
  view.mask = Image<std::uint8_t>(640, 480, 0);
  for (int v = 170; v < 310; ++v) {
    for (int u = 240; u < 400; ++u) {
      view.depth(u, v) = 2 + 0.001f * static_cast<float>(std::abs(u - 300));
      view.mask(u, v) = 1;
      view.color(u, v) = {static_cast<std::uint8_t>(u / 2), static_cast<std::uint8_t>(v / 2), 40};
    }
  }
  return view;
}

void nocsPose(benchmark::State& state) {
  const auto freedom = static_cast<NocsFreedom>(state.range(0));
  std::vector<Eigen::Vector3d> nocs;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < 400; ++i) {
    Random random(1, i);
    Eigen::Vector3d n, noise;
    for (int axis = 0; axis < 3; ++axis) n[axis] = random.uniform(-1, 1);
    for (int axis = 0; axis < 3; ++axis) noise[axis] = random.normal();
    n[static_cast<int>(i % 3)] = 1;
    nocs.push_back(n);
    points.push_back(0.4 * n + Eigen::Vector3d(0, 0, 2) + (i % 5 < 2 ? 0.3 : 0.01) * noise);
  }
  std::uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        solveNocsPose(nocs, points, freedom, Eigen::Vector3d::UnitZ(), {}, ++seed));
  }
  state.SetLabel("400 points, 40 % outliers");
}
BENCHMARK(nocsPose)
    ->ArgName("freedom")
    ->Arg(static_cast<int>(NocsFreedom::kSimilarity))
    ->Arg(static_cast<int>(NocsFreedom::kRigid))
    ->Arg(static_cast<int>(NocsFreedom::kUpright))
    ->Unit(benchmark::kMillisecond);

void meshTorus(benchmark::State& state) {
  SdfMesherConfig config;
  config.resolution = static_cast<int>(state.range(0));
  std::size_t evaluations = 0;
  setNumThreads(1);
  for (auto _ : state) {
    evaluations = 0;
    benchmark::DoNotOptimize(meshLevelSet(
        [&](std::span<const Eigen::Vector3f> points, std::span<float> values) {
          evaluations += points.size();
          for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector3f& p = points[i];
            values[i] = std::hypot(std::hypot(p.x(), p.y()) - 0.6f, p.z()) - 0.2f;
          }
        },
        config));
  }
  setNumThreads(0);
  state.counters["evaluations"] = static_cast<double>(evaluations);
  state.counters["of_dense"] =
      static_cast<double>(evaluations) / std::pow(static_cast<double>(config.resolution + 1), 3);
}
BENCHMARK(meshTorus)->ArgName("cells")->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// One call per iteration; counters say what the stages take.
void runEstimator(benchmark::State& state, const CrispEstimator& estimator) {
  const ShapeObservation view = viewOfABox();
  std::vector<double> totals;
  std::vector<std::pair<std::string, std::vector<double>>> stages;
  std::uint64_t seed = 0;
  std::string failure;
  for (auto _ : state) {
    const ShapeOutcome outcome = estimator.estimate(view, {}, ++seed);
    failure = outcome.failure;
    double total = 0;
    for (const StageTimes::Stage& stage : outcome.times.stages()) {
      auto known = std::find_if(stages.begin(), stages.end(),
                                [&](const auto& s) { return s.first == stage.name; });
      if (known == stages.end()) known = stages.insert(stages.end(), {stage.name, {}});
      for (const StageTimes::Sample& sample : stage.samples) {
        known->second.push_back(sample.wall_ms);
        total += sample.wall_ms;
      }
    }
    totals.push_back(total);
  }
  for (const auto& [name, times] : stages) {
    state.counters[name + "_p50_ms"] = percentile(times, 0.5);
  }
  state.counters["p50_ms"] = percentile(totals, 0.5);
  state.counters["p99_ms"] = percentile(totals, 0.99);
  if (!failure.empty()) state.SetLabel("no estimate: " + failure);
}

/// What random weights put out agrees with nothing: every stage must run all the same.
CrispEstimator::Config tolerant() {
  CrispEstimator::Config config;
  config.pose.threshold = config.pose.final_threshold = 1;
  config.pose.min_inlier_ratio = 0;
  config.min_size_m = 1e-4;
  config.max_size_m = 1e3;
  return config;
}

void crispFullRandomWeights(benchmark::State& state) {
  const CrispEstimator estimator(randomFullCrisp(1), tolerant());
  runEstimator(state, estimator);
}
BENCHMARK(crispFullRandomWeights)->Unit(benchmark::kMillisecond)->Iterations(3);

void crispFromManifest(benchmark::State& state) {
  const char* manifest = std::getenv("HYDRABENCH_CRISP");
  if (!manifest) {
    state.SkipWithError("HYDRABENCH_CRISP names no manifest");
    return;
  }
  CrispEstimator::Config config = tolerant();
  config.model = manifest;
  const CrispEstimator estimator(config);
  runEstimator(state, estimator);
}
BENCHMARK(crispFromManifest)->Unit(benchmark::kMillisecond)->Iterations(200);

}  // namespace
}  // namespace hydrabench
