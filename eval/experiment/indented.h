// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace hydrabench {

/// YAML moved to the right, to stand below a key; ends with a newline.
inline std::string indented(const std::string& yaml, std::size_t spaces) {
  const std::string margin(spaces, ' ');
  std::string text = margin;
  for (std::size_t i = 0; i < yaml.size(); ++i) {
    text += yaml[i];
    if (yaml[i] == '\n' && i + 1 < yaml.size()) text += margin;
  }
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

}  // namespace hydrabench
