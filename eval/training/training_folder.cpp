// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_folder.h"

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {

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

}  // namespace hydrabench
