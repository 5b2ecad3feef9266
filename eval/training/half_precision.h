// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hydrabench {

/// Half precision in the forward pass of the scope, on this thread.
class Autocast {
 public:
  explicit Autocast(bool enabled);
  ~Autocast();
  Autocast(const Autocast&) = delete;
  Autocast& operator=(const Autocast&) = delete;

 private:
  bool before_;
};

/// "auto", "bf16" or "fp32" to whether to use bf16: auto where the CPU has instructions for it.
bool wantsHalfPrecision(const std::string& precision);

}  // namespace hydrabench
