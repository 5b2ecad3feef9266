// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/shape_refinement.h"

#include <algorithm>
#include <cmath>

#include <torch/torch.h>

#include "core/shape/crisp/object_points.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr double kReach = 1.3;  // object units: free space farther from the centre is no news
constexpr double kShortOfSurface = 0.04;  // object units: how near a surface a ray counts as free

/// A measured ray, in object coordinates of the estimate that is refined.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d end;
};

struct Evidence {
  std::vector<Eigen::Vector3d> surface;
  std::vector<Ray> free;
};

/// Part of a ray that lies in the ball around the object and before its end; false for none.
bool clip(const Ray& ray, double& from, double& to) {
  const Eigen::Vector3d d = ray.end - ray.origin;
  const double length = d.norm();
  if (!(length > 1e-9)) return false;
  const double along = -ray.origin.dot(d) / length;  // to the point nearest to the centre
  const double off = (ray.origin + along / length * d).squaredNorm();
  if (off >= kReach * kReach) return false;
  const double half = std::sqrt(kReach * kReach - off);
  from = std::max(0.0, along - half) / length;
  to = std::min(length - kShortOfSurface, along + half) / length;
  return to > from;
}

void addView(const ShapeObservation& view, const ShapeObservation& best, const Similarity& start,
             std::uint64_t seed, Evidence& evidence) {
  ObjectPointsLimits limits;
  limits.context = 768;
  const ObjectPoints points = gatherObjectPoints(view, limits, seed);
  // Level frames share their axes; only the cameras stand in different places.
  const Eigen::Vector3d offset =
      view.T_world_camera.translation() - best.T_world_camera.translation();
  const Eigen::Matrix3d R_camera_level = best.T_world_camera.linear().transpose();
  const Eigen::Matrix3d R_object_camera = start.T_target_source.linear().transpose();
  const auto toObject = [&](const Eigen::Vector3d& p_level) -> Eigen::Vector3d {
    const Eigen::Vector3d p_camera = R_camera_level * (p_level + offset);
    return R_object_camera * (p_camera - start.T_target_source.translation()) / start.scale;
  };
  const Eigen::Vector3d origin = toObject(Eigen::Vector3d::Zero());
  double from = 0;
  double to = 0;
  const auto addRay = [&](const Eigen::Vector3d& end) {
    const Ray ray = {origin, end};
    if (clip(ray, from, to)) evidence.free.push_back(ray);
  };
  for (const Eigen::Vector3f& p : points.object) {
    const Eigen::Vector3d q = toObject(p.cast<double>());
    evidence.surface.push_back(q);
    addRay(q);
  }
  for (const Eigen::Vector3f& p : points.context) addRay(toObject(p.cast<double>()));
}

torch::Tensor tensorOf(const std::vector<Eigen::Vector3d>& points) {
  torch::Tensor tensor = torch::empty({1, static_cast<std::int64_t>(points.size()), 3});
  float* out = tensor.data_ptr<float>();
  for (const Eigen::Vector3d& p : points) {
    for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(p[axis]);
  }
  return tensor;
}

/// Points of a step: measured ones, and ones on the way to measured ones.
struct StepPoints {
  torch::Tensor surface;
  torch::Tensor free;
};

StepPoints draw(const Evidence& evidence, const ShapeRefinementConfig& config, Random random) {
  std::vector<Eigen::Vector3d> surface;
  std::vector<Eigen::Vector3d> free;
  for (int i = 0; i < config.surface_points; ++i) {
    surface.push_back(
        evidence.surface[random.index(static_cast<std::uint32_t>(evidence.surface.size()))]);
  }
  for (int i = 0; i < config.free_points && !evidence.free.empty(); ++i) {
    const Ray& ray = evidence.free[random.index(static_cast<std::uint32_t>(evidence.free.size()))];
    double from = 0;
    double to = 0;
    clip(ray, from, to);
    free.push_back(ray.origin + random.uniform(from, to) * (ray.end - ray.origin));
  }
  return {tensorOf(surface), tensorOf(free)};
}

/// What is optimised: a small turn about the object's z axis, shift and log scale in object
/// coordinates, and a change of the code.
struct Unknowns {
  torch::Tensor turn = torch::zeros({1}, torch::requires_grad());
  torch::Tensor shift = torch::zeros({3}, torch::requires_grad());
  torch::Tensor log_scale = torch::zeros({1}, torch::requires_grad());
  torch::Tensor code;

  torch::Tensor toObject(const torch::Tensor& points) const {
    const torch::Tensor d = (points - shift) * torch::exp(-log_scale);
    const torch::Tensor c = torch::cos(turn);
    const torch::Tensor s = torch::sin(turn);
    return torch::stack({c * d.select(-1, 0) + s * d.select(-1, 1),
                         c * d.select(-1, 1) - s * d.select(-1, 0), d.select(-1, 2)},
                        -1);
  }
};

