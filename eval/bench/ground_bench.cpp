// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/geometry/median.h"
#include "core/mapping/ground/patchwork.h"
#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/bench/office_frames.h"

namespace hydrabench {
namespace {

constexpr double kSensorHeight = 1.73;  // [m]

/// One turn of 64 lines with 1900 columns on a street of 16 m between facades, columns of 1 m
/// beside it every 6 m: about as many points as a scan of KITTI, most of them near. Ranges have a
/// noise of 0.02 m.
struct StreetScan {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;

  explicit StreetScan(std::uint64_t seed) {
    Random random(seed);
    for (int column = 0; column < 1900; ++column) {
      const double azimuth = 2 * std::numbers::pi * (column + 0.5) / 1900;
      for (int line = 0; line < 64; ++line) {
        const double angle = (2 - 26.8 * line / 63) * std::numbers::pi / 180;
        const Eigen::Vector3d ray(std::cos(angle) * std::cos(azimuth),
                                  std::cos(angle) * std::sin(azimuth), std::sin(angle));
        double range = ray.z() < 0 ? -kSensorHeight / ray.z() : 100;
        for (const double side : {5.0, 8.0}) {  // columns, then the facade
          const double distance = side / std::abs(ray.y());
          const double along = distance * ray.x();
          const bool solid = side == 8 || along - 6 * std::floor(along / 6) < 1;
          if (solid && distance < range) range = distance;
        }
        if (range >= 100) continue;
        points.push_back(((range + 0.02 * random.normal()) * ray).cast<float>());
        intensity.push_back(static_cast<float>(random.uniform()));
      }
    }
  }
};

/// Ground of a scan of 64 lines with the published settings, scan after scan as thresholds adapt.
void groundOfScan(benchmark::State& state) {
  static const std::vector<StreetScan> scans{StreetScan(1), StreetScan(2), StreetScan(3)};
  setNumThreads(static_cast<int>(state.range(0)));
  Patchwork patchwork{{}};
  std::vector<double> times_ms;
  std::size_t next = 0;
  for (auto _ : state) {
    const StreetScan& scan = scans[next++ % scans.size()];
    const auto start = std::chrono::steady_clock::now();
    const GroundMask mask =
        patchwork.segment({0, scan.points, scan.intensity, {}, {}, kSensorHeight});
    benchmark::DoNotOptimize(mask.classes.data());
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  state.counters["points"] = static_cast<double>(scans[0].points.size());
  state.counters["p50_ms"] = median(times_ms);
  setNumThreads(0);
}
BENCHMARK(groundOfScan)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(2);

}  // namespace
}  // namespace hydrabench
