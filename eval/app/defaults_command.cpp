// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "eval/app/app.h"
#include "eval/app/evaluation_setup.h"
#include "eval/experiment/indented.h"
#include "eval/experiment/method_table.h"
#include "eval/simulation/simulated_dataset.h"

namespace hydrabench {
namespace {

int printDefaults() {
  ConfigReader dataset(ConfigDocument::fromString("{}", "defaults"));
  SimulatedConfig simulated;
  read(dataset, simulated);
  ConfigReader evaluation(ConfigDocument::fromString("{}", "defaults"));
  EvaluationConfig scoring;
  read(evaluation, scoring);
  fmt::print(
      "# Every key of the default office, of the evaluation and of each method, at its default.\n"
      "# Made by: hydrabench defaults > configs/default.yaml\n{}",
      combinedConfig("type: simulated\n" + dataset.resolved(), evaluation.resolved()));
  fmt::print("methods:\n");
  for (const std::string& type : methodTypes()) {
    fmt::print("  {}:\n{}", type,
               indented("type: " + type + "\nname: " + type + "\n" + methodDefaults(type), 4));
  }
  return kDone;
}

}  // namespace

Command addDefaults(CLI::App& app) {
  app.footer(
      "Keys below 'dataset' go into a dataset's YAML, those below a method into that method's;\n"
      "--set takes any of them, behind the\n"
      "prefix that the command names in its help.");
  return [] { return printDefaults(); };
}

}  // namespace hydrabench
