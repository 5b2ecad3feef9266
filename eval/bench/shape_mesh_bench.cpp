// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "eval/simulation/shape_family.h"

namespace hydrabench {
namespace {

/// Mesh of the nominal shape of each family: shapeMesh/car_sedan and so on.
[[maybe_unused]] const bool kRegistered = [] {
  for (const ShapeFamily& family : shapeFamilies()) {
    benchmark::RegisterBenchmark(("shapeMesh/" + family.name).c_str(),
                                 [&](benchmark::State& state) {
                                   const ShapeInstance instance = family.nominal();
                                   for (auto _ : state)
                                     benchmark::DoNotOptimize(meshInstance(instance));
                                 })
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace hydrabench
