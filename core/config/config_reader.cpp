// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/config/config_reader.h"

#include <algorithm>
#include <concepts>
#include <deque>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/config_node.h"
#include "core/config/config_value.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using Node = ConfigDocument::Node;
using NodePtr = Node::Ptr;
using Kind = Node::Kind;

struct Fault {
  int source_order = 0;
  int line = 0;
  std::string text;
};

std::string expectation(const Bounds& bounds) {
  const bool low = bounds.low > -1e300;
  const bool high = bounds.high < 1e300;
  if (low && high) return fmt::format("{} to {}", bounds.low, bounds.high);
  return low ? fmt::format("at least {}", bounds.low) : fmt::format("at most {}", bounds.high);
}

}  // namespace

struct ConfigReader::Impl : std::enable_shared_from_this<Impl> {
  /// What a declared key resolved to: a value as YAML, a map, or a list of maps.
  struct Declared {
    std::string key;
    std::optional<std::string> value;
    std::vector<std::shared_ptr<Impl>> readers;
    bool is_list = false;
  };

  NodePtr node;      ///< the map read from; null where the document has none
  std::string path;  ///< "sensor.noise.", empty at the top
  NodePtr document;
  std::shared_ptr<std::vector<Fault>> faults;
  std::shared_ptr<std::vector<std::filesystem::path>> paths;
  std::weak_ptr<Impl>
      root;  ///< the outermost reader; the document's tree of readers must not own itself
  std::deque<Declared> declared;

  Declared& declare(std::string_view key) {
    for (Declared& entry : declared) {
      if (entry.key == key) return entry;
    }
    declared.push_back({.key = std::string(key), .value = {}, .readers = {}});
    return declared.back();
  }

  NodePtr find(std::string_view key) const { return node ? node->member(key) : nullptr; }

  void addFault(const Node& at, std::string_view key, const std::string& message) {
    const std::string full_key = path + std::string(key);
    const std::string place = at.place();
    // "--set a.b" names the key already.
    const bool named = at.source->isOverride() && place.ends_with(" " + full_key);
    faults->push_back({at.source->order, at.line,
                       named ? fmt::format("{}: {}", place, message)
                             : fmt::format("{}: {}: {}", place, full_key, message)});
  }

  std::shared_ptr<Impl> nested(const NodePtr& map, const std::string& prefix) {
    auto impl = std::make_shared<Impl>();
    impl->node = map;
    impl->path = path + prefix + ".";
    impl->document = document;
    impl->faults = faults;
    impl->paths = paths;
    impl->root = path.empty() ? weak_from_this() : root;
    return impl;
  }

