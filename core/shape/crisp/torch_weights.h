// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <torch/torch.h>

#include "core/io/safetensors.h"

namespace hydrabench {

/// Copies the tensors of a safetensors file into the parameters and buffers of the same names,
/// converting the type of number. Strict: every name of either side exists on the other, shapes are
/// equal, all numbers finite. Otherwise InputError in one line that names file, tensor and both
/// shapes, and the module is as before.
void loadWeights(torch::nn::Module& module, const std::filesystem::path& path);

/// Writes parameters and buffers. Numbers with a fraction are stored as `type` (kF32, kF16 or
/// kBf16), whole ones as they are.
void saveWeights(const torch::nn::Module& module, const std::filesystem::path& path,
                 const std::map<std::string, std::string>& metadata = {},
                 TensorType type = TensorType::kF32);

/// A copy of a tensor of a file.
torch::Tensor toTorch(const StoredTensor& stored);

}  // namespace hydrabench
