// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/map_dataset.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <memory>
#include <optional>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/experiment/instruction_counter.h"
#include "eval/experiment/yardstick.h"

namespace hydrabench {
namespace {

/// A method at work.
struct Worker {
  std::unique_ptr<MappingSystem> system;
  StageTimes whole;  ///< process() as "frame", finish() as "finish"
  StageCounts warm_up;
  std::vector<double> instructions;  ///< of process() [10^6], where they are counted

  StageTimes times() const {
    StageTimes all = whole;
    for (const StageTimes::Stage& stage : system->stageTimes().stages()) {
      for (const StageTimes::Sample& sample : stage.samples) all.add(stage.name, sample);
    }
    return all;
  }

  /// From the end of the warm-up.
  /// @param yardstick_ms  of every frame
  void fill(const std::vector<double>& yardstick_ms, FrameTimes& times) const {
    if (!instructions.empty()) {
      const std::size_t first = instructions.size() > kWarmUpFrames ? kWarmUpFrames : 0;
      times.instructions.assign(instructions.begin() + static_cast<std::ptrdiff_t>(first),
                                instructions.end());
      return;
    }
    for (const StageTimes::Stage& stage : whole.stages()) {
      if (stage.name != "frame") continue;
      const std::size_t first = stage.samples.size() > kWarmUpFrames ? kWarmUpFrames : 0;
      for (std::size_t i = first; i < stage.samples.size(); ++i) {
        times.wall_ms.push_back(stage.samples[i].wall_ms);
        times.yardstick_ms.push_back(yardstick_ms[i]);
      }
    }
  }
};

void process(const Frame& frame, std::optional<InstructionCounter>& counter, Worker& worker) {
  const StageTimes::Scope scope(worker.whole, "frame");
  if (counter) counter->start();
  worker.system->process(frame);
  if (counter) worker.instructions.push_back(static_cast<double>(counter->stop()) * 1e-6);
}

/// Runs a step of a method; on an exception the method is out.
void attempt(MethodRun& run, const std::function<void()>& step) {
  if (!run.failure.empty()) return;
  try {
    step();
  } catch (const std::exception& error) {
    run.failure = *error.what() ? error.what() : "unknown error";
  }
}

}  // namespace

DatasetRun mapDataset(const Dataset& dataset, const std::vector<MethodConfig>& methods,
                      std::size_t max_frames, const std::function<void()>& on_frame) {
  DatasetRun result;
  std::vector<MethodRun>& runs = result.methods;
  runs.resize(methods.size());
  std::vector<Worker> workers(methods.size());
  for (std::size_t m = 0; m < methods.size(); ++m) {
    runs[m].method = methods[m].name;
    runs[m].config = methods[m].resolved_config;
    try {
      workers[m].system = methods[m].start(dataset);
    } catch (const InputError&) {
      throw;  // wrong settings are the user's to mend before anything is mapped
    } catch (const std::exception& error) {
      runs[m].failure = error.what();
    }
  }
  const std::size_t count =
      max_frames == 0 ? dataset.numFrames() : std::min(max_frames, dataset.numFrames());
  std::int64_t first_stamp_ns = 0;
  std::optional<InstructionCounter> counter;
  if (InstructionCounter::isAvailable()) counter.emplace();
  Yardstick yardstick;
  std::vector<double> yardstick_ms;
  const auto failed = [](const MethodRun& run) { return !run.failure.empty(); };
  for (std::size_t i = 0; i < count && !std::all_of(runs.begin(), runs.end(), failed); ++i) {
    const Frame frame = dataset.frame(i);
    yardstick_ms.push_back(yardstick.measure());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      attempt(runs[m], [&] {
        Worker& worker = workers[m];
        process(frame, counter, worker);
        if (i + 1 == kWarmUpFrames) worker.warm_up = stageCounts(worker.times());
      });
    }
    if (i == 0) {
      first_stamp_ns = frame.stamp_ns;
    } else {
      result.frame_period_s =
          static_cast<double>(frame.stamp_ns - first_stamp_ns) * 1e-9 / static_cast<double>(i);
    }
    if (on_frame) on_frame();
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    attempt(runs[m], [&] {
      Worker& worker = workers[m];
      Prediction prediction;
      prediction.method = methods[m].name;
      {
        const StageTimes::Scope scope(worker.whole, "finish");
        prediction.graph = worker.system->finish();
      }
      prediction.notes = worker.system->notes();
      prediction.candidates = worker.system->takeCandidates();
      if (prediction.graph.label_space.entries.empty()) {
        prediction.graph.label_space = dataset.labelSpace();
      }
      runs[m].prediction = std::move(prediction);
      const std::string seed = std::to_string(dataset.seed());
      runs[m].timing =
          timingRows(dataset.name(), seed, methods[m].name, worker.times(), worker.warm_up);
      runs[m].frame_times = {dataset.name(), seed, methods[m].name, {}, {}, {}};
      worker.fill(yardstick_ms, runs[m].frame_times);
    });
    workers[m].system.reset();  // its memory, before the next one finishes
  }
  return result;
}

void fillRunFolder(const std::filesystem::path& folder, const MethodRun& run) {
  assert(run.prediction);
  fillPredictionFolder(folder, *run.prediction);
  writeFileAtomic(folder / kTimingFile, timingCsv(run.timing));
  writeFileAtomic(folder / kFrameTimesFile, frameTimesCsv({run.frame_times}));
  writeFileAtomic(folder / "config.yaml", run.config);
}

}  // namespace hydrabench
