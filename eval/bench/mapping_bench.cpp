// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/mapping/active_window.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

constexpr std::size_t kFrames = 300;

/// The first 30 s of the drive through the office; frames 720 x 480, drawn before anything is
/// measured.
const std::vector<Frame>& drive() {
  static const std::vector<Frame> frames = [] {
    const SimulatedDataset dataset(SimulatedConfig::forWorld("office"));
    std::vector<Frame> all;
    for (std::size_t i = 0; i < kFrames; ++i) all.push_back(dataset.frame(i));
    return all;
  }();
  return frames;
}

/// All that a map does with a frame: range image, TSDF with colours and labels, and at every second
/// frame (0.2 s) the mesh and the archival. Voxels of 0.1 m, 5 m range. The time of one iteration
/// is that of a frame; the counters tell the middle and the worst frame [ms].
void mapFrame(benchmark::State& state) {
  const std::vector<Frame>& frames = drive();
  std::vector<double> times_ms;
  ActiveWindow window{{}};
  std::size_t next = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const Frame& frame = frames[next++];
    window.integrate(sensorView(frame, 0.1, 5));
    if (window.updateDue(frame.stamp_ns)) {
      window.update(frame.stamp_ns, frame.T_world_camera.translation());
    }
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["p50_ms"] = times_ms[times_ms.size() / 2];
  state.counters["max_ms"] = times_ms.back();
}
BENCHMARK(mapFrame)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(kFrames);

/// The mesh alone: every block of the window after 30 s is taken anew.
void meshOfAllBlocks(benchmark::State& state) {
  static const ActiveWindow* const window = [] {
    auto* made = new ActiveWindow{{}};
    for (const Frame& frame : drive()) made->integrate(sensorView(frame, 0.1, 5));
    return made;
  }();
  const std::vector<BlockIndex> blocks = window->volume().blockIndices();
  MapMesh mesh(0.005);
  for (auto _ : state) {
    for (const BlockIndex& block : blocks) {
      mesh.update(block, marchingCubes(window->volume(), block, 1e-4));
    }
  }
  state.counters["blocks"] = static_cast<double>(blocks.size());
  state.counters["vertices"] = static_cast<double>(mesh.activeVertices().size());
}
BENCHMARK(meshOfAllBlocks)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace hydrabench
