// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sidecar/sidecar_estimator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/mesh_topology.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

namespace {

constexpr const char* kUnusable = "the sidecar's answer is no shape";

template <typename Value>
SidecarMessage::Blob blobOf(const char* name, const char* dtype, std::vector<std::size_t> shape,
                            const Value* values) {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  SidecarMessage::Blob blob{name, dtype, std::move(shape), std::string(count * sizeof(Value), 0)};
  std::memcpy(blob.bytes.data(), values, blob.bytes.size());
  return blob;
}

/// Rows of three numbers; nullopt where the blob is none of that.
template <typename Value>
std::optional<std::vector<std::array<Value, 3>>> rowsOf(const SidecarMessage& message,
                                                        const char* name, const char* dtype) {
  const SidecarMessage::Blob* blob = message.find(name);
  if (blob == nullptr || blob->dtype != dtype || blob->shape.size() != 2 || blob->shape[1] != 3) {
    return std::nullopt;
  }
  std::vector<std::array<Value, 3>> rows(blob->shape[0]);
  std::memcpy(rows.data(), blob->bytes.data(), blob->bytes.size());
  return rows;
}

std::optional<Mesh> meshOf(const SidecarMessage& answer) {
  const auto vertices = rowsOf<float>(answer, "vertices", "f4");
  const auto faces = rowsOf<std::uint32_t>(answer, "faces", "u4");
  if (!vertices || !faces || faces->empty()) return std::nullopt;
  Mesh mesh;
  for (const auto& v : *vertices) {
    mesh.vertices.emplace_back(static_cast<double>(v[0]), static_cast<double>(v[1]),
                               static_cast<double>(v[2]));
    if (!mesh.vertices.back().allFinite()) return std::nullopt;
  }
  for (const auto& f : *faces) {
    if (std::max({f[0], f[1], f[2]}) >= vertices->size()) return std::nullopt;
    mesh.faces.emplace_back(static_cast<int>(f[0]), static_cast<int>(f[1]), static_cast<int>(f[2]));
  }
  return mesh;
}

std::optional<Transform> poseOf(const nlohmann::json& header) {
  const auto rotation = header.at("R").get<std::vector<double>>();
  const auto translation = header.at("t").get<std::vector<double>>();
  if (rotation.size() != 9 || translation.size() != 3) return std::nullopt;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = rotation[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i) matrix(i, 3) = translation[static_cast<std::size_t>(i)];
  return rigidFromMatrix(matrix);
}

constexpr const char* kQuestion = ".question";
constexpr const char* kAnswer = ".answer";

/// Of a question what the answer depends on.
std::string recordedForm(SidecarMessage question) {
  question.header.erase("deadline_s");
  return encode(question);
}

/// FNV-1a; questions are compared whole besides.
std::string recordName(std::string_view question) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : question) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace

SidecarMessage sidecarQuestion(const ShapeObservation& view, std::uint64_t seed,
                               double deadline_s) {
  const Camera& camera = view.camera;
  const auto width = static_cast<std::size_t>(camera.width);
  const auto height = static_cast<std::size_t>(camera.height);
  SidecarMessage question;
  question.header = {{"op", "estimate"},
                     {"camera", "opencv"},
                     {"width", width},
                     {"height", height},
                     {"K", {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1}},
                     {"label", view.label},
                     {"seed", seed},
                     {"deadline_s", deadline_s}};
  if (!view.color.empty()) {
    static_assert(sizeof(Rgb) == 3);
    question.blobs.push_back(blobOf("rgb", "u1", {height, width, 3},
                                    reinterpret_cast<const std::uint8_t*>(view.color.data())));
  }
  question.blobs.push_back(blobOf("mask", "u1", {height, width}, view.mask.data()));
  // What was not measured must not be taken for a depth of 0.
  std::vector<float> depth(view.depth.begin(), view.depth.end());
  for (float& d : depth) {
    if (!(d > 0) || !std::isfinite(d)) d = std::numeric_limits<float>::quiet_NaN();
  }
  question.blobs.push_back(blobOf("depth", "f4", {height, width}, depth.data()));
  return question;
}

ShapeOutcome sidecarOutcome(const SidecarMessage& answer, int max_faces) {
  ShapeOutcome outcome;
  try {
    if (answer.header.contains("timings_ms")) {
      for (const auto& [stage, ms] : answer.header.at("timings_ms").items()) {
        outcome.times.add("sidecar." + stage, {ms.get<double>(), 0});
      }
    }
    const std::string status = answer.header.at("status").get<std::string>();
    if (status != "ok") {
      outcome.failure =
          status == "rejected" ? "the sidecar rejected the view" : "the sidecar reported an error";
      return outcome;
    }
    std::optional<Mesh> mesh = meshOf(answer);
    const std::optional<Transform> pose = poseOf(answer.header);
    const double scale = answer.header.at("s").get<double>();
    if (!mesh || !pose || !std::isfinite(scale) || !(scale > 0)) {
      outcome.failure = kUnusable;
      return outcome;
    }
    const auto target = static_cast<std::size_t>(max_faces);
    if (mesh->faces.size() > target) {
      const double extent = bounds(*mesh).sizes().maxCoeff();
      mesh = decimated(*mesh, target, 0.05 * extent);
    }
    outcome.estimate = ShapeEstimate{*pose, scale, *std::move(mesh), 1};
  } catch (const nlohmann::json::exception&) {
    outcome.failure = kUnusable;
  }
  return outcome;
}

