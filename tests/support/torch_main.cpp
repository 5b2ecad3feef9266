// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// main() of the test programs that use libtorch, in place of gtest_main's.
#include <gmock/gmock.h>

#include "core/shape/crisp/blas_kernel.h"

int main(int argc, char** argv) {
  hydrabench::ensureFastBlasKernel(argv);
  testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