  template <typename Value>
  bool inBounds(const Node& at, std::string_view key, const Value& value, const Bounds& bounds) {
    if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
      const auto number = static_cast<double>(value);
      if (number < bounds.low || number > bounds.high) {
        addFault(at, key,
                 fmt::format("{} is out of bounds, expected {}", value, expectation(bounds)));
        return false;
      }
    }
    return true;
  }

  template <typename Value>
  void readScalar(std::string_view key, Value& value, const Bounds& bounds) {
    Declared& entry = declare(key);
    if (const NodePtr at = find(key)) {
      std::optional<Value> read;
      std::string expected;
      parse(*at, read, expected);
      if (!read) {
        addFault(*at, key, fmt::format("expected {}, found {}", expected, found(*at)));
      } else if (inBounds(*at, key, *read, bounds)) {
        value = *read;
      }
    }
    entry.value = yamlText(value);
  }

  template <typename Value>
  void readList(std::string_view key, std::vector<Value>& values, const Bounds& bounds) {
    Declared& entry = declare(key);
    if (const NodePtr at = find(key)) {
      if (at->kind != Kind::kList) {
        addFault(*at, key, fmt::format("expected a list as in [a, b], found {}", found(*at)));
      } else {
        values.clear();
        for (std::size_t i = 0; i < at->items.size(); ++i) {
          const Node& item = *at->items[i];
          const std::string item_key = fmt::format("{}.{}", key, i);
          std::optional<Value> read;
          std::string expected;
          parse(item, read, expected);
          if (!read) {
            addFault(item, item_key, fmt::format("expected {}, found {}", expected, found(item)));
          } else if (inBounds(item, item_key, *read, bounds)) {
            values.push_back(*read);
          }
        }
      }
    }
    std::vector<std::string> texts;
    for (const Value& value : values) texts.push_back(yamlText(value));
    entry.value = fmt::format("[{}]", fmt::join(texts, ", "));
  }

  std::vector<std::string> knownKeys() const {
    std::vector<std::string> keys;
    for (const Declared& entry : declared) keys.push_back(entry.key);
    return keys;
  }

  /// Full path of a declared key with this very name at another level, where there is one.
  std::string elsewhere(std::string_view key) const {
    for (const Declared& entry : declared) {
      if (entry.key == key) return path + entry.key;
      for (const auto& reader : entry.readers) {
        std::string hit = reader->elsewhere(key);
        if (!hit.empty()) return hit;
      }
    }
    return "";
  }

  void collectUnknownKeys(const Impl& top) {
    for (const Declared& entry : declared) {
      for (const auto& reader : entry.readers) reader->collectUnknownKeys(top);
    }
    if (!node) return;
    for (const auto& [key, value] : node->members) {
      const std::vector<std::string> known = knownKeys();
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      std::string guess = didYouMean(key, known);
      if (!guess.empty()) guess = path + guess;
      if (guess.empty()) guess = top.elsewhere(key);
      addFault(*value, key,
               guess.empty()
                   ? fmt::format("unknown key, expected one of: {}", fmt::join(known, ", "))
                   : fmt::format("unknown key, did you mean {}?", guess));
    }
  }

  void print(std::string& yaml, const std::string& indent) const {
    for (const Declared& entry : declared) {
      if (entry.value) {
        yaml += fmt::format("{}{}: {}\n", indent, yamlText(entry.key), *entry.value);
      } else if (entry.readers.empty()) {
        if (entry.is_list) yaml += fmt::format("{}{}: []\n", indent, yamlText(entry.key));
      } else if (!entry.is_list) {
        std::string inner;
        entry.readers.front()->print(inner, indent + "  ");
        if (!inner.empty()) yaml += fmt::format("{}{}:\n{}", indent, yamlText(entry.key), inner);
      } else {
        yaml += fmt::format("{}{}:\n", indent, yamlText(entry.key));
        for (const auto& reader : entry.readers) {
          std::string inner;
          reader->print(inner, indent + "    ");
          if (inner.empty()) inner = indent + "    {}\n";
          inner[indent.size() + 2] = '-';
          yaml += inner;
        }
      }
    }
  }
};

