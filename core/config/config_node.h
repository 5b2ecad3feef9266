// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/config_reader.h"

namespace hydrabench {

/// Where a document came from; shared by all its nodes.
struct ConfigSource {
  static constexpr int kFirstOverride = 1'000'000;

  std::string name;
  std::filesystem::path folder;
  int order = 0;  ///< the document 0, its bases 1, 2 ...; overrides from kFirstOverride on

  bool isOverride() const { return order >= kFirstOverride; }
};

/// Our own tree instead of yaml-cpp's, because values of one document come from several files and
/// the command line, and because yaml-cpp stays in one .cpp file.
struct ConfigDocument::Node {
  enum class Kind { kNull, kScalar, kList, kMap };
  using Ptr = std::shared_ptr<Node>;

  Kind kind = Kind::kNull;
  std::string text;                                  ///< of a scalar
  bool quoted = false;                               ///< "5" is a string, 5 a number
  std::vector<std::pair<std::string, Ptr>> members;  ///< of a map, in the order of the file
  std::vector<Ptr> items;                            ///< of a list
  std::shared_ptr<const ConfigSource> source;
  int line = 0;  ///< from 1; 0: the whole source

  Ptr member(std::string_view key) const {
    for (const auto& [name, node] : members) {
      if (name == key) return node;
    }
    return nullptr;
  }
  /// "office.yaml:12" or "--set a.b"
  std::string place() const {
    return line > 0 ? source->name + ":" + std::to_string(line) : source->name;
  }
};

}  // namespace hydrabench
