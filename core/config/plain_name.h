// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace hydrabench {

/// Names of methods and datasets become folders, CSV cells and parts of keys: letters, digits, '_',
/// '-' and '+', beginning with a letter.
inline bool isPlainName(std::string_view name) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if (name.empty() || kLetters.find(name.front()) == std::string_view::npos) return false;
  for (const char c : name) {
    if (kLetters.find(c) == std::string_view::npos &&
        std::string_view("0123456789_-+").find(c) == std::string_view::npos) {
      return false;
    }
  }
  return true;
}
inline constexpr const char* kPlainNameExpected =
    "expected letters, digits, '_', '-' and '+' only, beginning with a letter";

}  // namespace hydrabench
