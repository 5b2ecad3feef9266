// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/sharded.h"

#include <ATen/autocast_mode.h>
#include <fstream>
#include <iterator>
#include <string>

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
  std::ifstream file("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return text.find("amx_bf16") != std::string::npos ||
         text.find("avx512_bf16") != std::string::npos;
}

}  // namespace hydrabench
