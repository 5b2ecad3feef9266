// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/latent_flow_estimator.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/shape/latent_flow/latent_flow_model.h"
#include "core/shape/observation_fault.h"
#include "core/types/error.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr const char* kNotFinite = "network output is not finite";
constexpr const char* kNoSurface = "shape has no surface";
constexpr const char* kBadSize = "size of the object is not plausible";

/// Measured points this near to the surface agree with the shape [units of the frame].
constexpr float kAgrees = 0.1f;

std::shared_ptr<const LatentFlowModel> loadModel(const LatentFlowEstimator::Config& config) {
  if (config.model.empty()) {
    throw InputError("model: missing; expected the manifest of weights or the folder it is in");
  }
  return loadLatentFlowModel(config.model, config.device);
}

ShapeOutcome failed(ShapeOutcome outcome, const char* failure) {
  outcome.failure = failure;
  return outcome;
}

bool isFinite(const LocalFrame& frame) {
  return frame.center.allFinite() && std::isfinite(frame.bearing) && std::isfinite(frame.scale);
}

/// Share of the object's points that lie near the surface.
double agreement(const SdfField& field, const ObjectPoints& points, const LocalFrame& frame) {
  std::vector<Eigen::Vector3f> local;
  for (const Eigen::Vector3f& p : points.object) {
    local.push_back(frame.toLocal(p.cast<double>()).cast<float>());
  }
  std::vector<float> distances(local.size());
  field(local, distances);
  const auto agree = std::count_if(distances.begin(), distances.end(),
                                   [](float d) { return std::abs(d) < kAgrees; });
  return static_cast<double>(agree) / static_cast<double>(distances.size());
}

}  // namespace

void read(ConfigReader& reader, LatentFlowEstimator::Config& config) {
  reader.path("model", config.model);
  reader.choice("device", config.device, {"cpu", "cuda"});
  reader.field("steps", config.steps, Bounds{1, 1000});
  reader.field("pose_samples", config.pose_samples, Bounds{1, 1000});
  reader.field("guidance", config.guidance, Bounds{0, 20});
  auto mesh = reader.section("mesh");
  read(mesh, config.mesh);
  reader.field("min_size_m", config.min_size_m, Bounds{1e-4, 1e3});
  reader.field("max_size_m", config.max_size_m, Bounds{1e-4, 1e3});
}

LatentFlowEstimator::LatentFlowEstimator(const Config& config)
    : LatentFlowEstimator(loadModel(config), config) {}

LatentFlowEstimator::LatentFlowEstimator(std::shared_ptr<const LatentFlowModel> model,
                                         const Config& config)
    : config_(config), model_(std::move(model)) {
  assert(model_);
  config_.mesh.half_side = kGridHalfSide;
}

ShapeOutcome LatentFlowEstimator::estimate(const ShapeObservation& best,
                                           std::span<const ShapeObservation> /*others*/,
                                           std::uint64_t seed) const {
  ShapeOutcome outcome;
  if (const char* fault = faultOf(best, false)) return failed(std::move(outcome), fault);

  ObjectPoints points;
  PointInput input;
  {
    const StageTimes::Scope scope(outcome.times, "view");
    points = gatherObjectPoints(best, {}, hashSeed(seed, 0));
    input = makePointInput(points, hashSeed(seed, 1)).value();  // has enough points
  }
  LocalFrame frame;
  {
    const StageTimes::Scope scope(outcome.times, "pose_flow");
    frame = model_->drawPose(input, config_.pose_samples, config_.steps, hashSeed(seed, 2));
  }
  if (!isFinite(frame)) return failed(std::move(outcome), kNotFinite);

  SdfField field;
  {
    const StageTimes::Scope scope(outcome.times, "shape_flow");
    field = model_->drawShape(makeViewGrid(points, frame), config_.guidance, config_.steps,
                              hashSeed(seed, 3));
  }
  std::optional<Mesh> mesh;
  std::atomic<bool> not_finite = false;
  {
    const StageTimes::Scope scope(outcome.times, "mesh");
    mesh = meshLevelSet(
        [&](std::span<const Eigen::Vector3f> places, std::span<float> values) {
          field(places, values);
          if (!std::all_of(values.begin(), values.end(),
                           [](float v) { return std::isfinite(v); })) {
            not_finite.store(true, std::memory_order_relaxed);
          }
        },
        config_.mesh);
  }
  if (not_finite) return failed(std::move(outcome), kNotFinite);
  if (!mesh) return failed(std::move(outcome), kNoSurface);
  const double size = frame.scale * bounds(*mesh).sizes().maxCoeff();
  if (!(size >= config_.min_size_m && size <= config_.max_size_m)) {
    return failed(std::move(outcome), kBadSize);
  }
  const Eigen::Matrix3d R_camera_level = best.T_world_camera.linear().transpose();
  Transform T_camera_object = Transform::Identity();
  T_camera_object.linear() =
      R_camera_level *
      Eigen::AngleAxisd(frame.bearing, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T_camera_object.translation() = R_camera_level * frame.center;
  outcome.estimate = {.T_camera_object = T_camera_object,
                      .scale = frame.scale,
                      .mesh = std::move(*mesh),
                      .inlier_ratio = agreement(field, points, frame)};
  return outcome;
}

}  // namespace hydrabench
