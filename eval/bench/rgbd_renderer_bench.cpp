// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <memory>

#include <benchmark/benchmark.h>

#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

/// Made once; the world takes longer than any measurement.
const SimulatedDataset& office() {
  static const SimulatedDataset dataset(SimulatedConfig::forWorld("office"));
  return dataset;
}

/// Frames along the whole drive, so that open and narrow places count alike.
std::size_t frameOf(std::int64_t iteration) {
  return static_cast<std::size_t>(iteration) * 97 % office().numFrames();
}

/// What a method is given: 720 x 480 with noise and corrupted masks. Items per second are frames
/// per second.
void frameOfTheOffice(benchmark::State& state) {
  const SimulatedDataset& dataset = office();
  std::int64_t count = 0;
  for (auto _ : state) benchmark::DoNotOptimize(dataset.frame(frameOf(count++)));
  state.SetItemsProcessed(count);
}
BENCHMARK(frameOfTheOffice)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(5);

/// The ray tracing alone.
void renderOfTheOffice(benchmark::State& state) {
  const SimulatedDataset& dataset = office();
  std::int64_t count = 0;
  for (auto _ : state) {
    const Transform& pose = dataset.trajectory()[frameOf(count++)].T_world_camera;
    benchmark::DoNotOptimize(dataset.renderer().render(dataset.camera(), pose));
  }
  state.SetItemsProcessed(count);
}
BENCHMARK(renderOfTheOffice)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(5);

/// Camera and LiDAR of the short campus with so many movers, five people to three cars: items are
/// frames with their sweep of 64 lasers, without noise.
void campusWithMovers(benchmark::State& state) {
  SimulatedConfig config = SimulatedConfig::forWorld("campus_quick", "clean");
  config.lidar = LidarSensorConfig::forPattern("hdl64", "clean");
  config.lidar.enabled = true;
  const int movers = static_cast<int>(state.range(0));
  config.campus.movers = {3 * movers / 8, movers - 3 * movers / 8};
  const SimulatedDataset dataset(config);
  std::int64_t count = 0;
  for (auto _ : state) {
    const auto index = static_cast<std::size_t>(count++) * 97 % dataset.numFrames();
    benchmark::DoNotOptimize(dataset.frame(index));
  }
  state.SetItemsProcessed(count);
}
BENCHMARK(campusWithMovers)
    ->Arg(0)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(5);

void makeOfficeWorld(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(makeOffice(OfficeConfig{}, 1));
}
BENCHMARK(makeOfficeWorld)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace hydrabench
