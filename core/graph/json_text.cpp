// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/graph/json_text.h"

#include <cassert>
#include <cmath>

namespace hydrabench {

void JsonText::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  value(name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonText& JsonText::value(std::string_view text) {
  separate();
  text_ += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text_ += c;
    }
  }
  text_ += '"';
  return *this;
}

JsonText& JsonText::value(bool flag) {
  separate();
  text_ += flag ? "true" : "false";
  return *this;
}

JsonText& JsonText::value(double number) {
  assert(std::isfinite(number));
  separate();
  // "-0" would be read as the integer 0 and lose its sign.
  if (number == 0 && std::signbit(number)) {
    text_ += "-0.0";
  } else {
    fmt::format_to(std::back_inserter(text_), "{}", number);
  }
  return *this;
}

JsonText& JsonText::value(const Eigen::Vector3d& v) {
  return beginArray().value(v.x()).value(v.y()).value(v.z()).endArray();
}
JsonText& JsonText::value(const Eigen::Vector3i& v) {
  return beginArray().value(v.x()).value(v.y()).value(v.z()).endArray();
}

}  // namespace hydrabench
