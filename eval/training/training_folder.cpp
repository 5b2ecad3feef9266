// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_folder.h"

#include <fmt/format.h>
#include <torch/torch.h>

#include "core/io/atomic_file.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

void requireSameConfig(const std::filesystem::path& file, const std::string& resolved) {
  if (!std::filesystem::exists(file)) {
    writeFileAtomic(file, resolved);
  } else if (readFile(file) != resolved) {
    throw InputError(
        fmt::format("{}: belongs to a training with other settings, expected the same or an empty "
                    "folder",
                    file.string()));
  }
}

}  // namespace

void beginTraining(const std::filesystem::path& out, const std::string& resolved,
                   std::uint64_t seed) {
  keepTorchOnThisThread();
  std::filesystem::create_directories(out);
  requireSameConfig(out / "config.yaml", resolved);
  torch::manual_seed(seed);
}

}  // namespace hydrabench
