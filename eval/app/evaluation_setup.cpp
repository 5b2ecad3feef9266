// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/evaluation_setup.h"

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/experiment/indented.h"

namespace hydrabench {
std::string combinedConfig(const std::string& dataset_yaml, const std::string& evaluation_yaml) {
  return "dataset:\n" + indented(dataset_yaml, 2) + "evaluation:\n" + indented(evaluation_yaml, 2);
}

EvaluationSetup openEvaluation(const std::filesystem::path& dataset_config,
                               const std::vector<std::string>& overrides) {
  ConfigDocument evaluation_document = ConfigDocument::fromString("{}", "evaluation");
  std::vector<std::string> dataset_overrides;
  for (const std::string& override_text : overrides) {
    if (override_text.starts_with("dataset.")) {
      dataset_overrides.push_back(override_text.substr(8));
    } else if (override_text.starts_with("evaluation.")) {
      evaluation_document.set(override_text.substr(11));
    } else {
      throw InputError(fmt::format(
          "--set {}: expected a key that starts with 'dataset.' or 'evaluation.'", override_text));
    }
  }
  EvaluationSetup setup;
  ConfigReader reader(evaluation_document);
  read(reader, setup.evaluation);
  reader.finish();
  setup.dataset = openDataset(dataset_config, dataset_overrides);
  setup.resolved_config = combinedConfig(setup.dataset.resolved_config, reader.resolved());
  return setup;
}

}  // namespace hydrabench
