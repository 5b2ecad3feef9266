// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hydrabench {

/// What of the processor matters to matrix products.
struct CpuFeatures {
  bool avx2 = false;    ///< with FMA
  bool avx512 = false;  ///< with the BW, DQ, VL and CD parts that OpenBLAS's kernels use
  bool bf16 = false;    ///< AVX-512 products of bfloat16
  bool amx = false;     ///< tile products of bfloat16
};
/// @param flags  the line "flags" of /proc/cpuinfo
CpuFeatures cpuFeatures(std::string_view flags);
/// Of this machine; nothing where it cannot be told.
CpuFeatures cpuFeatures();

/// Kernel that OpenBLAS works with in this process ("Haswell", "SkylakeX"), empty where the BLAS is
/// another.
std::string blasKernel();

/// Whether a kernel leaves most of the processor idle: OpenBLAS takes one from before AVX2 for
/// processors it does not know, which costs a factor of 2 to 5.
bool isSlowKernel(std::string_view kernel, const CpuFeatures& cpu);

/// The fastest kernel of OpenBLAS that runs there, empty where none is known.
std::string fastestKernel(const CpuFeatures& cpu);

/// Starts this program again with OPENBLAS_CORETYPE set if OpenBLAS took a slow kernel and nobody
/// chose one: it reads the variable once, before main(). Call first in main(). Returns where there
/// is nothing to do or the start fails; never starts again twice.
void ensureFastBlasKernel(char** argv);

}  // namespace hydrabench
