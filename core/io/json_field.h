// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/types/error.h"

namespace hydrabench {

/// A JSON value that knows where it stands, so that every complaint names file, node and field. For
/// .cpp files only.
class JsonField {
 public:
  using Json = nlohmann::json;
  JsonField(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  const Json& json() const { return *json_; }
  const std::string& place() const { return place_; }

  [[noreturn]] void fail(const std::string& expected) const {
    std::string found = json_->dump(-1, ' ', false, Json::error_handler_t::replace);
    if (json_->is_structured()) found = json_->is_array() ? "a list" : "an object";
    if (found.size() > 40) found = found.substr(0, 37) + "...";
    throw InputError(fmt::format("{}expected {}, found {}", colon(), expected, found));
  }
  [[noreturn]] void complain(const std::string& message) const {
    throw InputError(colon() + message);
  }

  JsonField renamed(std::string place) const { return {*json_, std::move(place)}; }

  bool has(const char* key) const {
    const auto it = json_->is_object() ? json_->find(key) : json_->end();
    return json_->is_object() && it != json_->end() && !it->is_null();
  }
  JsonField at(const char* key) const {
    if (!json_->is_object()) fail("an object");
    const auto it = json_->find(key);
    if (it == json_->end()) {
      throw InputError(fmt::format("{}{}: missing", withSeparator(), key));
    }
    return {*it, withSeparator() + key};
  }
  std::optional<JsonField> find(const char* key) const {
    return has(key) ? std::optional<JsonField>(at(key)) : std::nullopt;
  }

  std::size_t size() const {
    if (!json_->is_array()) fail("a list");
    return json_->size();
  }
  /// The place of an item is put together only when something is wrong with it: lists are long.
  template <typename Visit>
  void forEach(const Visit& visit) const {
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i) visit(i, (*json_)[i]);
  }
  JsonField item(std::size_t i) const { return {(*json_)[i], fmt::format("{}[{}]", place_, i)}; }

  std::int64_t integer() const {
    if (!json_->is_number_integer()) fail("an integer");
    if (json_->is_number_unsigned() && json_->get<std::uint64_t>() > INT64_MAX) fail("an integer");
    return json_->get<std::int64_t>();
  }
  std::uint64_t unsignedInteger(const char* expected = "an integer from 0 on") const {
    if (!json_->is_number_unsigned()) fail(expected);
    return json_->get<std::uint64_t>();
  }
  double number() const {
    if (!json_->is_number()) fail("a number");
    const double value = json_->get<double>();
    if (!std::isfinite(value)) fail("a finite number");
    return value;
  }
  std::string text() const {
    if (!json_->is_string()) fail("a string");
    return json_->get<std::string>();
  }
  bool boolean() const {
    if (!json_->is_boolean()) fail("true or false");
    return json_->get<bool>();
  }
  Eigen::Vector3d vector3() const {
    if (size() != 3) fail("three numbers");
    return {component(0), component(1), component(2)};
  }

 private:
  std::string colon() const { return place_ + (place_.ends_with(": ") ? "" : ": "); }
  std::string withSeparator() const { return place_ + (place_.ends_with(": ") ? "" : "."); }
  double component(std::size_t i) const {
    const Json& value = (*json_)[i];
    return value.is_number() && std::isfinite(value.get<double>()) ? value.get<double>()
                                                                   : item(i).number();
  }

  const Json* json_;
  std::string place_;
};

/// Parses a file; a syntax error is one line with the place in the file. NaN and Infinity, which
/// many writers leave without a word, become strings: number() then complains with the field.
nlohmann::json parseJsonFile(const std::filesystem::path& path);

}  // namespace hydrabench