torch::Tensor misfit(const LatentField& field, const Unknowns& x, const torch::Tensor& code,
                     const StepPoints& points, const ShapeRefinementConfig& config) {
  const std::int64_t measured = points.surface.size(1);
  const torch::Tensor all = torch::cat({points.surface, points.free}, 1);
  const torch::Tensor value = field(x.toObject(all), code);
  torch::Tensor loss = value.narrow(1, 0, measured).abs().clamp_max(config.max_residual).mean();
  if (points.free.size(1) > 0) {
    const torch::Tensor inside =
        torch::relu(config.free_margin - value.narrow(1, measured, points.free.size(1)));
    loss = loss + config.free_weight * inside.clamp_max(config.max_residual).mean();
  }
  return loss;
}

}  // namespace

void read(ConfigReader& reader, ShapeRefinementConfig& config) {
  reader.field("enabled", config.enabled);
  reader.field("steps", config.steps, {1, 10000});
  reader.field("surface_points", config.surface_points, {1, 100000});
  reader.field("free_points", config.free_points, {0, 100000});
  reader.field("max_other_views", config.max_other_views, {0, 1000});
  reader.field("pose_rate", config.pose_rate, {0, 1});
  reader.field("code_rate", config.code_rate, {0, 1});
  reader.field("max_residual", config.max_residual, {1e-3, 10});
  reader.field("free_weight", config.free_weight, {0, 1000});
  reader.field("free_margin", config.free_margin, {0, 1});
  reader.field("code_weight", config.code_weight, {0, 1000});
  reader.field("pose_weight", config.pose_weight, {0, 1000});
  reader.field("max_shift", config.max_shift, {0, 10});
}

RefinedShape refineShape(const LatentField& field, const RefinedShape& start, double code_spread,
                         const ShapeObservation& best, std::span<const ShapeObservation> others,
                         const ShapeRefinementConfig& config, std::uint64_t seed) {
  keepTorchOnThisThread();
  const Random random(seed);
  Evidence evidence;
  addView(best, best, start.camera_from_object, random.fork(0).bits(), evidence);
  for (std::size_t i = 0; i < others.size(); ++i) {
    addView(others[i], best, start.camera_from_object, random.fork(i + 1).bits(), evidence);
  }
  if (evidence.surface.empty()) return start;

  const auto size = static_cast<std::int64_t>(start.code.size());
  torch::Tensor initial = torch::empty({1, size});
  std::copy(start.code.begin(), start.code.end(), initial.data_ptr<float>());
  Unknowns x;
  x.code = torch::zeros({1, size}, torch::requires_grad());  // in units of code_spread
  const auto codeOf = [&] { return initial + code_spread * x.code; };

  std::vector<torch::optim::OptimizerParamGroup> groups;
  groups.emplace_back(std::vector<torch::Tensor>{x.turn, x.shift, x.log_scale},
                      std::make_unique<torch::optim::AdamOptions>(config.pose_rate));
  groups.emplace_back(std::vector<torch::Tensor>{x.code},
                      std::make_unique<torch::optim::AdamOptions>(config.code_rate));
  torch::optim::Adam optimizer(groups, torch::optim::AdamOptions(config.pose_rate));

  ShapeRefinementConfig judged = config;  // before and after are compared on more points
  judged.surface_points *= 4;
  judged.free_points *= 4;
  const StepPoints judge = draw(evidence, judged, random.fork(1u << 20));
  const auto judgement = [&] {
    const torch::NoGradGuard no_grad;
    return misfit(field, x, codeOf(), judge, config).item<double>();
  };
  const double before = judgement();
  for (int step = 0; step < config.steps; ++step) {
    const StepPoints points =
        draw(evidence, config, random.fork((1u << 21) + static_cast<std::uint64_t>(step)));
    optimizer.zero_grad();
    const torch::Tensor pull =
        config.pose_weight *
            (x.turn.square().sum() + x.shift.square().sum() + x.log_scale.square().sum()) +
        config.code_weight * x.code.square().mean();
    (misfit(field, x, codeOf(), points, config) + pull).backward();
    optimizer.step();
    const torch::NoGradGuard no_grad;
    for (torch::Tensor* value : {&x.turn, &x.shift, &x.log_scale}) {
      value->clamp_(-config.max_shift, config.max_shift);
    }
  }
  const double after = judgement();
  if (!(after < before)) return start;  // false for NaN

  const torch::NoGradGuard no_grad;
  RefinedShape result;
  const Similarity& s0 = start.camera_from_object;
  const Eigen::Matrix3d R0 = s0.T_target_source.linear();
  const Eigen::Vector3d shift(x.shift[0].item<double>(), x.shift[1].item<double>(),
                              x.shift[2].item<double>());
  const Eigen::AngleAxisd turn(x.turn.item<double>(), Eigen::Vector3d::UnitZ());
  result.camera_from_object.scale = s0.scale * std::exp(x.log_scale.item<double>());
  result.camera_from_object.T_target_source.linear() = R0 * turn.toRotationMatrix();
  result.camera_from_object.T_target_source.translation() =
      s0.T_target_source.translation() + s0.scale * (R0 * shift);
  const torch::Tensor code = codeOf().contiguous();
  result.code.assign(code.data_ptr<float>(), code.data_ptr<float>() + size);
  const bool finite =
      result.camera_from_object.T_target_source.matrix().allFinite() &&
      std::isfinite(result.camera_from_object.scale) &&
      std::all_of(result.code.begin(), result.code.end(), [](float v) { return std::isfinite(v); });
  return finite ? result : start;
}

}  // namespace hydrabench
