// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/map_dataset.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <memory>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"

namespace hydrabench {
namespace {

/// A method at work.
struct Worker {
  std::unique_ptr<MappingSystem> system;
  StageCounts warm_up;
};

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
    attempt(runs[m], [&] { workers[m].system = methods[m].start(dataset.labelSpace()); });
  }
  const std::size_t count =
      max_frames == 0 ? dataset.numFrames() : std::min(max_frames, dataset.numFrames());
  std::int64_t first_stamp_ns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const RgbdFrame frame = dataset.frame(i);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      attempt(runs[m], [&] {
        workers[m].system->process(frame);
        if (i + 1 == kWarmUpFrames) {
          workers[m].warm_up = stageCounts(workers[m].system->stageTimes());
        }
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
      MappingSystem& system = *workers[m].system;
      Prediction prediction{system.finish(), methods[m].name, system.notes()};
      if (prediction.graph.label_space.entries.empty()) {
        prediction.graph.label_space = dataset.labelSpace();
      }
      runs[m].prediction = std::move(prediction);
      runs[m].timing = timingRows(dataset.name(), std::to_string(dataset.seed()), methods[m].name,
                                  system.stageTimes(), workers[m].warm_up);
    });
    workers[m].system.reset();  // its memory, before the next one finishes
  }
  return result;
}

void fillRunFolder(const std::filesystem::path& folder, const MethodRun& run) {
  assert(run.prediction);
  fillPredictionFolder(folder, *run.prediction);
  writeFileAtomic(folder / "timing.csv", timingCsv(run.timing));
  writeFileAtomic(folder / "config.yaml", run.config);
}

}  // namespace hydrabench
