// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/process/child_process.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr int kNotStarted = 127;

void closeHandle(int& handle) {
  if (handle >= 0) ::close(std::exchange(handle, -1));
}

/// False where nothing happened until the deadline. An end or an error counts as happened.
bool readyBefore(ChildProcess::Deadline deadline, int handle, short events) {
  while (true) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    const auto most = std::chrono::milliseconds(1'000'000);
    pollfd waiting{handle, events, 0};
    const int timeout_ms = static_cast<int>(std::clamp(left, left.zero(), most).count());
    const int ready = ::poll(&waiting, 1, timeout_ms);
    if (ready > 0) return true;
    if (left <= left.zero()) return false;
  }
}

}  // namespace

ChildProcess::ChildProcess(const Config& config) {
  assert(!config.command.empty());
  const auto fail = [&](int error) {
    throw OutputError(
        fmt::format("{}: cannot be started: {}", config.command.front(), std::strerror(error)));
  };
  // Everything that allocates comes before fork(): other threads may hold the allocator's lock.
  std::vector<char*> arguments;
  for (const std::string& argument : config.command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  int errors = -1;
  if (!config.error_file.empty()) {
    errors = ::open(config.error_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (errors < 0) {
      throw OutputError(fmt::format("{}: cannot be written: {}", config.error_file.string(),
                                    std::strerror(errno)));
    }
  }
  // A socket for its input: writing to one that is gone is an error there, not a signal.
  int input[2];
  int output[2];
  int started[2];  // closes by itself when the program is loaded, or brings the reason why not
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0) fail(errno);
  if (::pipe2(output, O_CLOEXEC) != 0 || ::pipe2(started, O_CLOEXEC) != 0) fail(errno);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) fail(errno);
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kNotStarted);  // it ended before we could say so
    if (config.memory_limit_mib > 0) {
      const rlim_t bytes = config.memory_limit_mib << 20;
      const rlimit limit{bytes, bytes};
      ::setrlimit(RLIMIT_DATA, &limit);
    }
    ::dup2(input[1], STDIN_FILENO);
    ::dup2(output[1], STDOUT_FILENO);
    if (errors >= 0) ::dup2(errors, STDERR_FILENO);
    ::execvp(arguments.front(), arguments.data());
    const int error = errno;
    [[maybe_unused]] const ssize_t told = ::write(started[1], &error, sizeof error);
    ::_exit(kNotStarted);
  }
  ::close(input[1]);
  ::close(output[1]);
  ::close(started[1]);
  closeHandle(errors);
  input_ = input[0];
  output_ = output[0];
  int error = 0;
  const bool failed = ::read(started[0], &error, sizeof error) == sizeof error;
  ::close(started[0]);
  if (failed) {
    wait();
    closeHandle(input_);
    closeHandle(output_);
    fail(error);
  }
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  closeHandle(input_);
  closeHandle(output_);
}

bool ChildProcess::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

ChildProcess::Io ChildProcess::send(std::string_view bytes, Deadline deadline) {
  while (!bytes.empty()) {
    if (!readyBefore(deadline, input_, POLLOUT)) return Io::kLate;
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent < 0) return Io::kClosed;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return Io::kDone;
}

ChildProcess::Io ChildProcess::receive(std::string& received, Deadline deadline) {
  if (output_ >= 0 && !readyBefore(deadline, output_, POLLIN)) return Io::kLate;
  const std::optional<std::string> bytes = receive();
  if (!bytes) return Io::kClosed;
  received += *bytes;
  return Io::kDone;
}

void ChildProcess::closeInput() { closeHandle(input_); }

std::optional<std::string> ChildProcess::receive() {
  if (output_ < 0) return std::nullopt;
  std::string bytes(65536, '\0');
  ssize_t size = 0;
  do {
    size = ::read(output_, bytes.data(), bytes.size());
  } while (size < 0 && errno == EINTR);
  if (size <= 0) {
    closeHandle(output_);
    return std::nullopt;
  }
  bytes.resize(static_cast<std::size_t>(size));
  return bytes;
}

void ChildProcess::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

ChildProcess::Exit ChildProcess::wait() {
  Exit exit;
  if (pid_ <= 0) return exit;
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) continue;
  pid_ = -1;
  if (WIFSIGNALED(status)) exit.signal = WTERMSIG(status);
  if (WIFEXITED(status)) exit.code = WEXITSTATUS(status);
  return exit;
}

ChildProcess::Exit ChildProcess::wait(Deadline deadline) {
  if (pid_ > 0) {
    siginfo_t ended{};
    const auto is_over = [&] {
      return ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
             ended.si_pid != 0;
    };
    while (!is_over() && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (!is_over()) kill();
  }
  return wait();
}

std::string ChildProcess::Exit::text() const {
  if (signal != 0) return fmt::format("killed by signal {} ({})", signal, ::strsignal(signal));
  return fmt::format("exit code {}", code);
}

}  // namespace hydrabench
