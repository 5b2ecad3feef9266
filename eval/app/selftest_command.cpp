// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/evaluation_setup.h"
#include "eval/evaluation/self_test.h"
#include "eval/oracles/ground_truth_prediction.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path dataset;
  std::filesystem::path out;
  std::filesystem::path prediction;
  std::vector<std::string> overrides;
  bool replace = false;
};

int selftest(const Options& options) {
  std::optional<AtomicFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.replace ? kResultMarker : "");
  const EvaluationSetup setup = openEvaluation(options.dataset, options.overrides);
  const Dataset& dataset = *setup.dataset.dataset;
  if (!dataset.hasGroundTruth()) {
    throw InputError(
        fmt::format("{}: this dataset has no ground truth to test", options.dataset.string()));
  }
  fmt::print("selftest of {}, seed {}\n", dataset.name(), dataset.seed());
  const std::string seed = std::to_string(dataset.seed());
  SelfTestReport report =
      runSelfTest(dataset.name(), seed, dataset.labelSpace(), dataset.groundTruth(),
                  setup.evaluation, [](const SelfTestCheck& check) {
                    fmt::print("  {}  {}{}\n", check.passed ? "pass" : "FAIL", check.claim,
                               check.detail.empty() ? "" : " (" + check.detail + ")");
                  });
  const bool passed = report.passed();
  if (folder) {
    Result result;
    result.evaluations.push_back(std::move(report.ground_truth));
    result.config = setup.resolved_config;
    result.evaluation = setup.evaluation;
    result.provenance = currentProvenance(commandLine());
    for (const std::string& remark : writeResult(*folder, result)) {
      fmt::print(stderr, "{}\n", remark);
    }
    fmt::print("wrote {}\n", options.out.string());
  }
  if (!options.prediction.empty()) {
    writePrediction(options.prediction,
                    groundTruthPrediction(dataset.labelSpace(), dataset.groundTruth()));
    fmt::print("wrote {}\n", options.prediction.string());
  }
  fmt::print("selftest {}\n", passed ? "passed" : "FAILED");
  return passed ? kDone : kGateFailed;
}

}  // namespace

Command addSelftest(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("dataset", options->dataset, "dataset whose ground truth to test")
      ->required()
      ->type_name("DATASET.yaml");
  app.add_option("--out", options->out,
                 "also write the result folder of ground truth against itself")
      ->type_name("RESULT");
  app.add_flag("--replace", options->replace, "replace the result folder if it exists");
  app.add_option(
         "--prediction", options->prediction,
         "also write ground truth as a prediction folder: an example of what evaluate reads")
      ->type_name("DIR");
  addOverrides(app, options->overrides, "dataset.seed=7");
  app.footer(
      "Works on your own dataset too: what fails here would have spoilt every score on it.\n"
      "Exit code 0: all passed, 1: a check failed.");
  return [options] { return selftest(*options); };
}

}  // namespace hydrabench
