// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"
#include "eval/experiment/frame_times.h"
#include "eval/experiment/method_table.h"
#include "eval/experiment/timing.h"

namespace hydrabench {

/// What one method made of one dataset.
struct MethodRun {
  std::string method;
  std::optional<Prediction> prediction;  ///< nullopt: the method failed
  std::string failure;                   ///< its message; empty if it did not
  std::vector<TimingRow> timing;
  FrameTimes frame_times;
  std::string config;  ///< resolved YAML
};

struct DatasetRun {
  std::vector<MethodRun> methods;
  double frame_period_s = 0;  ///< mean time between frames; 0 for fewer than two
};

/// Frames at the start whose times are not counted.
inline constexpr std::size_t kWarmUpFrames = 10;

/// Makes or reads each frame once and hands it to every method in turn, so that their times do not
/// mix. A method that throws is left out from there on; the others go on. A frame that cannot be
/// read ends the run with the dataset's InputError, as do settings that a method refuses.
/// @param max_frames  stop after so many; 0: all
/// @param on_frame    called after each frame
DatasetRun mapDataset(const Dataset& dataset, const std::vector<MethodConfig>& methods,
                      std::size_t max_frames, const std::function<void()>& on_frame = {});

inline constexpr const char* kTimingFile = "timing.csv";

/// Writes scene_graph.json, prediction.json, candidates if there are any, timing.csv,
/// frame_times.csv and config.yaml into `folder`: a prediction as `evaluate` reads it. The run must
/// not have failed.
void fillRunFolder(const std::filesystem::path& folder, const MethodRun& run);

}  // namespace hydrabench
