// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/estimator_table.h"

#include "baselines/template_cad/template_estimator.h"
#include "core/shape/crisp/crisp_estimator.h"
#include "core/shape/latent_flow/latent_flow_estimator.h"
#include "core/shape/scale_alignment.h"
#include "core/shape/sidecar/sidecar_estimator.h"
#include "eval/oracles/shape_oracle.h"
#include "eval/oracles/true_instances.h"

namespace hydrabench {
namespace {

/// Reads the rest of the section.
struct EstimatorType {
  const char* name;
  EstimatorStart (*read)(ConfigReader& reader);
};

EstimatorStart readCrisp(ConfigReader& reader) {
  CrispEstimator::Config config;
  read(reader, config);
  return [config](const Dataset&) { return std::make_shared<CrispEstimator>(config); };
}

EstimatorStart readLatentFlow(ConfigReader& reader) {
  LatentFlowEstimator::Config config;
  read(reader, config);
  return [config](const Dataset&) { return std::make_shared<LatentFlowEstimator>(config); };
}

EstimatorStart readSidecar(ConfigReader& reader) {
  SidecarEstimator::Config config;
  read(reader, config);
  return [config](const Dataset&) { return std::make_shared<SidecarEstimator>(config); };
}

EstimatorStart readTemplate(ConfigReader& reader) {
  TemplateEstimator::Config config;
  read(reader, config);
  return [config](const Dataset& dataset) {
    return std::make_shared<TemplateEstimator>(config, dataset.labelSpace());
  };
}

EstimatorStart readOracle(ConfigReader&) {
  return [](const Dataset& dataset) {
    return std::make_shared<ShapeOracle>(
        std::make_shared<const TrueInstances>(dataset.groundTruth()));
  };
}

constexpr EstimatorType kTypes[] = {
    {"crisp", readCrisp},       {"latent_flow", readLatentFlow}, {"sidecar", readSidecar},
    {"template", readTemplate}, {"oracle", readOracle},
};

}  // namespace

std::vector<std::string> estimatorTypes() {
  std::vector<std::string> names;
  for (const EstimatorType& type : kTypes) names.emplace_back(type.name);
  return names;
}

EstimatorStart readEstimator(ConfigReader& section) {
  std::string type = kTypes[0].name;
  section.choice("type", type, estimatorTypes());
  ScaleAlignmentConfig alignment;
  auto align_scale = section.section("align_scale");
  read(align_scale, alignment);
  for (const EstimatorType& candidate : kTypes) {
    if (type != candidate.name) continue;
    const EstimatorStart start = candidate.read(section);
    if (!alignment.enabled) return start;
    return [start, alignment](const Dataset& dataset) {
      return std::make_shared<ScaleAligned>(start(dataset), alignment);
    };
  }
  section.throwFaults();  // an unknown type: no other key can be judged
  return {};
}

}  // namespace hydrabench