ConfigReader::ConfigReader(const ConfigDocument& document) : impl_(std::make_shared<Impl>()) {
  impl_->node = document.root();
  impl_->document = document.root();
  impl_->faults = std::make_shared<std::vector<Fault>>();
  impl_->paths = std::make_shared<std::vector<std::filesystem::path>>();
}
ConfigReader::ConfigReader(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
ConfigReader::~ConfigReader() = default;
ConfigReader::ConfigReader(ConfigReader&&) noexcept = default;

void ConfigReader::field(std::string_view key, bool& value) { impl_->readScalar(key, value, {}); }
void ConfigReader::field(std::string_view key, int& value, Bounds bounds) {
  impl_->readScalar(key, value, bounds);
}
void ConfigReader::field(std::string_view key, std::int64_t& value, Bounds bounds) {
  impl_->readScalar(key, value, bounds);
}
void ConfigReader::field(std::string_view key, std::uint64_t& value) {
  impl_->readScalar(key, value, {});
}
void ConfigReader::field(std::string_view key, float& value, Bounds bounds) {
  impl_->readScalar(key, value, bounds);
}
void ConfigReader::field(std::string_view key, double& value, Bounds bounds) {
  impl_->readScalar(key, value, bounds);
}
void ConfigReader::field(std::string_view key, std::string& value) {
  impl_->readScalar(key, value, {});
}
void ConfigReader::field(std::string_view key, std::vector<double>& value, Bounds bounds) {
  impl_->readList(key, value, bounds);
}
void ConfigReader::field(std::string_view key, std::vector<int>& value, Bounds bounds) {
  impl_->readList(key, value, bounds);
}
void ConfigReader::field(std::string_view key, std::vector<std::string>& value) {
  impl_->readList(key, value, {});
}

void ConfigReader::path(std::string_view key, std::filesystem::path& value) {
  std::string text = value.string();
  impl_->readScalar(key, text, {});
  value = text;
  const NodePtr node = impl_->find(key);
  if (node && !text.empty() && value.is_relative()) {
    value = (node->source->folder / value).lexically_normal();
    impl_->declare(key).value = yamlText(value.string());
  }
  if (!value.empty()) impl_->paths->push_back(value);
}

const std::vector<std::filesystem::path>& ConfigReader::paths() const { return *impl_->paths; }

void ConfigReader::choice(std::string_view key, std::string& value,
                          const std::vector<std::string>& allowed) {
  const std::string before = value;
  impl_->readScalar(key, value, {});
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
  if (const NodePtr node = impl_->find(key); node && node->kind == Kind::kScalar) {
    const std::string guess = didYouMean(value, allowed);
    impl_->addFault(
        *node, key,
        fmt::format("'{}' is unknown, expected one of: {}{}", value, fmt::join(allowed, ", "),
                    guess.empty() ? "" : fmt::format("; did you mean {}?", guess)));
    value = before;
  }
}

void ConfigReader::require(std::string_view key) {
  impl_->declare(key);
  if (has(key)) return;
  const Node& place = impl_->node ? *impl_->node : *impl_->document;
  impl_->addFault(place, key, "missing, must be given");
}

bool ConfigReader::has(std::string_view key) const {
  const NodePtr node = impl_->find(key);
  return node && node->kind != Kind::kNull;
}

ConfigReader ConfigReader::section(std::string_view key) {
  Impl::Declared& entry = impl_->declare(key);
  if (entry.readers.empty()) {
    NodePtr node = impl_->find(key);
    if (node && node->kind != Kind::kMap) {
      if (node->kind != Kind::kNull) {
        impl_->addFault(*node, key,
                        fmt::format("expected keys with values (a map), found {}", found(*node)));
      }
      node = nullptr;
    }
    entry.readers.push_back(impl_->nested(node, std::string(key)));
  }
  return ConfigReader(entry.readers.front());
}

std::vector<ConfigReader> ConfigReader::list(std::string_view key) {
  Impl::Declared& entry = impl_->declare(key);
  entry.is_list = true;
  entry.readers.clear();
  std::vector<ConfigReader> readers;
  const NodePtr node = impl_->find(key);
  if (!node || node->kind == Kind::kNull) return readers;
  if (node->kind != Kind::kList) {
    impl_->addFault(*node, key, fmt::format("expected a list, found {}", found(*node)));
    return readers;
  }
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const NodePtr& item = node->items[i];
    const std::string item_key = fmt::format("{}.{}", key, i);
    if (item->kind != Kind::kMap) {
      impl_->addFault(*item, item_key,
                      fmt::format("expected keys with values (a map), found {}", found(*item)));
      continue;
    }
    entry.readers.push_back(impl_->nested(item, item_key));
    readers.push_back(ConfigReader(entry.readers.back()));
  }
  return readers;
}

void ConfigReader::fault(std::string_view key, const std::string& message) {
  const NodePtr node = impl_->find(key);
  impl_->addFault(node ? *node : impl_->node ? *impl_->node : *impl_->document, key, message);
}

void ConfigReader::finish() {
  const std::shared_ptr<Impl> outermost = impl_->root.lock();
  Impl& top = outermost ? *outermost : *impl_;
  top.collectUnknownKeys(top);
  throwFaults();
}

void ConfigReader::throwFaults() {
  std::vector<Fault> faults = std::move(*impl_->faults);
  impl_->faults->clear();
  if (faults.empty()) return;
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::pair(a.source_order, a.line) < std::pair(b.source_order, b.line);
  });
  std::vector<std::string> lines;
  for (Fault& fault : faults) lines.push_back(std::move(fault.text));
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string ConfigReader::resolved() const {
  std::string yaml;
  impl_->print(yaml, "");
  return yaml;
}

}  // namespace hydrabench
