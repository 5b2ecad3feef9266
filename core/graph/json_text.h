// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <iterator>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <fmt/format.h>

namespace hydrabench {

/// Writes JSON as it goes: a scene mesh of a million vertices never stands in memory as a tree.
/// Numbers are the shortest that read back as the same bits; 64-bit integers stay integers.
class JsonText {
 public:
  JsonText& beginObject() { return open('{'); }
  JsonText& endObject() { return close('}'); }
  JsonText& beginArray() { return open('['); }
  JsonText& endArray() { return close(']'); }
  JsonText& key(std::string_view name);

  JsonText& value(std::string_view text);
  JsonText& value(const char* text) { return value(std::string_view(text)); }
  JsonText& value(bool flag);
  template <std::integral Integer>
  JsonText& value(Integer number) {
    separate();
    fmt::format_to(std::back_inserter(text_), "{}", number);
    return *this;
  }
  JsonText& value(double number);  ///< must be finite
  JsonText& value(const Eigen::Vector3d& v);
  JsonText& value(const Eigen::Vector3i& v);

  template <typename Value>
  JsonText& member(std::string_view name, const Value& content) {
    return key(name).value(content);
  }
  JsonText& newline() {
    text_ += '\n';
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  void separate();

  std::string text_;
  bool first_ = true;  ///< no comma before what comes next
};

}  // namespace hydrabench
