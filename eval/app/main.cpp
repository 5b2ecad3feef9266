// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/blas_kernel.h"
#include "eval/app/app.h"

int main(int argc, char** argv) {
  hydrabench::ensureFastBlasKernel(argv);
  return hydrabench::runApp(argc, argv);
}
