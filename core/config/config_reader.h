// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hydrabench {

/// A YAML document with the place each value came from, plus overrides from the command line.
///
/// The top-level key `base: other.yaml` (relative to the file it stands in) puts another document
/// underneath: maps are merged key by key, everything else is replaced. Bases may have bases; a
/// cycle is an error.
class ConfigDocument {
 public:
  /// Throws InputError (file:line, what is wrong) for a missing or malformed file.
  static ConfigDocument fromFile(const std::filesystem::path& path);
  static ConfigDocument fromString(const std::string& yaml, const std::string& name = "<string>");

  /// Sets a.b.c=value over what the file says ("a.b.0.c" for list items); the value is YAML. Throws
  /// InputError without '='. Whether the key is known is found out by the reader, as for keys in
  /// files. A ConfigReader made before does not see it.
  void set(const std::string& assignment);
  /// Takes a.b.c out, so that its default holds; nothing happens where it is not given.
  void remove(const std::string& key);
  const std::string& name() const;
  /// Folder relative paths in the document are relative to.
  std::filesystem::path folder() const;

  struct Node;
  std::shared_ptr<Node> root() const { return root_; }

 private:
  std::shared_ptr<Node> root_;
  int num_overrides_ = 0;
};

/// Reads a document into a struct. Every key is declared once, with unit and bounds; all faults are
/// gathered and thrown by finish() in one InputError, one line each: file:line, key, value, what
/// was expected, and the nearest known key for a typo.
///
///     void read(ConfigReader& reader, Sensor::Config& config) {
///       reader.field("max_range_m", config.max_range_m, Bounds{0.0, 100.0});
///       auto noise = reader.section("noise");
///       read(noise, config.noise);
///     }
struct Bounds {
  double low = -1e300;
  double high = 1e300;  ///< both inclusive
};
class ConfigReader {
 public:
  explicit ConfigReader(const ConfigDocument& document);
  ~ConfigReader();
  ConfigReader(ConfigReader&&) noexcept;

  /// Leaves `value` as it is where the key is absent: the default stands in the struct and nowhere
  /// else.
  void field(std::string_view key, bool& value);
  void field(std::string_view key, int& value, Bounds bounds = {});
  void field(std::string_view key, std::int64_t& value, Bounds bounds = {});
  void field(std::string_view key, std::uint64_t& value);
  void field(std::string_view key, float& value, Bounds bounds = {});
  void field(std::string_view key, double& value, Bounds bounds = {});
  void field(std::string_view key, std::string& value);
  void field(std::string_view key, std::vector<double>& value, Bounds bounds = {});
  void field(std::string_view key, std::vector<int>& value, Bounds bounds = {});
  void field(std::string_view key, std::vector<std::string>& value);
  /// A relative path is taken from the folder of the document.
  void path(std::string_view key, std::filesystem::path& value);
  /// One of the listed words.
  void choice(std::string_view key, std::string& value, const std::vector<std::string>& allowed);
  /// Marks a key as needed; a fault if it is absent.
  void require(std::string_view key);
  bool has(std::string_view key) const;

  /// Reader of a nested map; an empty one where the key is absent. Shares the list of faults.
  ConfigReader section(std::string_view key);
  /// Readers of the maps in a list; empty where the key is absent.
  std::vector<ConfigReader> list(std::string_view key);

  /// Records a fault of the caller's own, e.g. two keys that contradict each other.
  void fault(std::string_view key, const std::string& message);
  /// Throws InputError with every fault of this document, unknown keys included. Call on the
  /// outermost reader.
  void finish();

  /// Throws the faults found so far without looking for unknown keys: for a fault that leaves open
  /// which keys there should be.
  void throwFaults();

  /// The document with every declared key at its resolved value, as YAML in declaration order:
  /// written beside every result.
  std::string resolved() const;

  /// Every path read so far that is not empty, as resolved; of the whole document.
  const std::vector<std::filesystem::path>& paths() const;

 private:
  struct Impl;
  explicit ConfigReader(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;
};

/// Nearest word by edit distance, if near enough to be a typo; else empty.
std::string didYouMean(std::string_view word, const std::vector<std::string>& known);

}  // namespace hydrabench
