// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hydrabench {

/// Makes libtorch and the BLAS below it compute on the calling thread only: threads are those of
/// core/parallel, and a product that is split depends on how. Call on every thread before it uses
/// libtorch; costs nothing after the first time.
void keepTorchOnThisThread();

std::string torchVersion();
bool torchSeesCuda();
/// Throws InputError unless it is "cpu", or "cuda" and there is one.
void requireTorchDevice(const std::string& device);

/// Speed of a product of two 1024 x 1024 matrices of floats on one thread [GFLOP/s], the best of
/// what fits into `budget_s` [s].
double matrixProductRate(double budget_s);

}  // namespace hydrabench
