// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/method_table.h"

#include <cstdlib>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "baselines/hydra/hydra.h"
#include "baselines/khronos/khronos.h"
#include "baselines/template_cad/template_cad.h"
#include "core/config/config_reader.h"
#include "core/config/plain_name.h"
#include "core/pipeline/hydra_plus_plus.h"
#include "eval/experiment/estimator_table.h"
#include "eval/oracles/oracle_frames.h"
#include "eval/oracles/shape_oracle.h"
#include "eval/oracles/true_instances.h"
#include "eval/oracles/view_oracle.h"

namespace hydrabench {
namespace {

using Start = decltype(MethodConfig::start);

/// Reads the rest of the config.
struct MethodType {
  const char* name;
  Start (*read)(ConfigReader& reader);
};

template <typename System>
Start readSystem(ConfigReader& reader) {
  typename System::Config config;
  read(reader, config);
  return [config](const Dataset& dataset) -> std::unique_ptr<MappingSystem> {
    return std::make_unique<System>(config, dataset.labelSpace());
  };
}

/// Stages that are told the truth.
struct Oracles {
  OracleFrames::Mends frames;
  bool view = false;
  bool shape = false;  ///< in place of the estimator, whichever is configured
  bool any() const { return frames.masks || frames.association || view || shape; }
};

Start readHydraPlusPlus(ConfigReader& reader) {
  HydraPlusPlus::Config config;
  read(reader, config);
  auto estimator_section = reader.section("estimator");
  const EstimatorStart startEstimator = readEstimator(estimator_section);
  auto oracle_section = reader.section("oracle");
  Oracles oracles;
  oracle_section.field("masks", oracles.frames.masks);
  oracle_section.field("association", oracles.frames.association);
  oracle_section.field("view", oracles.view);
  oracle_section.field("shape", oracles.shape);
  return [=](const Dataset& dataset) -> std::unique_ptr<MappingSystem> {
    std::shared_ptr<const TrueInstances> truth;
    if (oracles.any()) truth = std::make_shared<const TrueInstances>(dataset.groundTruth());
    std::shared_ptr<const ShapeEstimator> estimator;
    if (oracles.shape) {
      estimator = std::make_shared<ShapeOracle>(truth);
    } else {
      estimator = startEstimator(dataset);
    }
    if (oracles.view) estimator = std::make_shared<ViewOracle>(std::move(estimator), truth);
    std::unique_ptr<MappingSystem> system =
        std::make_unique<HydraPlusPlus>(config, dataset.labelSpace(), std::move(estimator));
    if (!oracles.frames.masks && !oracles.frames.association) return system;
    return std::make_unique<OracleFrames>(std::move(system), truth, oracles.frames);
  };
}

constexpr MethodType kTypes[] = {
    {"hydra", readSystem<Hydra>},
    {"khronos", readSystem<Khronos>},
    {"template_cad", readSystem<TemplateCad>},
    {"hydra_plus_plus", readHydraPlusPlus},
};

/// Needs a type of the table.
Start readType(const std::string& type, ConfigReader& reader) {
  for (const MethodType& candidate : kTypes) {
    if (type == candidate.name) return candidate.read(reader);
  }
  std::abort();
}

/// The type that keeps candidates, over which it decides at the end.
constexpr const char* kDecidingType = "hydra_plus_plus";

std::string mappingConfig(const std::string& resolved, const std::string& type) {
  ConfigDocument document = ConfigDocument::fromString(resolved, type);
  document.remove("name");
  if (type == kDecidingType) {
    for (const std::string& key : decisionKeys()) document.remove(key);
  }
  ConfigReader reader(document);
  std::string ignored;
  reader.choice("type", ignored, methodTypes());
  readType(type, reader);
  return reader.resolved();
}

}  // namespace

std::vector<std::string> methodTypes() {
  std::vector<std::string> names;
  for (const MethodType& type : kTypes) names.push_back(type.name);
  return names;
}

std::string methodDefaults(const std::string& type) {
  ConfigReader reader(ConfigDocument::fromString("{}", type));
  readType(type, reader);
  return reader.resolved();
}

MethodConfig readMethod(const std::filesystem::path& config,
                        const std::vector<std::string>& overrides) {
  ConfigDocument document = ConfigDocument::fromFile(config);
  for (const std::string& assignment : overrides) document.set(assignment);
  return readMethod(document);
}

MethodConfig readMethod(const ConfigDocument& document) {
  ConfigReader reader(document);
  std::string type;
  if (!reader.has("type")) {
    reader.fault("type",
                 fmt::format("missing, expected one of: {}", fmt::join(methodTypes(), ", ")));
  }
  reader.choice("type", type, methodTypes());
  reader.throwFaults();  // without a type, no other key can be judged
  MethodConfig method;
  method.name = type;
  reader.field("name", method.name);
  if (!isPlainName(method.name)) {
    reader.fault("name", fmt::format("'{}', {}", method.name, kPlainNameExpected));
  }
  method.start = readType(type, reader);
  reader.finish();
  method.resolved_config = reader.resolved();
  method.files = reader.paths();
  if (type == kDecidingType) {
    ConfigReader decision(document);
    read(decision, method.decision.emplace());
  }
  method.mapping_config = mappingConfig(method.resolved_config, type);
  return method;
}

}  // namespace hydrabench
