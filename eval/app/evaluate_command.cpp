// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/evaluation_setup.h"
#include "eval/app/progress.h"
#include "eval/app/remarks.h"
#include "eval/evaluation/submission_check.h"
#include "eval/report/comparison_table.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

struct Options {
  std::vector<std::filesystem::path> predictions;
  std::filesystem::path dataset;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  bool replace = false;
  bool as_is = false;
};

/// Mistakes in how a prediction was written down are told before anything is scored.
void requireSound(const Prediction& prediction, const std::filesystem::path& path,
                  const Dataset& dataset, bool as_is) {
  for (const SubmissionFinding& finding :
       checkSubmission(dataset.labelSpace(), dataset.groundTruth(), prediction)) {
    if (finding.verdict == SubmissionFinding::Verdict::kPass) continue;
    const std::string line =
        fmt::format("{}: {}: {}", path.string(), finding.topic, finding.message);
    if (finding.verdict == SubmissionFinding::Verdict::kFail && !as_is) {
      throw InputError(line + " (--as-is scores it as it stands)");
    }
    fmt::print(stderr, "{}\n", line);
  }
}

/// Ids are trusted; where the names behind them differ, two numberings were mixed up.
void warnOfOtherNames(const Prediction& prediction, const LabelSpace& label_space) {
  for (const LabelSpace::Entry& entry : prediction.graph.label_space.entries) {
    const LabelSpace::Entry* ours = label_space.find(entry.label);
    if (!ours || ours->name == entry.name || entry.name.empty()) continue;
    fmt::print(stderr,
               "{}: label {} is called '{}' there and '{}' in the dataset: is it the same class?\n",
               prediction.method, entry.label, entry.name, ours->name);
  }
}

int evaluate(const Options& options) {
  AtomicFolder folder(options.out, options.replace ? kResultMarker : "");
  std::vector<Prediction> predictions;
  std::set<std::string> names;
  for (const std::filesystem::path& path : options.predictions) {
    predictions.push_back(readPrediction(path));
    if (!names.insert(predictions.back().method).second) {
      throw InputError(fmt::format(
          "{}: method name '{}' is taken by an earlier prediction; names in a table must differ",
          path.string(), predictions.back().method));
    }
  }
  const EvaluationSetup setup = openEvaluation(options.dataset, options.overrides);
  const Dataset& dataset = *setup.dataset.dataset;
  if (!dataset.hasGroundTruth()) {
    throw InputError(fmt::format("{}: this dataset has no ground truth to score against",
                                 options.dataset.string()));
  }

  for (std::size_t i = 0; i < predictions.size(); ++i) {
    requireSound(predictions[i], options.predictions[i], dataset, options.as_is);
  }

  Result result;
  result.config = setup.resolved_config;
  result.evaluation = setup.evaluation;
  result.provenance = currentProvenance(commandLine());
  const Evaluator evaluator(dataset.name(), std::to_string(dataset.seed()), dataset.labelSpace(),
                            dataset.groundTruth(), setup.evaluation);
  Progress progress("evaluate", predictions.size());
  for (const Prediction& prediction : predictions) {
    warnOfOtherNames(prediction, dataset.labelSpace());
    result.evaluations.push_back(
        evaluator.evaluate(prediction, options.as_is ? Evaluator::OtherUnits::kScoredAsIs
                                                     : Evaluator::OtherUnits::kRefused));
    for (const std::string& note : prediction.notes) {
      result.notes.push_back(methodLabel(prediction.method) + ": " + note);
    }
    progress.advance();
  }
  result.differences = pairedDifferences(result.evaluations, result.evaluation);
  for (const MethodEvaluation& method : result.evaluations) printRemarks(method);
  fmt::print("{}", renderTerminal(comparisonTable(allScores(result), kAllMicro, result.notes),
                                  isatty(STDOUT_FILENO) == 1));
  for (const std::string& remark : writeResult(folder, result)) {
    fmt::print(stderr, "{}\n", remark);
  }
  fmt::print("wrote {}\n", options.out.string());
  return kDone;
}

}  // namespace

Command addEvaluate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("predictions", options->predictions,
                 "prediction folders, or scene_graph.json files of Hydra and Khronos")
      ->required()
      ->type_name("PREDICTION...");
  app.add_option("--dataset", options->dataset, "dataset with the ground truth")
      ->required()
      ->type_name("DATASET.yaml");
  app.add_option("--out", options->out, "result folder; appears complete or not at all")
      ->required()
      ->type_name("RESULT");
  app.add_flag("--replace", options->replace, "replace the result folder if it exists");
  app.add_flag(
      "--as-is", options->as_is,
      "score a prediction that is plainly in another unit, frame or numbering all the same");
  addOverrides(app, options->overrides, "evaluation.voxel_pitch_m=0.0375");
  app.footer(
      "Example:\n"
      "  hydrabench evaluate hydra_run/ khronos_run/ --dataset configs/datasets/office.yaml --out "
      "results/mine\n"
      "A prediction in millimetres, with other axes, about another origin or with other labels is "
      "refused with one\nline that says how to mend it; hydrabench selftest --check looks for the "
      "same without scoring.\n"
      "docs/metrics.md defines every number, docs/extend.md the files of a prediction.");
  return [options] { return evaluate(*options); };
}

}  // namespace hydrabench
