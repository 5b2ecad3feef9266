// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/config/config_node.h"

namespace hydrabench {

/// What stands in a node, for messages: 'abc', a list, a map, nothing.
std::string found(const ConfigDocument::Node& node);

/// Sets `value` if the node holds one of that type; always says in `expected` what would have been
/// right.
void parse(const ConfigDocument::Node& node, std::optional<bool>& value, std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<int>& value, std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<std::int64_t>& value,
           std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<std::uint64_t>& value,
           std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<float>& value, std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<double>& value, std::string& expected);
void parse(const ConfigDocument::Node& node, std::optional<std::string>& value,
           std::string& expected);

/// A string as YAML: plain where that reads back as the same string, else in double quotes.
std::string yamlText(const std::string& text);

/// Shortest decimal number that reads back as the same bits.
template <typename Number>
requires std::integral<Number> || std::floating_point<Number> std::string yamlText(
    const Number& number) {
  return fmt::format("{}", number);
}

}  // namespace hydrabench
