// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_model.h"

#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/crisp_models.h"
#include "core/shape/crisp/torch_runtime.h"

namespace hydrabench {

std::unique_ptr<const CrispModel> loadCrispModel(const std::filesystem::path& manifest,
                                                 const std::string& device) {
  requireTorchDevice(device);
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(manifest, error);
  const CrispManifest read = readCrispManifest(is_folder ? manifest / "manifest.yaml" : manifest);
  if (read.preset == "full") return loadFullCrisp(read, device);
  return loadSmallCrisp(read, device);
}

}  // namespace hydrabench
