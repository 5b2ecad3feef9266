// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/config/config_node.h"
#include "core/config/config_reader.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

using Node = ConfigDocument::Node;
using NodePtr = Node::Ptr;
using Kind = Node::Kind;
using SourcePtr = std::shared_ptr<const ConfigSource>;

/// Copies yaml-cpp's tree into ours.
class Converter {
 public:
  explicit Converter(SourcePtr source) : source_(std::move(source)) {}

  NodePtr convert(const YAML::Node& yaml, int depth = 0) {
    // Aliases may refer to each other: a small file can describe an endless or an enormous tree.
    if (depth > 64 || ++count_ > 1'000'000) {
      throw InputError(fmt::format("{}: nested too deeply or too large", source_->name));
    }
    auto node = std::make_shared<Node>();
    node->source = source_;
    node->line = source_->isOverride() ? 0 : yaml.Mark().line + 1;
    if (yaml.IsScalar()) {
      node->kind = Kind::kScalar;
      node->text = yaml.Scalar();
      node->quoted = yaml.Tag() == "!";
    } else if (yaml.IsSequence()) {
      node->kind = Kind::kList;
      for (const YAML::Node& item : yaml) node->items.push_back(convert(item, depth + 1));
    } else if (yaml.IsMap()) {
      node->kind = Kind::kMap;
      for (const auto& entry : yaml) {
        NodePtr value = convert(entry.second, depth + 1);
        if (value->line > 0) value->line = entry.first.Mark().line + 1;  // the line of the key
        if (!entry.first.IsScalar()) {
          throw InputError(fmt::format("{}: a key must be a plain word", value->place()));
        }
        const std::string& key = entry.first.Scalar();
        if (const NodePtr first = node->member(key)) {
          throw InputError(fmt::format("{}: {}: given twice, first in line {}", value->place(), key,
                                       first->line));
        }
        node->members.emplace_back(key, std::move(value));
      }
    }
    return node;
  }

 private:
  SourcePtr source_;
  std::size_t count_ = 0;
};

NodePtr parse(const std::string& yaml, const SourcePtr& source) {
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(yaml);
  } catch (const YAML::Exception& error) {
    const std::string line =
        error.mark.is_null() || source->isOverride() ? "" : fmt::format(":{}", error.mark.line + 1);
    throw InputError(fmt::format("{}{}: not valid YAML: {}", source->name, line, error.msg));
  }
  if (documents.size() > 1) {
    throw InputError(
        fmt::format("{}: holds {} YAML documents, expected one", source->name, documents.size()));
  }
  return documents.empty() ? Converter(source).convert(YAML::Node())
                           : Converter(source).convert(documents.front());
}

/// Whether both are maps that say what they are, and say different things: then no key of one means
/// anything in the other.
bool differInType(const Node& a, const Node& b) {
  const NodePtr type_a = a.member("type");
  const NodePtr type_b = b.member("type");
  return type_a && type_b && type_a->text != type_b->text;
}

/// `over` on top of `under`. Keys keep the order of `under`, which is where a reader of the files
/// looks first.
NodePtr merged(const NodePtr& under, const NodePtr& over) {
  if (under->kind != Kind::kMap) return over;
  if (over->kind == Kind::kNull) return under;  // "noise:" with every line below commented out
  if (over->kind != Kind::kMap || differInType(*under, *over)) return over;
  auto result = std::make_shared<Node>(*over);
  result->members = under->members;
  for (const auto& [key, value] : over->members) {
    const auto place = std::find_if(result->members.begin(), result->members.end(),
                                    [&](const auto& entry) { return entry.first == key; });
    if (place == result->members.end()) {
      result->members.emplace_back(key, value);
    } else {
      place->second = merged(place->second, value);
    }
  }
  return result;
}

