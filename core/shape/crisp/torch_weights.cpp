// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/torch_weights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

struct TypePair {
  TensorType stored;
  torch::ScalarType torch;
};
constexpr std::array kTypes = {
    TypePair{TensorType::kF64, torch::kFloat64}, TypePair{TensorType::kF32, torch::kFloat32},
    TypePair{TensorType::kF16, torch::kFloat16}, TypePair{TensorType::kBf16, torch::kBFloat16},
    TypePair{TensorType::kI64, torch::kInt64},   TypePair{TensorType::kI32, torch::kInt32},
    TypePair{TensorType::kU8, torch::kUInt8},    TypePair{TensorType::kBool, torch::kBool},
};

torch::ScalarType torchType(TensorType type) {
  return std::ranges::find(kTypes, type, &TypePair::stored)->torch;
}

TensorType storedType(torch::ScalarType type) {
  const auto it = std::ranges::find(kTypes, type, &TypePair::torch);
  assert(it != kTypes.end());
  return it->stored;
}

/// Parameters and buffers by name, sorted.
std::map<std::string, torch::Tensor> namedTensors(const torch::nn::Module& module) {
  std::map<std::string, torch::Tensor> tensors;
  for (const auto& item : module.named_parameters()) tensors[item.key()] = item.value();
  for (const auto& item : module.named_buffers()) tensors[item.key()] = item.value();
  return tensors;
}

std::string shapeText(const torch::Tensor& tensor) {
  return hydrabench::shapeText({tensor.sizes().data(), tensor.sizes().size()});
}

}  // namespace

torch::Tensor toTorch(const StoredTensor& stored) {
  torch::Tensor tensor = torch::empty(stored.shape, torchType(stored.type));
  if (!stored.bytes.empty()) {
    std::memcpy(tensor.data_ptr(), stored.bytes.data(), stored.bytes.size());
  }
  return tensor;
}

void loadWeights(torch::nn::Module& module, const std::filesystem::path& path) {
  const torch::NoGradGuard no_grad;
  const SafetensorsFile file = SafetensorsFile::read(path);
  const std::map<std::string, torch::Tensor> targets = namedTensors(module);
  const std::string name = path.string();
  for (const auto& [key, target] : targets) {
    if (!file.tensors().contains(key)) {
      throw InputError(fmt::format("{}: {}: missing, the network expects it with shape {}", name,
                                   key, shapeText(target)));
    }
  }
  std::map<std::string, torch::Tensor> values;
  for (const auto& [key, stored] : file.tensors()) {
    const auto target = targets.find(key);
    if (target == targets.end()) {
      throw InputError(fmt::format("{}: {}: shape {}, but the network has no such tensor", name,
                                   key, hydrabench::shapeText(stored.shape)));
    }
    if (target->second.sizes() != torch::IntArrayRef(stored.shape)) {
      throw InputError(fmt::format("{}: {}: shape {}, the network expects {}", name, key,
                                   hydrabench::shapeText(stored.shape), shapeText(target->second)));
    }
    torch::Tensor value = toTorch(stored).to(target->second.scalar_type());
    if (!torch::isfinite(value).all().item<bool>()) {
      throw InputError(fmt::format(
          "{}: {}: has numbers that are not finite, expected finite weights", name, key));
    }
    values[key] = std::move(value);
  }
  for (const auto& [key, target] : targets) torch::Tensor(target).copy_(values.at(key));
}

void saveWeights(const torch::nn::Module& module, const std::filesystem::path& path,
                 const std::map<std::string, std::string>& metadata, TensorType type) {
  assert(torch::isFloatingType(torchType(type)));
  const torch::NoGradGuard no_grad;
  std::map<std::string, torch::Tensor> values;  // keeps the bytes alive
  std::map<std::string, StoredTensor> stored;
  for (const auto& [key, tensor] : namedTensors(module)) {
    const torch::ScalarType as =
        tensor.is_floating_point() ? torchType(type) : tensor.scalar_type();
    const torch::Tensor value = values[key] = tensor.to(torch::kCPU, as).contiguous();
    stored[key] = {storedType(as),
                   value.sizes().vec(),
                   {static_cast<const std::byte*>(value.data_ptr()), value.nbytes()}};
  }
  writeSafetensors(path, stored, metadata);
}

}  // namespace hydrabench
