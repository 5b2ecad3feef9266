// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/json_field.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "core/io/atomic_file.h"

namespace hydrabench {
namespace {

/// Python's json and printf write NaN and Infinity, which JSON has no word for. Put in quotes they
/// parse, and whoever reads the field complains with its place in the document. nullopt: none.
std::optional<std::string> quotedNonFinite(const std::string& text) {
  constexpr std::array<std::string_view, 3> kWords = {"nan", "inf", "infinity"};
  std::string quoted;
  bool changed = false;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t end = i + 1;
    if (in_string && c == '\\') {
      ++end;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '-' || std::isalpha(static_cast<unsigned char>(c)) != 0)) {
      std::string word;
      while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
      for (std::size_t k = i + (c == '-' ? 1 : 0); k < end; ++k) {
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[k])));
      }
      if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) {
        quoted += '"' + text.substr(i, end - i) + '"';
        changed = true;
        i = end;
        continue;
      }
    }
    end = std::min(end, text.size());
    quoted.append(text, i, end - i);
    i = end;
  }
  return changed ? std::optional(std::move(quoted)) : std::nullopt;
}

}  // namespace

nlohmann::json parseJsonFile(const std::filesystem::path& path) {
  const std::string text = readFile(path);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    if (const auto quoted = quotedNonFinite(text)) {
      nlohmann::json json = nlohmann::json::parse(*quoted, nullptr, false);
      if (!json.is_discarded()) return json;
    }
    // "[json.exception.parse_error.101] parse error at line 1, ..." without the name of the class.
    std::string reason = error.what();
    const std::size_t bracket = reason.find("] ");
    if (bracket != std::string::npos) reason.erase(0, bracket + 2);
    throw InputError(fmt::format("{}: not valid JSON: {}", path.string(), reason));
  }
}

}  // namespace hydrabench
