// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string>

#include <fmt/format.h>

namespace hydrabench {

/// A string as YAML: plain where that reads back as the same string, else in double quotes.
std::string yamlText(const std::string& text);

/// Shortest decimal number that reads back as the same bits.
template <typename Number>
requires std::integral<Number> || std::floating_point<Number> std::string yamlText(
    const Number& number) {
  return fmt::format("{}", number);
}

}  // namespace hydrabench
