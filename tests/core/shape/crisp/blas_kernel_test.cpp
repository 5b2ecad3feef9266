// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/blas_kernel.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr CpuFeatures kOld;
constexpr CpuFeatures kAvx2 = {.avx2 = true};
constexpr CpuFeatures kAvx512 = {.avx2 = true, .avx512 = true};

TEST(CpuFeatures, AreReadFromTheFlagsOfTheKernel) {
  const CpuFeatures zen2 = cpuFeatures("flags\t\t: fpu sse4_2 avx fma avx2 sha_ni");
  EXPECT_TRUE(zen2.avx2);
  EXPECT_FALSE(zen2.avx512);
  const CpuFeatures xeon = cpuFeatures(
      "flags\t: fma avx2 avx512f avx512dq avx512cd avx512bw avx512vl avx512_bf16 amx_bf16 "
      "amx_tile amx_int8");
  EXPECT_TRUE(xeon.avx2 && xeon.avx512 && xeon.bf16 && xeon.amx);
}

TEST(CpuFeatures, NeedTheWholeWordAndTheWholeSet) {
  EXPECT_FALSE(cpuFeatures("flags : fma avx2x notavx2").avx2);
  EXPECT_FALSE(cpuFeatures("flags : avx2").avx2) << "no FMA";
  EXPECT_FALSE(cpuFeatures("flags : fma avx2 avx512f avx512dq").avx512) << "no BW, VL, CD";
  EXPECT_FALSE(cpuFeatures("").avx2);
}

TEST(BlasKernel, IsSlowWhereItIsOlderThanTheProcessor) {
  EXPECT_TRUE(isSlowKernel("Prescott", kAvx512));
  EXPECT_TRUE(isSlowKernel("Sandybridge", kAvx2));
  EXPECT_FALSE(isSlowKernel("Prescott", kOld));
  EXPECT_FALSE(isSlowKernel("Haswell", kAvx2));
  EXPECT_FALSE(isSlowKernel("Cooperlake", kAvx512));
  EXPECT_FALSE(isSlowKernel("", kAvx512)) << "not OpenBLAS: it cannot be told what it uses";
}

TEST(BlasKernel, ThatIsChosenRunsOnTheProcessor) {
  EXPECT_EQ(fastestKernel(kOld), "");
  EXPECT_EQ(fastestKernel(kAvx2), "Haswell");
  EXPECT_EQ(fastestKernel(kAvx512), "SkylakeX");
}

TEST(BlasKernel, IsNoSlowOneInThisVeryProcess) {
  // This program's main() has seen to it.
  EXPECT_FALSE(isSlowKernel(blasKernel(), cpuFeatures())) << blasKernel();
}

}  // namespace
}  // namespace hydrabench
