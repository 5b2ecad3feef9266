// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "core/shape/crisp/blas_kernel.h"

int main(int argc, char** argv) {
  hydrabench::ensureFastBlasKernel(argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
