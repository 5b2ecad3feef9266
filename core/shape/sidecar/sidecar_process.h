// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/process/child_process.h"
#include "core/shape/sidecar/sidecar_message.h"

namespace hydrabench {

/// What went wrong with the program beside us.
struct SidecarFault {
  enum class Kind {
    kNotStarted,  ///< no such program, or no hello in time
    kLate,        ///< no answer in time
    kEnded,       ///< it is gone
    kGarbage      ///< what it said is no message, or not the one expected
  };
  Kind kind = Kind::kEnded;
  std::string what;  ///< one line
};
/// A few words, the same for all faults of a kind.
const char* name(SidecarFault::Kind kind);

/// The program beside us: started when first asked, killed after any fault and started again for
/// the next question. One question at a time. Not thread-safe; all calls from one thread, because
/// the program ends with the thread that started it.
class SidecarProcess {
 public:
  struct Config {
    std::vector<std::string> command;  ///< program and arguments
    std::filesystem::path log;         ///< its standard error, appended; empty: ours
    double start_s = 300;              ///< until its hello: it loads its weights first
    double call_s = 60;                ///< until its answer
  };
  explicit SidecarProcess(const Config& config) : config_(config) {}

  /// Starts it unless it runs, and waits for its hello: who it is. Throws SidecarFault.
  const nlohmann::json& hello();
  /// Sends a question, to which a number "id" is added, and waits for the answer with the same.
  /// Throws SidecarFault.
  SidecarMessage call(SidecarMessage question);
  int starts() const { return starts_; }

 private:
  SidecarMessage receive(ChildProcess::Deadline deadline);

  Config config_;
  std::unique_ptr<ChildProcess> process_;
  SidecarReader reader_;
  nlohmann::json hello_;
  std::uint64_t next_id_ = 1;
  int starts_ = 0;
};

}  // namespace hydrabench
