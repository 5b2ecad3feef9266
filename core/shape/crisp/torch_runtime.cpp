// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/torch_runtime.h"

#include <algorithm>
#include <chrono>

#include <ATen/Context.h>
#include <ATen/Functions.h>
#include <ATen/Parallel.h>
#include <torch/version.h>

#include "core/types/error.h"

namespace hydrabench {

void keepTorchOnThisThread() {
  // Reaches OpenMP's setting of the calling thread only, which is what OpenBLAS reads.
  thread_local const bool done = [] {
    at::set_num_threads(1);
    return true;
  }();
  static_cast<void>(done);
}

std::string torchVersion() { return TORCH_VERSION; }

bool torchSeesCuda() { return at::hasCUDA(); }

void requireTorchDevice(const std::string& device) {
  if (device != "cpu" && device != "cuda") {
    throw InputError("device: '" + device + "': expected cpu or cuda");
  }
  if (device == "cuda" && !torchSeesCuda()) {
    throw InputError("device: 'cuda': this libtorch (" + torchVersion() +
                     ") sees no GPU; expected cpu");
  }
}

double matrixProductRate(double budget_s) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t kSide = 1024;
  keepTorchOnThisThread();
  const at::Tensor a = at::rand({kSide, kSide});
  const at::Tensor b = at::rand({kSide, kSide});
  const Clock::time_point start = Clock::now();
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  double best = 0;
  do {
    const Clock::time_point begin = Clock::now();
    const at::Tensor product = at::mm(a, b);
    const double flops = 2.0 * kSide * kSide * kSide;
    best = std::max(best, flops / seconds(Clock::now() - begin) * 1e-9);
  } while (seconds(Clock::now() - start) < budget_s);
  return best;
}

}  // namespace hydrabench
