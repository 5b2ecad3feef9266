// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "eval/bench/office_frames.h"
#include "eval/simulation/lidar_sensor.h"

namespace hydrabench {
namespace {

/// One turn of the sensor along the drive through the office, motion, noise and drop-out included;
/// items are turns, so that 10 a second is real time.
void sweepOfTheOffice(benchmark::State& state, const std::string& pattern) {
  static const SimulatedDataset office(SimulatedConfig::forWorld("office"));
  static const std::vector<TimedPose> poses = [] {
    const Transform T_camera_body = cameraOnBody(0.8, 8).inverse();
    std::vector<TimedPose> bodies;
    for (const StampedPose& pose : office.trajectory()) {
      bodies.push_back({pose.stamp_ns, pose.T_world_camera * T_camera_body});
    }
    return bodies;
  }();
  const LidarSensorConfig config = LidarSensorConfig::forPattern(pattern, "default");
  std::int64_t count = 0;
  std::size_t points = 0;
  for (auto _ : state) {
    const std::size_t index = static_cast<std::size_t>(count) * 97 % (poses.size() - 1);
    const LidarScan scan =
        sweep(office.renderer(), poses, poses[index].stamp_ns, poses[index + 1].stamp_ns, config,
              static_cast<std::uint64_t>(count));
    points += scan.points.size();
    ++count;
  }
  state.SetItemsProcessed(count);
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(count);
}
BENCHMARK_CAPTURE(sweepOfTheOffice, vlp16, "vlp16")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(3);
BENCHMARK_CAPTURE(sweepOfTheOffice, hdl64, "hdl64")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(3);

}  // namespace
}  // namespace hydrabench
