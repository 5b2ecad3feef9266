// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sidecar/sidecar_process.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

using Kind = SidecarFault::Kind;

ChildProcess::Deadline in(double seconds) {
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
             std::chrono::duration<double>(seconds));
}

}  // namespace

const char* name(Kind kind) {
  switch (kind) {
    case Kind::kNotStarted:
      return "the sidecar did not start";
    case Kind::kLate:
      return "the sidecar did not answer in time";
    case Kind::kEnded:
      return "the sidecar ended";
    case Kind::kGarbage:
      return "the sidecar answered nonsense";
  }
  return "";
}

SidecarMessage SidecarProcess::receive(ChildProcess::Deadline deadline) {
  while (true) {
    try {
      if (auto message = reader_.next()) return *std::move(message);
    } catch (const InputError& error) {
      throw SidecarFault{Kind::kGarbage, error.what()};
    }
    std::string bytes;
    switch (process_->receive(bytes, deadline)) {
      case ChildProcess::Io::kDone:
        reader_.append(bytes);
        break;
      case ChildProcess::Io::kLate:
        throw SidecarFault{Kind::kLate, "no answer within the deadline"};
      case ChildProcess::Io::kClosed:
        // It may have closed its output and live on.
        throw SidecarFault{Kind::kEnded, process_->wait(in(1)).text()};
    }
  }
}

const nlohmann::json& SidecarProcess::hello() {
  if (process_) return hello_;
  reader_ = {};
  ++starts_;
  try {
    process_ = std::make_unique<ChildProcess>(
        ChildProcess::Config{.command = config_.command, .error_file = config_.log});
    const SidecarMessage message = receive(in(config_.start_s));
    if (message.header.value("op", "") != "hello" || message.header.value("protocol", 0) != 1) {
      throw SidecarFault{Kind::kGarbage, "began with something else than the hello of protocol 1"};
    }
    hello_ = message.header;
    return hello_;
  } catch (const OutputError& error) {
    throw SidecarFault{Kind::kNotStarted, error.what()};
  } catch (const nlohmann::json::exception& error) {
    process_.reset();
    throw SidecarFault{Kind::kNotStarted, error.what()};
  } catch (const SidecarFault& fault) {
    process_.reset();
    throw SidecarFault{Kind::kNotStarted, fault.what};
  }
}

SidecarMessage SidecarProcess::call(SidecarMessage question) {
  hello();
  try {
    const std::uint64_t id = next_id_++;
    question.header["id"] = id;
    const ChildProcess::Deadline deadline = in(config_.call_s);
    switch (process_->send(encode(question), deadline)) {
      case ChildProcess::Io::kDone:
        break;
      case ChildProcess::Io::kLate:
        throw SidecarFault{Kind::kLate, "did not take the question within the deadline"};
      case ChildProcess::Io::kClosed:
        throw SidecarFault{Kind::kEnded, "closed its input"};
    }
    SidecarMessage answer = receive(deadline);
    if (answer.header.value("id", std::uint64_t{0}) != id) {
      throw SidecarFault{Kind::kGarbage, fmt::format("answered another question than {}", id)};
    }
    return answer;
  } catch (const nlohmann::json::exception& error) {
    process_.reset();
    throw SidecarFault{Kind::kGarbage, error.what()};
  } catch (const SidecarFault&) {
    process_.reset();
    throw;
  }
}

}  // namespace hydrabench
