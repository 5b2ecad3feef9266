// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/blas_kernel.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <unistd.h>

namespace hydrabench {
namespace {

constexpr const char* kVariable = "OPENBLAS_CORETYPE";

/// OpenBLAS's kernels for AVX2 and above.
constexpr std::array<std::string_view, 5> kFastKernels = {"Haswell", "Zen", "SkylakeX",
                                                          "Cooperlake", "SapphireRapids"};

}  // namespace

CpuFeatures cpuFeatures(std::string_view flags) {
  const auto has = [&](std::string_view flag) {
    for (std::size_t at = flags.find(flag); at != std::string_view::npos;
         at = flags.find(flag, at + 1)) {
      const std::size_t end = at + flag.size();
      const bool starts = at == 0 || flags[at - 1] == ' ' || flags[at - 1] == '\t';
      if (starts && (end == flags.size() || flags[end] == ' ')) return true;
    }
    return false;
  };
  CpuFeatures cpu;
  cpu.avx2 = has("avx2") && has("fma");
  cpu.avx512 = cpu.avx2 && has("avx512f") && has("avx512bw") && has("avx512dq") &&
               has("avx512vl") && has("avx512cd");
  cpu.bf16 = cpu.avx512 && has("avx512_bf16");
  cpu.amx = has("amx_tile") && has("amx_bf16");
  return cpu;
}

CpuFeatures cpuFeatures() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    if (line.starts_with("flags")) return cpuFeatures(std::string_view(line));
  }
  return {};
}

std::string blasKernel() {
  using CoreName = char* (*)();
  const auto core_name = reinterpret_cast<CoreName>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  const char* name = core_name ? core_name() : nullptr;
  return name ? name : "";
}

bool isSlowKernel(std::string_view kernel, const CpuFeatures& cpu) {
  if (kernel.empty() || !cpu.avx2) return false;
  return std::find(kFastKernels.begin(), kFastKernels.end(), kernel) == kFastKernels.end();
}

std::string fastestKernel(const CpuFeatures& cpu) {
  if (cpu.avx512) return "SkylakeX";
  return cpu.avx2 ? "Haswell" : "";
}

void ensureFastBlasKernel(char** argv) {
  // Set by us or by the user: either way this is the process that was wanted.
  if (std::getenv(kVariable) != nullptr) return;
  const CpuFeatures cpu = cpuFeatures();
  if (!isSlowKernel(blasKernel(), cpu)) return;
  setenv(kVariable, fastestKernel(cpu).c_str(), 1);
  execv("/proc/self/exe", argv);
  unsetenv(kVariable);  // still here: go on as we are
}

}  // namespace hydrabench
