// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "eval/app/app.h"
#include "eval/app/progress.h"
#include "eval/report/loss_plot.h"
#include "eval/training/crisp_training.h"
#include "eval/training/latent_flow_training.h"

namespace hydrabench {
namespace {

volatile std::sig_atomic_t interrupted = 0;

struct Options {
  std::filesystem::path config;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  double minutes = 0;
};

std::string numbersText(const std::map<std::string, double>& numbers) {
  std::string text;
  for (const auto& [name, value] : numbers) text += fmt::format("  {} {:.4f}", name, value);
  return text;
}

/// One line now and then: phase, step, means since the last line, time left.
class TrainingLog {
 public:
  void operator()(const std::string& phase, int step, int steps,
                  const std::map<std::string, double>& numbers) {
    const auto now = std::chrono::steady_clock::now();
    if (phase != phase_) {
      phase_ = phase;
      first_step_ = step;
      start_ = now;
      count_ = 0;
      sums_.clear();
    }
    ++count_;
    for (const auto& [name, value] : numbers) sums_[name] += value;
    constexpr double kEvery_s = 20;
    const bool due = std::chrono::duration<double>(now - printed_).count() > kEvery_s;
    if (!due && step != steps) return;
    printed_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const int done = step - first_step_;
    const std::string left =
        done > 0 ? ", " + durationText(elapsed_s / done * (steps - step)) + " left" : "";
    for (auto& [name, sum] : sums_) sum /= count_;
    fmt::print(stderr, "{} {}/{}{}{}\n", phase, step, steps, numbersText(sums_), left);
    count_ = 0;
    sums_.clear();
  }

 private:
  std::string phase_;
  int first_step_ = 0;
  int count_ = 0;
  std::map<std::string, double> sums_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point printed_;
};

using Training = std::function<TrainingState(
    const std::string& resolved, const std::filesystem::path& out, const StopRequest& stop)>;

/// What is trained is the key `model`; the rest of the file is its config.
Training readTraining(ConfigReader& reader) {
  std::string model = "crisp";
  reader.choice("model", model, {"crisp", "latent_flow"});
  if (model == "latent_flow") {
    LatentFlowTrainingConfig config;
    read(reader, config);
    return [config](const std::string& resolved, const std::filesystem::path& out,
                    const StopRequest& stop) {
      return trainLatentFlow(config, resolved, out, TrainingLog(), stop);
    };
  }
  CrispTrainingConfig config;
  read(reader, config);
  return [config](const std::string& resolved, const std::filesystem::path& out,
                  const StopRequest& stop) {
    return trainCrispModel(config, resolved, out, TrainingLog(), stop);
  };
}

int runTrain(const Options& options) {
  ConfigDocument document = ConfigDocument::fromFile(options.config);
  for (const std::string& assignment : options.overrides) document.set(assignment);
  ConfigReader reader(document);
  const Training train = readTraining(reader);
  reader.finish();

  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  const auto start = std::chrono::steady_clock::now();
  const double limit_s =
      options.minutes > 0 ? 60 * options.minutes : std::numeric_limits<double>::infinity();
  const StopRequest stop = [&] {
    const auto now = std::chrono::steady_clock::now();
    return interrupted || std::chrono::duration<double>(now - start).count() > limit_s;
  };
  const TrainingState state = train(reader.resolved(), options.out, stop);
  if (state == TrainingState::kNoNetworkYet) {
    fmt::print("stopped before there was a network; the same command goes on from here\n");
    return kDone;
  }
  const std::string no_picture = drawLosses(options.out / "loss.csv");
  if (!no_picture.empty()) fmt::print(stderr, "no plot of the losses: {}\n", no_picture);
  fmt::print("{}: wrote {}\n", state == TrainingState::kFinished ? "finished" : "stopped",
             (options.out / "model").string());
  if (state == TrainingState::kStopped) fmt::print("the same command goes on from here\n");
  return kDone;
}

}  // namespace

Command addTrain(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("config", options->config, "what to train (configs/training/*.yaml)")
      ->required()
      ->type_name("CONFIG");
  app.add_option("--out", options->out,
                 "folder for worlds, checkpoints, losses and the model; a training that was "
                 "stopped goes on in it")
      ->required()
      ->type_name("DIR");
  app.add_option("--minutes", options->minutes,
                 "stop after so long, with a checkpoint and the model as it is; 0: at the end")
      ->type_name("MIN")
      ->capture_default_str();
  addOverrides(app, options->overrides, "joint.steps=1000");
  app.footer("Ctrl-C stops after the current step; the same command goes on from there.");
  return [options] { return runTrain(*options); };
}

}  // namespace hydrabench
