// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/method_table.h"

#include <cstdlib>

#include <fmt/format.h>

#include "baselines/hydra/hydra.h"
#include "baselines/khronos/khronos.h"
#include "baselines/template_cad/template_cad.h"
#include "core/config/config_reader.h"
#include "core/config/plain_name.h"

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
  return [config](const LabelSpace& label_space) -> std::unique_ptr<MappingSystem> {
    return std::make_unique<System>(config, label_space);
  };
}

constexpr MethodType kTypes[] = {
    {"hydra", readSystem<Hydra>},
    {"khronos", readSystem<Khronos>},
    {"template_cad", readSystem<TemplateCad>},
};

/// Needs a type of the table.
Start readType(const std::string& type, ConfigReader& reader) {
  for (const MethodType& candidate : kTypes) {
    if (type == candidate.name) return candidate.read(reader);
  }
  std::abort();
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
  return method;
}

}  // namespace hydrabench
