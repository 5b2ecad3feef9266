// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// objects.csv put together again by world: what every method made of every object, at every
/// threshold, for the page. Ids are text: JavaScript's numbers do not hold 64 bits.
struct ObjectWorld {
  struct Object {
    std::string id;
    std::string class_name;
    std::string name;  ///< the last three of ground truth only
    std::string subtype;
    std::string room;
    std::optional<double> visible_fraction;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< world [m]
    double half_diagonal_m = 0;
    std::size_t faces = 0;
  };
  struct Setting {
    std::string threshold_kind;  ///< "tau_m" or "kappa"
    double threshold = 0;
    std::string matching;
    friend bool operator==(const Setting&, const Setting&) = default;
  };
  /// A line of the file.
  struct Outcome {
    std::string kind;  ///< matched, duplicate, unmatched, missed
    std::optional<std::size_t> estimate;
    std::optional<std::size_t> truth;  ///< partner, or of an unmatched estimate the nearest
    std::optional<double> distance_m;
  };
  /// An estimate and the truth it was matched with at some setting.
  struct Pair {
    std::size_t estimate = 0;
    std::size_t truth = 0;
    std::vector<std::optional<double>> scores;  ///< as ObjectTable::score_names
  };
  struct Method {
    std::string name;
    std::vector<Object> estimates;
    std::vector<Pair> pairs;
    std::vector<std::vector<Outcome>> outcomes;  ///< by setting
  };
  std::string dataset;
  std::string seed;
  std::vector<Object> truths;
  std::vector<Method> methods;
};

struct ObjectTable {
  std::vector<std::string> score_names;
  std::vector<ObjectWorld::Setting> settings;
  std::vector<ObjectWorld> worlds;
};

/// Empty where the file does not exist. Throws InputError naming file and line.
ObjectTable readObjectTable(const std::filesystem::path& path);
std::string objectsJson(const ObjectTable& table);

/// "O12" for the node id of the objects layer with index 12, else the number.
std::string shortId(const std::string& id);

}  // namespace hydrabench
