// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/half_precision.h"

#include <ATen/autocast_mode.h>
#include <torch/torch.h>

#include "core/shape/crisp/blas_kernel.h"

namespace hydrabench {

Autocast::Autocast(bool enabled) : before_(at::autocast::is_cpu_enabled()) {
  at::autocast::set_autocast_cpu_dtype(torch::kBFloat16);
  at::autocast::set_cpu_enabled(enabled);
  at::autocast::increment_nesting();
}

Autocast::~Autocast() {
  // Leaving the outermost scope drops the cast copies of the weights, which are about to change.
  if (at::autocast::decrement_nesting() == 0) at::autocast::clear_cache();
  at::autocast::set_cpu_enabled(before_);
}

bool wantsHalfPrecision(const std::string& precision) {
  if (precision != "auto") return precision == "bf16";
  const CpuFeatures cpu = cpuFeatures();
  return cpu.bf16 || cpu.amx;
}

}  // namespace hydrabench
