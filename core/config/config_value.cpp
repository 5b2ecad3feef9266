// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/config/config_value.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace hydrabench {
namespace {

using Node = ConfigDocument::Node;
using Kind = Node::Kind;

template <typename Number>
std::optional<Number> parseNumber(const Node& node, std::string& expected) {
  expected = std::floating_point<Number> ? "a finite number"
             : std::unsigned_integral<Number>
                 ? "a whole number from 0 on"
                 : fmt::format("a whole number of {} bit", sizeof(Number) * 8);
  if (node.kind != Kind::kScalar || node.quoted) return std::nullopt;
  std::string_view text = node.text;
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::floating_point<Number>) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  return number;
}
/// Letters, digits and harmless punctuation, starting with a letter, '/' or '.'+'/': never taken
/// for a number, null or a structure.
bool isPlain(const std::string& text) {
  if (text.empty()) return false;
  const auto first = static_cast<unsigned char>(text.front());
  const bool relative = text.starts_with("./") || text.starts_with("../");
  if (!std::isalpha(first) && first != '/' && first != '_' && !relative) return false;
  for (const char c : text) {
    const bool harmless = std::string_view("_-./+ ").find(c) != std::string_view::npos;
    if (!std::isalnum(static_cast<unsigned char>(c)) && !harmless) return false;
  }
  if (text.back() == ' ') return false;
  for (const char* word : {"true", "false", "null", "yes", "no", "on", "off", "y", "n"}) {
    std::string lower;
    for (const char c : text) {
      lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (lower == word) return false;
  }
  return true;
}

}  // namespace

std::string found(const Node& node) {
  switch (node.kind) {
    case Kind::kScalar:
      return node.quoted ? fmt::format("\"{}\"", node.text) : fmt::format("'{}'", node.text);
    case Kind::kList:
      return "a list";
    case Kind::kMap:
      return "a map";
    case Kind::kNull:
      break;
  }
  return "nothing";
}

void parse(const Node& node, std::optional<int>& value, std::string& expected) {
  value = parseNumber<int>(node, expected);
}
void parse(const Node& node, std::optional<std::int64_t>& value, std::string& expected) {
  value = parseNumber<std::int64_t>(node, expected);
}
void parse(const Node& node, std::optional<std::uint64_t>& value, std::string& expected) {
  value = parseNumber<std::uint64_t>(node, expected);
}
void parse(const Node& node, std::optional<float>& value, std::string& expected) {
  value = parseNumber<float>(node, expected);
}
void parse(const Node& node, std::optional<double>& value, std::string& expected) {
  value = parseNumber<double>(node, expected);
}
void parse(const Node& node, std::optional<bool>& value, std::string& expected) {
  expected = "true or false";
  if (node.kind != Kind::kScalar || node.quoted) return;
  if (node.text == "true" || node.text == "True" || node.text == "TRUE") value = true;
  if (node.text == "false" || node.text == "False" || node.text == "FALSE") value = false;
}
void parse(const Node& node, std::optional<std::string>& value, std::string& expected) {
  expected = "a word";
  if (node.kind == Kind::kScalar) value = node.text;
}

std::string yamlText(const std::string& text) {
  if (isPlain(text)) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (c == '\t') {
      quoted += "\\t";
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\x{:02x}", byte);
    } else {
      quoted += c;  // UTF-8 passes through
    }
  }
  return quoted + '"';
}

}  // namespace hydrabench
