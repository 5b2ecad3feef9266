// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/geometry/median.h"
#include "core/mapping/tsdf_integrator.h"
#include "core/parallel/parallel_for.h"
#include "eval/bench/office_frames.h"

namespace hydrabench {
namespace {

constexpr double kMinRange = 0.1;  // [m]
constexpr double kMaxRange = 5;    // [m]

/// Depth to fused volume at 0.1 m with colours and labels, frame after frame into one growing map.
/// p50_ms is of single frames; voxels_per_s counts the voxels of the blocks that a frame changed.
void integrateOfficeFrame(benchmark::State& state) {
  const std::vector<Frame>& frames = officeFrames();
  setNumThreads(static_cast<int>(state.range(0)));
  const TsdfIntegrator integrator({});
  TsdfVolume volume({});
  std::vector<double> times_ms;
  double num_voxels = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const SensorView view = sensorView(frames[next++ % frames.size()], kMinRange, kMaxRange);
    num_voxels += static_cast<double>(integrator.integrate(view, volume).size() *
                                      volume.grid().voxelsPerBlock());
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  state.counters["p50_ms"] = median(times_ms);
  state.counters["voxels_per_s"] = benchmark::Counter(num_voxels, benchmark::Counter::kIsRate);
  setNumThreads(0);
}
BENCHMARK(integrateOfficeFrame)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(2);

void viewOfOfficeFrame(benchmark::State& state) {
  const std::vector<Frame>& frames = officeFrames();
  setNumThreads(static_cast<int>(state.range(0)));
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(sensorView(frames[next++ % frames.size()], kMinRange, kMaxRange));
  setNumThreads(0);
}
BENCHMARK(viewOfOfficeFrame)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// One frame into the blocks of one object, as reconstruction does per track and frame: a cube of
/// 0.8 m in voxels of 2 cm, 1.5 m ahead.
void integrateIntoObjectBlocks(benchmark::State& state) {
  const Frame& frame = officeFrames().front();
  setNumThreads(static_cast<int>(state.range(0)));
  const SensorView view = sensorView(frame, kMinRange, kMaxRange);
  TsdfVolume volume(
      {.voxel_size_m = 0.02, .truncation_m = 0.06, .voxels_per_side = 8, .semantics = {"binary"}});
  const BlockIndex middle =
      volume.grid().blockAt(view.T_world_sensor * Eigen::Vector3d(0, 0.2, 1.5));
  for (int x = -2; x < 3; ++x)
    for (int y = -2; y < 3; ++y)
      for (int z = -2; z < 3; ++z) volume.allocate(middle + BlockIndex(x, y, z));
  const std::vector<BlockIndex> blocks = volume.blockIndices();
  const TsdfIntegrator integrator({});
  for (auto _ : state) integrator.integrateBlocks(view, blocks, volume);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(blocks.size() * 512));
  setNumThreads(0);
}
BENCHMARK(integrateIntoObjectBlocks)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace hydrabench
