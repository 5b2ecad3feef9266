// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <torch/torch.h>

namespace hydrabench {

/// The state of a training in one file, replaced as a whole: a training that is stopped at any
/// moment goes on from the last one. A state is named values; each knows how to be saved and
/// loaded.
class Checkpoint {
 public:
  struct Value {
    std::string name;
    std::function<torch::Tensor()> save;
    std::function<void(const torch::Tensor&)> load;
  };
  Checkpoint(std::filesystem::path path, std::vector<Value> values)
      : path_(std::move(path)), values_(std::move(values)) {}
  void add(const std::string& name, torch::Tensor& tensor);  ///< filled in place
  void add(const std::string& name, std::shared_ptr<torch::nn::Module> module);
  void add(const std::string& name, torch::optim::Optimizer& optimizer);

  void save() const;
  /// False if there is no file. Throws InputError where the file is broken or of another network.
  bool load();

 private:
  std::filesystem::path path_;
  std::vector<Value> values_;
  std::vector<std::pair<std::string, std::shared_ptr<torch::nn::Module>>> modules_;
  std::vector<std::pair<std::string, torch::optim::Optimizer*>> optimizers_;
};

}  // namespace hydrabench
