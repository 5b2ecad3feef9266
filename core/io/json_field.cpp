// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/json_field.h"

#include "core/io/atomic_file.h"

namespace hydrabench {

nlohmann::json parseJsonFile(const std::filesystem::path& path) {
  try {
    return nlohmann::json::parse(readFile(path));
  } catch (const nlohmann::json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, ..." without the name of the class.
    std::string reason = error.what();
    const std::size_t bracket = reason.find("] ");
    if (bracket != std::string::npos) reason.erase(0, bracket + 2);
    throw InputError(fmt::format("{}: not valid JSON: {}", path.string(), reason));
  }
}

}  // namespace hydrabench