/// The thread that owns the program.
class SidecarEstimator::Worker {
 public:
  explicit Worker(const Config& config)
      : config_(config), process_(config.process), thread_([this] { run(); }) {}
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }

  ShapeOutcome ask(SidecarMessage question) {
    std::packaged_task<ShapeOutcome()> task(
        [this, question = std::move(question)] { return answerTo(question); });
    std::future<ShapeOutcome> answer = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      queue_.push_back(std::move(task));
    }
    changed_.notify_one();
    return answer.get();
  }

 private:
  void run() {
    while (true) {
      std::packaged_task<ShapeOutcome()> task;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return stopping_ || !queue_.empty(); });
        if (queue_.empty()) return;
        task = std::move(queue_.front());
        queue_.pop_front();
      }
      task();
    }
  }

  ShapeOutcome answerTo(const SidecarMessage& question) {
    ShapeOutcome outcome;
    if (!config_.replay.empty()) return replayed(question);
    if (failed_objects_ >= config_.max_failed_objects) {
      outcome.failure = "the sidecar was given up";
      return outcome;
    }
    for (int attempt = 0; attempt <= config_.retries; ++attempt) {
      try {
        const SidecarMessage answer = process_.call(question);
        if (!config_.record.empty()) record(question, answer);
        failed_objects_ = 0;
        return sidecarOutcome(answer, config_.max_faces);
      } catch (const SidecarFault& fault) {
        outcome.failure = name(fault.kind);
        if (!config_.process.log.empty()) {
          std::ofstream(config_.process.log, std::ios::app)
              << "hydrabench: " << outcome.failure << ": " << fault.what << '\n';
        }
        if (fault.kind == SidecarFault::Kind::kNotStarted) break;
      }
    }
    ++failed_objects_;
    return outcome;
  }

  void record(const SidecarMessage& question, const SidecarMessage& answer) const {
    const std::string asked = recordedForm(question);
    const std::filesystem::path file = config_.record / recordName(asked);
    writeFileAtomic(file.string() + kQuestion, asked);
    writeFileAtomic(file.string() + kAnswer, encode(answer));
  }

  ShapeOutcome replayed(const SidecarMessage& question) const {
    const std::string asked = recordedForm(question);
    const std::filesystem::path file = config_.replay / recordName(asked);
    ShapeOutcome outcome;
    outcome.failure = "no recorded answer";
    if (!std::filesystem::exists(file.string() + kAnswer)) return outcome;
    if (readFile(file.string() + kQuestion) != asked) return outcome;
    SidecarReader reader;
    reader.append(readFile(file.string() + kAnswer));
    try {
      if (const auto answer = reader.next()) return sidecarOutcome(*answer, config_.max_faces);
    } catch (const InputError&) {
    }
    outcome.failure = "the recorded answer is no message";
    return outcome;
  }

  Config config_;
  SidecarProcess process_;
  int failed_objects_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<ShapeOutcome()>> queue_;
  bool stopping_ = false;
  std::thread thread_;
};

SidecarEstimator::SidecarEstimator(const Config& config) : config_(config) {
  if (config.process.command.empty() && config.replay.empty()) {
    throw InputError("command: missing; expected the program to start and its arguments");
  }
  worker_ = std::make_unique<Worker>(config);
}

SidecarEstimator::~SidecarEstimator() = default;

ShapeOutcome SidecarEstimator::estimate(const ShapeObservation& best,
                                        std::span<const ShapeObservation>,
                                        std::uint64_t seed) const {
  StageTimes times;
  ShapeOutcome outcome;
  {
    const StageTimes::Scope stage(times, "sidecar");
    outcome = worker_->ask(sidecarQuestion(best, seed, config_.process.call_s));
  }
  for (const StageTimes::Stage& stage : times.stages()) {
    for (const StageTimes::Sample& sample : stage.samples) outcome.times.add(stage.name, sample);
  }
  return outcome;
}

void read(ConfigReader& reader, SidecarEstimator::Config& config) {
  reader.field("command", config.process.command);
  // As a path: what is in it counts for what the results belong to.
  std::filesystem::path script;
  reader.path("script", script);
  std::string record;
  reader.field("record", record);
  config.record = record;
  reader.path("replay", config.replay);
  if (config.process.command.empty() && config.replay.empty()) {
    reader.fault("command", "missing, expected the program to start and its arguments");
  }
  if (!script.empty()) config.process.command.push_back(script.string());
  std::vector<std::string> arguments;
  reader.field("arguments", arguments);
  config.process.command.insert(config.process.command.end(), arguments.begin(), arguments.end());
  std::string log;
  reader.field("log", log);
  config.process.log = log;
  reader.field("start_s", config.process.start_s, Bounds{0.01, 1e6});
  reader.field("call_s", config.process.call_s, Bounds{0.01, 1e6});
  reader.field("retries", config.retries, Bounds{0, 100});
  reader.field("max_failed_objects", config.max_failed_objects, Bounds{1, 1e9});
  reader.field("max_faces", config.max_faces, Bounds{4, 1e8});
}

}  // namespace hydrabench
