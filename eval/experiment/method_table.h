// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/mapping_system.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// A method with its settings, ready to be started on any dataset.
struct MethodConfig {
  std::string name;             ///< as it appears in tables and files
  std::string resolved_config;  ///< YAML with every key at its value
  /// A fresh system, told the classes of a dataset and nothing else of it.
  std::function<std::unique_ptr<MappingSystem>(const LabelSpace&)> start;
};

/// Reads configs/methods/*.yaml; its `type` picks the method from one table. `overrides` are
/// key=value. Throws InputError.
MethodConfig readMethod(const std::filesystem::path& config,
                        const std::vector<std::string>& overrides = {});

/// Types of the table, in its order.
std::vector<std::string> methodTypes();
/// Every key of a type at its default, as YAML.
std::string methodDefaults(const std::string& type);

}  // namespace hydrabench
