// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstdio>
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
#include "eval/evaluation/submission_check.h"
#include "eval/oracles/ground_truth_prediction.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path dataset;
  std::filesystem::path out;
  std::filesystem::path prediction;
  std::vector<std::filesystem::path> check;
  std::vector<std::string> overrides;
  std::size_t shuffles = 1;
  bool replace = false;
};

/// Prints one finding per line; false if one fails.
bool checkPrediction(const std::filesystem::path& path, const Dataset& dataset) {
  fmt::print("{}\n", path.string());
  std::vector<SubmissionFinding> findings;
  try {
    const Prediction prediction = readPrediction(path);
    fmt::print("  pass  readable ({} objects)\n", prediction.graph.objects.size());
    findings = checkSubmission(dataset.labelSpace(), dataset.groundTruth(), prediction);
  } catch (const InputError& error) {
    fmt::print("  FAIL  readable ({})\n", error.what());
    return false;
  }
  bool passed = true;
  for (const SubmissionFinding& finding : findings) {
    using Verdict = SubmissionFinding::Verdict;
    passed = passed && finding.verdict != Verdict::kFail;
    fmt::print("  {}  {}{}\n",
               finding.verdict == Verdict::kPass   ? "pass"
               : finding.verdict == Verdict::kFail ? "FAIL"
                                                   : "warn",
               finding.topic, finding.message.empty() ? "" : " (" + finding.message + ")");
  }
  return passed;
}

int checkPredictions(const Options& options, const Dataset& dataset) {
  std::size_t failed = 0;
  for (const std::filesystem::path& path : options.check) {
    if (!checkPrediction(path, dataset)) ++failed;
  }
  fmt::print("check {}\n", failed == 0 ? "passed"
                                       : fmt::format("FAILED for {} of {} predictions", failed,
                                                     options.check.size()));
  return failed == 0 ? kDone : kGateFailed;
}

int selftest(const Options& options) {
  std::optional<AtomicFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, options.replace ? kResultMarker : "");
  const EvaluationSetup setup = openEvaluation(options.dataset, options.overrides);
  const Dataset& dataset = *setup.dataset.dataset;
  if (!dataset.hasGroundTruth()) {
    throw InputError(
        fmt::format("{}: this dataset has no ground truth to test", options.dataset.string()));
  }
  if (!options.check.empty()) return checkPredictions(options, dataset);
  fmt::print("selftest of {}, seed {}\n", dataset.name(), dataset.seed());
  const std::string seed = std::to_string(dataset.seed());
  SelfTestReport report =
      runSelfTest(dataset.name(), seed, dataset.labelSpace(), dataset.groundTruth(),
                  setup.evaluation, options.shuffles, [](const SelfTestCheck& check) {
                    fmt::print("  {}  {}{}\n", check.passed ? "pass" : "FAIL", check.claim,
                               check.detail.empty() ? "" : " (" + check.detail + ")");
                    std::fflush(stdout);  // a list that grows is the progress, also in a file
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
  app.add_option("--shuffles", options->shuffles,
                 "how often order and ids of objects are drawn anew; 10000 take minutes")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--check", options->check,
                 "look only for mistakes in these predictions: unit, axes, origin, labels, NaN, "
                 "duplicates, meshes inside out")
      ->excludes("--out")
      ->excludes("--prediction")
      ->excludes("--shuffles")
      ->type_name("PREDICTION");
  addOverrides(app, options->overrides, "dataset.seed=7");
  app.footer(
      "Examples:\n"
      "  hydrabench selftest my_world/dataset.yaml\n"
      "  hydrabench selftest configs/datasets/office_quick.yaml --shuffles 10000\n"
      "  hydrabench selftest my_world/dataset.yaml --check runs/mine runs/other\n"
      "Works on your own dataset too: what fails here would have spoilt every score on it.\n"
      "With --check, 'warn' is odd but scored, 'FAIL' is what evaluate refuses.\n"
      "Exit code 0: all passed, 1: a check failed.");
  return [options] { return selftest(*options); };
}

}  // namespace hydrabench
