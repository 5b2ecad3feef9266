// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/config/config_yaml.h"

#include <cctype>
#include <string_view>

namespace hydrabench {
namespace {

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