NodePtr load(const std::string& yaml, const std::string& name, const fs::path& folder,
             std::vector<fs::path>& chain) {
  auto source = std::make_shared<ConfigSource>();
  source->name = name;
  source->folder = folder;
  source->order = static_cast<int>(chain.size()) - 1;
  NodePtr root = parse(yaml, source);
  if (root->kind == Kind::kNull) root->kind = Kind::kMap;
  if (root->kind != Kind::kMap) {
    throw InputError(fmt::format("{}: expected keys with values (a map)", root->place()));
  }
  root->line = 0;

  const NodePtr base = root->member("base");
  if (!base) return root;
  if (base->kind != Kind::kScalar || base->text.empty()) {
    throw InputError(fmt::format("{}: base: expected a file name", base->place()));
  }
  std::erase_if(root->members, [](const auto& entry) { return entry.first == "base"; });
  const fs::path path = folder / base->text;
  std::error_code ignored;
  const fs::path canonical = fs::weakly_canonical(path, ignored);
  if (std::find(chain.begin(), chain.end(), canonical) != chain.end()) {
    throw InputError(fmt::format("{}: base: {} is based on itself", base->place(), path.string()));
  }
  chain.push_back(canonical);
  std::string base_yaml;
  try {
    base_yaml = readFile(path);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: base: {}", base->place(), error.what()));
  }
  return merged(load(base_yaml, path.string(), path.parent_path(), chain), root);
}

/// The node at `key` below `parent`, made if it is not there. The nodes on the way are copied,
/// since trees may share them.
NodePtr& child(Node& parent, const std::string& key, const std::string& assignment) {
  if (parent.kind == Kind::kList) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (error != std::errc() || end != key.data() + key.size() || index >= parent.items.size()) {
      throw InputError(fmt::format("--set {}: '{}' is not an item of a list of {}", assignment, key,
                                   parent.items.size()));
    }
    return parent.items[index];
  }
  if (parent.kind == Kind::kScalar) {
    throw InputError(fmt::format("--set {}: '{}' stands below the plain value '{}' ({})",
                                 assignment, key, parent.text, parent.place()));
  }
  parent.kind = Kind::kMap;
  for (auto& [name, node] : parent.members) {
    if (name == key) return node;
  }
  return parent.members.emplace_back(key, nullptr).second;
}

}  // namespace

ConfigDocument ConfigDocument::fromFile(const fs::path& path) {
  std::error_code ignored;
  std::vector<fs::path> chain{fs::weakly_canonical(path, ignored)};
  ConfigDocument document;
  document.root_ = load(readFile(path), path.string(), path.parent_path(), chain);
  return document;
}

ConfigDocument ConfigDocument::fromString(const std::string& yaml, const std::string& name) {
  std::vector<fs::path> chain{fs::path(name)};
  ConfigDocument document;
  document.root_ = load(yaml, name, fs::path(), chain);
  return document;
}

void ConfigDocument::set(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  if (equals == std::string::npos || key.empty() || key.front() == '.' || key.back() == '.' ||
      key.find("..") != std::string::npos) {
    throw InputError(fmt::format("--set {}: expected key=value, as in a.b=3", assignment));
  }
  auto source = std::make_shared<ConfigSource>();
  source->name = "--set " + key;
  source->folder = folder();
  source->order = ConfigSource::kFirstOverride + num_overrides_++;

  root_ = std::make_shared<Node>(*root_);
  Node* node = root_.get();
  std::size_t begin = 0;
  while (true) {
    const std::size_t dot = key.find('.', begin);
    NodePtr& next = child(*node, key.substr(begin, dot - begin), assignment);
    if (dot == std::string::npos) {
      next = parse(assignment.substr(equals + 1), source);
      return;
    }
    next = next ? std::make_shared<Node>(*next) : std::make_shared<Node>();
    if (!next->source) next->source = source;
    node = next.get();
    begin = dot + 1;
  }
}

void ConfigDocument::remove(const std::string& key) {
  root_ = std::make_shared<Node>(*root_);
  Node* node = root_.get();
  std::size_t begin = 0;
  while (true) {
    const std::size_t dot = key.find('.', begin);
    const std::string name = key.substr(begin, dot - begin);
    const auto place = std::find_if(node->members.begin(), node->members.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (place == node->members.end()) return;
    if (dot == std::string::npos) {
      node->members.erase(place);
      return;
    }
    place->second = std::make_shared<Node>(*place->second);  // trees may share it
    node = place->second.get();
    begin = dot + 1;
  }
}

const std::string& ConfigDocument::name() const { return root_->source->name; }
fs::path ConfigDocument::folder() const { return root_->source->folder; }

}  // namespace hydrabench
