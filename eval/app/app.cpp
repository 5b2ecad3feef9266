// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/app.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

struct CommandEntry {
  const char* name;
  const char* help;
  Command (*add)(CLI::App&);
  bool reads_data = false;  ///< opens datasets
};

// The order is that of a first session: check, look, export, score, print.
constexpr CommandEntry kCommands[] = {
    {"doctor", "say what this build can do here and what is missing", addDoctor, true},
    {"selftest",
     "score ground truth against itself and known damage; check predictions for mistakes",
     addSelftest, true},
    {"view", "render a dataset, a prediction or the shape families to PNG", addView, true},
    {"export", "write a dataset as a plain folder of images, poses and ground-truth meshes",
     addExport, true},
    {"run", "map datasets with methods, score them and print the table: a whole experiment", addRun,
     true},
    {"map", "map one dataset with one method", addMap, true},
    {"evaluate", "score predictions against the ground truth of a dataset", addEvaluate, true},
    {"report", "print or convert the table of a result folder", addReport},
    {"compare", "say whether a result is as good as an earlier one; a gate for CI", addCompare},
    {"claims", "say which claims of a paper hold in results, fail, or are undecided", addClaims},
    {"audit", "find the whole numbers behind a published table and what they contradict", addAudit},
    {"sweep", "run an experiment over a range of settings: one table, one plot", addSweep, true},
    {"status", "say what of an experiment or sweep is done, running, failed, missing", addStatus,
     true},
    {"work", "do single units of an experiment; what run and sweep call", addWork, true},
    {"templates", "write the CAD templates of the method template_cad as PLY files", addTemplates},
    {"estimate", "estimate shapes from single views and score them: a shape estimator by itself",
     addEstimate, true},
    {"stream", "replay a run with shapes that take their time: F1 over time, deadlines, queue",
     addStream, true},
    {"train", "train the weights of a shape estimator on worlds of the generator", addTrain},
    {"defaults", "print every config key at its default", addDefaults},
    {"version", "print version, commit and build flags", addVersion},
};

constexpr const char* kDescription =
    "hydrabench: evaluation and benchmarking of object-level 3D scene-graph mapping.\n"
    "Datasets, methods and experiments are YAML files (configs/), a prediction is a folder with\n"
    "scene_graph.json, a result a folder with scores.csv and tables.";

constexpr const char* kFooter =
    "First steps:\n"
    "  hydrabench run configs/experiments/table1_quick.yaml --out results/quick\n"
    "  hydrabench view configs/datasets/office.yaml --out results/view\n"
    "  hydrabench evaluate my_run/ --dataset configs/datasets/office.yaml --out results/my_run\n"
    "Exit codes: 0 done, 1 a gate failed, 2 bad input or usage, 3 inconclusive, 4 partly failed.";

std::string g_command_line;

/// The words a mistyped argument could have been.
std::vector<std::string> knownWords(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* subcommand : app.get_subcommands({}))
    words.push_back(subcommand->get_name());
  const auto parsed = app.get_subcommands();
  for (const CLI::Option* option : (parsed.empty() ? &app : parsed.front())->get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return words;
}

int usageError(const CLI::App& app, const CLI::ParseError& error,
               const std::vector<std::string>& arguments) {
  std::string message = error.what();
  const std::vector<std::string> words = knownWords(app);
  for (const std::string& argument : arguments) {
    if (message.find(argument) == std::string::npos) continue;
    const std::string guess = didYouMean(argument.substr(0, argument.find('=')), words);
    if (!guess.empty() && guess != argument) {
      message += fmt::format("; did you mean '{}'?", guess);
      break;
    }
  }
  const auto parsed = app.get_subcommands();
  const std::string scope = parsed.empty() ? "" : " " + parsed.front()->get_name();
  fmt::print(stderr, "hydrabench: {}\nTry 'hydrabench{} --help'.\n", message, scope);
  return kBadInput;
}

}  // namespace

void addOverrides(CLI::App& app, std::vector<std::string>& overrides, const std::string& example) {
  app.add_option("--set", overrides,
                 "override a config key, e.g. --set " + example + "; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

const std::string& commandLine() { return g_command_line; }

int runApp(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  g_command_line = "hydrabench";
  for (const std::string& argument : arguments) g_command_line += " " + argument;

  CLI::App app{kDescription, "hydrabench"};
  app.footer(kFooter);
  app.require_subcommand(1);
  bool show_version = false;
  app.add_flag("--version", show_version, "same as the command version");
  int threads = 0;
  std::string data;

  std::map<const CLI::App*, Command> commands;
  for (const CommandEntry& entry : kCommands) {
    CLI::App* subcommand = app.add_subcommand(entry.name, entry.help);
    commands[subcommand] = entry.add(*subcommand);
    subcommand
        ->add_option("--threads", threads,
                     "threads to use; 0: all cores. Results do not depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    if (entry.reads_data) {
      subcommand
          ->add_option("--data", data,
                       "folder of data sets that are not part of the project (docs/datasets.md)")
          ->type_name("DIR");
    }
  }
  if (arguments.empty()) {
    fmt::print("{}", app.help());
    return kBadInput;
  }
  if (arguments.front() == "--version") arguments.front() = "version";

  // CLI11 would only say that a subcommand is missing.
  const std::string& first = arguments.front();
  const std::vector<std::string> words = knownWords(app);
  if (!first.starts_with("-") && std::find(words.begin(), words.end(), first) == words.end()) {
    const std::string guess = didYouMean(first, words);
    fmt::print(stderr, "hydrabench: unknown command '{}'{}\nTry 'hydrabench --help'.\n", first,
               guess.empty() ? "" : fmt::format("; did you mean '{}'?", guess));
    return kBadInput;
  }

  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    app.parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    const auto parsed = app.get_subcommands();
    fmt::print("{}", parsed.empty() ? app.help() : parsed.front()->help(app.get_name()));
    return kDone;
  } catch (const CLI::ParseError& error) {
    return usageError(app, error, arguments);
  }

  try {
    setNumThreads(threads);
    if (!data.empty()) setenv("HYDRABENCH_DATA", data.c_str(), 1);
    return commands.at(app.get_subcommands().front())();
  } catch (const InputError& error) {
    fmt::print(stderr, "hydrabench: {}\n", error.what());
  } catch (const OutputError& error) {
    fmt::print(stderr, "hydrabench: {}\n", error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "hydrabench: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "hydrabench: {}\n", error.what());
  }
  return kBadInput;
}

}  // namespace hydrabench
