// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/config/config_reader.h"
#include "core/shape/shape_estimator.h"
#include "core/shape/sidecar/sidecar_process.h"

namespace hydrabench {

/// A shape estimator in a process of its own, in any language (docs/sam3d.md): SAM3D where its user
/// has it, or anyone's. Questions wait in a queue; one is asked at a time. An answer that does not
/// come, or is no message, is asked for again, of a program started anew; where that fails, too, or
/// it does not start, the object has no shape, and after several such objects in a row the
/// estimator is given up: from there on what it says depends on more than its arguments. Stages:
/// sidecar (with the wait in the queue), and sidecar.NAME for the times that the program states.
class SidecarEstimator : public ShapeEstimator {
 public:
  struct Config {
    SidecarProcess::Config process;
    int retries = 2;               ///< of one question
    int max_failed_objects = 3;    ///< in a row, then nothing is asked any more
    int max_faces = 20000;         ///< larger meshes are simplified
    std::filesystem::path record;  ///< folder that gets every question with its answer; or empty
    std::filesystem::path replay;  ///< such a folder to answer from; then nothing is started
  };
  explicit SidecarEstimator(const Config& config);
  ~SidecarEstimator() override;

  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;

 private:
  class Worker;
  Config config_;
  std::unique_ptr<Worker> worker_;
};

/// The question about a view.
SidecarMessage sidecarQuestion(const ShapeObservation& view, std::uint64_t seed, double deadline_s);
/// The shape in an answer, or why there is none.
ShapeOutcome sidecarOutcome(const SidecarMessage& answer, int max_faces);

/// The program is started as `command`, `script` (a path relative to the document), `arguments`;
/// `log` and `record` are relative to the current folder, `replay` to the document.
void read(ConfigReader& reader, SidecarEstimator::Config& config);

}  // namespace hydrabench
