// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/pipeline/candidate_decision.h"
#include "core/pipeline/mapping_system.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// A method with its settings, ready to be started on any dataset.
struct MethodConfig {
  std::string name;             ///< as it appears in tables and files
  std::string resolved_config;  ///< YAML with every key at its value
  /// A fresh system. Methods are told the classes of the dataset and nothing else of it; oracles
  /// (eval/oracles), which replace a stage by the truth, see its ground truth.
  std::function<std::unique_ptr<MappingSystem>(const Dataset&)> start;
  /// What mapping depends on: the config without the name, and with every key at its default that
  /// redecide() can change afterwards. Methods that share it share their mapping.
  std::string mapping_config;
  /// Of a method that keeps candidates.
  std::optional<DecisionConfig> decision;
  std::vector<std::filesystem::path> files;  ///< that it reads: weights, templates
};

/// Reads configs/methods/*.yaml; its `type` picks the method from one table. `overrides` are
/// key=value. Throws InputError.
MethodConfig readMethod(const std::filesystem::path& config,
                        const std::vector<std::string>& overrides = {});
/// The same from a document in memory, such as a resolved config.
MethodConfig readMethod(const ConfigDocument& document);

/// Types of the table, in its order.
std::vector<std::string> methodTypes();
/// Every key of a type at its default, as YAML.
std::string methodDefaults(const std::string& type);

}  // namespace hydrabench
