// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/checkpoint.h"

#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

/// Module::load() by itself takes tensors of any shape.
void loadModule(torch::nn::Module& module, torch::serialize::InputArchive& archive) {
  std::vector<std::vector<std::int64_t>> shapes;
  for (const torch::Tensor& tensor : module.parameters()) shapes.push_back(tensor.sizes().vec());
  module.load(archive);
  const std::vector<torch::Tensor> loaded = module.parameters();
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    TORCH_CHECK(loaded[k].sizes() == shapes[k], "a weight has another shape");
  }
}

}  // namespace

void Checkpoint::add(const std::string& name, torch::Tensor& tensor) {
  values_.push_back({name, [&tensor] { return tensor; },
                     [&tensor](const torch::Tensor& loaded) {
                       const torch::NoGradGuard no_grad;
                       tensor.copy_(loaded);
                     }});
}

void Checkpoint::add(const std::string& name, std::shared_ptr<torch::nn::Module> module) {
  modules_.emplace_back(name, std::move(module));
}

void Checkpoint::add(const std::string& name, torch::optim::Optimizer& optimizer) {
  optimizers_.emplace_back(name, &optimizer);
}

void Checkpoint::save() const {
  torch::serialize::OutputArchive archive;
  for (const Value& value : values_) archive.write(value.name, value.save());
  for (const auto& [name, module] : modules_) {
    torch::serialize::OutputArchive part(archive.compilation_unit());
    module->save(part);
    archive.write(name, part);
  }
  for (const auto& [name, optimizer] : optimizers_) {
    torch::serialize::OutputArchive part(archive.compilation_unit());
    optimizer->save(part);
    archive.write(name, part);
  }
  std::filesystem::create_directories(path_.parent_path());
  const std::filesystem::path temporary = path_.string() + ".partial";
  archive.save_to(temporary.string());
  std::filesystem::rename(temporary, path_);
}

bool Checkpoint::load() {
  if (!std::filesystem::exists(path_)) return false;
  try {
    torch::serialize::InputArchive archive;
    archive.load_from(path_.string());
    for (const Value& value : values_) {
      torch::Tensor tensor;
      archive.read(value.name, tensor);
      value.load(tensor);
    }
    for (const auto& [name, module] : modules_) {
      torch::serialize::InputArchive part;
      archive.read(name, part);
      loadModule(*module, part);
    }
    for (const auto& [name, optimizer] : optimizers_) {
      torch::serialize::InputArchive part;
      archive.read(name, part);
      optimizer->load(part);
    }
  } catch (const c10::Error& error) {
    const std::string reason = error.what_without_backtrace();
    throw InputError(fmt::format(
        "{}: is no checkpoint of this training ({}), expected one that the same config wrote",
        path_.string(), reason.substr(0, reason.find('\n'))));
  }
  return true;
}

}  // namespace hydrabench
