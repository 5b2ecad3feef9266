// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_estimator.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/shape/crisp/crisp_model.h"
#include "core/shape/observation_fault.h"
#include "core/types/error.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr const char* kNotFinite = "network output is not finite";
constexpr const char* kNoPose = "points do not agree on a pose";
constexpr const char* kNoSurface = "shape has no surface";
constexpr const char* kBadSize = "size of the object is not plausible";

bool allFinite(const std::vector<Eigen::Vector3d>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Eigen::Vector3d& p) { return p.allFinite(); });
}

/// The field, with a note taken when it says something that is no number.
SdfField watched(const SdfField& field, std::atomic<bool>& not_finite) {
  return [&field, &not_finite](std::span<const Eigen::Vector3f> points, std::span<float> values) {
    field(points, values);
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) {
      not_finite.store(true, std::memory_order_relaxed);
    }
  };
}

ShapeOutcome failed(ShapeOutcome outcome, const char* failure) {
  outcome.failure = failure;
  return outcome;
}

std::shared_ptr<const CrispModel> loadModel(const CrispEstimator::Config& config) {
  if (config.model.empty()) {
    throw InputError("model: missing; expected the manifest of weights or the folder it is in");
  }
  return loadCrispModel(config.model, config.device);
}

}  // namespace

void read(ConfigReader& reader, CrispEstimator::Config& config) {
  reader.path("model", config.model);
  reader.choice("device", config.device, {"cpu", "cuda"});
  auto pose = reader.section("pose");
  read(pose, config.pose);
  auto refinement = reader.section("refinement");
  read(refinement, config.refinement);
  auto mesh = reader.section("mesh");
  read(mesh, config.mesh);
  reader.field("min_size_m", config.min_size_m, Bounds{1e-4, 1e3});
  reader.field("max_size_m", config.max_size_m, Bounds{1e-4, 1e3});
}

CrispEstimator::CrispEstimator(const Config& config) : CrispEstimator(loadModel(config), config) {}

CrispEstimator::CrispEstimator(std::shared_ptr<const CrispModel> model, const Config& config)
    : config_(config), model_(std::move(model)) {
  assert(model_);
  config_.mesh.half_side = model_->cubeHalfSide();
}

int CrispEstimator::maxOtherViews() const {
  return config_.refinement.enabled ? config_.refinement.max_other_views : 0;
}

ShapeOutcome CrispEstimator::estimate(const ShapeObservation& best,
                                      std::span<const ShapeObservation> others,
                                      std::uint64_t seed) const {
  ShapeOutcome outcome;
  if (const char* fault = faultOf(best, model_->needsColor())) {
    return failed(std::move(outcome), fault);
  }

  CrispPrediction prediction;
  {
    const StageTimes::Scope scope(outcome.times, "network");
    prediction = model_->predict(best, hashSeed(seed, 0));
  }
  if (!allFinite(prediction.nocs)) return failed(std::move(outcome), kNotFinite);

  std::optional<NocsPose> pose;
  {
    const StageTimes::Scope scope(outcome.times, "pose");
    const Eigen::Vector3d up = best.T_world_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
    pose = solveNocsPose(prediction.nocs, prediction.points, model_->freedom(), up, config_.pose,
                         hashSeed(seed, 1));
  }
  if (!pose) return failed(std::move(outcome), kNoPose);

  if (config_.refinement.enabled) {
    const StageTimes::Scope scope(outcome.times, "refinement");
    const auto views = static_cast<std::size_t>(config_.refinement.max_other_views);
    model_->refine(config_.refinement, best, others.first(std::min(views, others.size())),
                   hashSeed(seed, 2), pose->similarity, prediction);
  }

  std::optional<Mesh> mesh;
  std::atomic<bool> not_finite = false;
  {
    const StageTimes::Scope scope(outcome.times, "mesh");
    mesh = meshLevelSet(watched(prediction.field, not_finite), config_.mesh);
  }
  if (not_finite) return failed(std::move(outcome), kNotFinite);
  if (!mesh) return failed(std::move(outcome), kNoSurface);

  const double scale = pose->similarity.scale;
  const double size = scale * bounds(*mesh).sizes().maxCoeff();
  if (!(size >= config_.min_size_m && size <= config_.max_size_m)) {
    return failed(std::move(outcome), kBadSize);
  }
  outcome.estimate = {.T_camera_object = pose->similarity.T_target_source,
                      .scale = scale,
                      .mesh = std::move(*mesh),
                      .inlier_ratio = pose->inlier_ratio};
  return outcome;
}

}  // namespace hydrabench
