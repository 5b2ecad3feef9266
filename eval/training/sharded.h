// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <functional>
#include <vector>

#include <torch/torch.h>

namespace hydrabench {

/// Copies of a module that share its values but not its gradients: each works on a part of the
/// batch in a thread of its own, and the gradients are added up in a fixed order. (libtorch's own
/// threads slow half-precision down, and would make results depend on their number.)
template <typename Module>
class Shards {
 public:
  /// @param make  a module of the same structure
  Shards(Module master, int count, const std::function<Module()>& make) : master_(master) {
    const std::vector<torch::Tensor> values = master->parameters();
    for (int i = 0; i < count; ++i) {
      Module copy = make();
      std::vector<torch::Tensor> parameters = copy->parameters();
      for (std::size_t k = 0; k < parameters.size(); ++k) parameters[k].set_data(values[k].data());
      copies_.push_back(copy);
    }
  }
  Module& operator[](std::size_t i) { return copies_[i]; }
  std::size_t size() const { return copies_.size(); }

  /// Sets the master's gradients to the mean of the copies' and clears those.
  void collectGradients() {
    const torch::NoGradGuard no_grad;
    std::vector<torch::Tensor> values = master_->parameters();
    for (std::size_t k = 0; k < values.size(); ++k) {
      torch::Tensor sum;
      for (Module& copy : copies_) {
        torch::Tensor& gradient = copy->parameters()[k].mutable_grad();
        if (!gradient.defined()) continue;
        if (sum.defined()) {
          sum.add_(gradient);
        } else {
          sum = gradient.clone();
        }
        gradient.zero_();
      }
      if (sum.defined()) values[k].mutable_grad() = sum.div_(static_cast<double>(copies_.size()));
    }
  }

 private:
  Module master_;
  std::vector<Module> copies_;
};

}  // namespace hydrabench
