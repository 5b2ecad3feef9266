// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/single_view_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "core/config/plain_name.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "eval/oracles/true_instances.h"
#include "metrics/pair_scores.h"

namespace hydrabench {
namespace {

constexpr double kFailedChamfer_m = 0.15;
constexpr double kFailedIou = 0.1;

/// One object in one frame.
struct ObjectView {
  std::size_t object = 0;
  Image<std::uint8_t> mask;
  int pixels = 0;
  bool cut = false;
  double volume_m3 = 0;
};

/// The chosen view of an object so far.
struct Chosen {
  double key = -1;
  ObjectView view;
  Frame frame;
};

/// Pixels per object, and what the mask of each is.
class FrameViews {
 public:
  FrameViews(const Frame& frame, const Image<std::int32_t>& truth,
             const SingleViewStudy::Views& config)
      : frame_(frame), truth_(truth), config_(config) {}

  std::vector<ObjectView> all() const {
    std::map<std::int32_t, std::map<InstanceId, int>> seen;
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const std::int32_t object = truth_.data()[i];
      if (object == TrueInstances::kNoObject) continue;
      const InstanceId id = frame_.instances.empty() ? kNoInstance : frame_.instances.data()[i];
      ++seen[object][id];
    }
    std::vector<ObjectView> views;
    for (const auto& [object, instances] : seen) {
      std::optional<InstanceId> instance;
      if (config_.masks == "given") {
        int most = 0;
        for (const auto& [id, count] : instances) {
          if (id == kNoInstance || count <= most) continue;
          most = count;
          instance = id;
        }
        if (!instance) continue;
      }
      ObjectView view = of(object, instance);
      if (view.pixels >= config_.min_pixels) views.push_back(std::move(view));
    }
    return views;
  }

 private:
  ObjectView of(std::int32_t object, std::optional<InstanceId> instance) const {
    const Camera& camera = frame_.camera;
    ObjectView view;
    view.object = static_cast<std::size_t>(object);
    view.mask = Image<std::uint8_t>(camera.width, camera.height);
    Aabb box;
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const bool on = instance ? frame_.instances(u, v) == *instance : truth_(u, v) == object;
        if (!on) continue;
        view.mask(u, v) = 1;
        view.cut |= u == 0 || v == 0 || u == camera.width - 1 || v == camera.height - 1;
        const float depth = frame_.depth(u, v);
        if (!(depth > 0)) continue;
        const Eigen::Vector3d p = camera.backproject(u, v, depth);
        if (p.norm() > config_.max_range_m) continue;
        ++view.pixels;
        box.extend(frame_.T_world_camera * p);
      }
    }
    view.volume_m3 = box.isEmpty() ? 0 : box.volume();
    return view;
  }

  const Frame& frame_;
  const Image<std::int32_t>& truth_;
  const SingleViewStudy::Views& config_;
};

/// The view of each scored object, in the order of the objects.
std::map<std::size_t, Chosen> chooseViews(const SingleViewStudy& study, const Dataset& dataset,
                                          const TrueInstances& truth) {
  std::map<std::size_t, Chosen> chosen;
  const auto step = static_cast<std::size_t>(study.views.frame_step);
  for (std::size_t i = 0; i < dataset.numFrames(); i += step) {
    Frame frame = dataset.frame(i);
    const Image<std::int32_t> objects =
        truth.render(frame.camera, truth.cameraPose(frame.stamp_ns, frame.T_world_camera));
    for (ObjectView& view : FrameViews(frame, objects, study.views).all()) {
      if (!truth.objects()[view.object].scored) continue;
      const double key = study.views.choose == "largest_box"
                             ? view.volume_m3
                             : Random(hashSeed(study.seed, i), view.object).uniform();
      Chosen& best = chosen[view.object];
      if (key <= best.key) continue;
      best = {key, std::move(view), frame};
    }
  }
  return chosen;
}

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

void score(const ShapeEstimate& estimate, const Transform& T_world_camera, const ObjectModel& truth,
           const ObjectModel::Config& config, SingleViewRow& row) {
  Mesh mesh = estimate.mesh;
  for (Eigen::Vector3d& v : mesh.vertices) {
    v = T_world_camera * (estimate.T_camera_object * (estimate.scale * v));
  }
  const ObjectModel model(std::move(mesh), ObjectModel::Role::kEstimate, config);
  const PairScores scores = scorePair(model, truth);
  row.chamfer_l1_m = scores.chamfer_l1;
  row.v_iou = scores.v_iou_solid;
  row.b_iou = scores.b_iou;
  row.center_error_m = (model.box().center() - truth.box().center()).norm();
  row.inlier_ratio = estimate.inlier_ratio;
}

/// A chosen view, prepared once for all estimators.
struct ViewCase {
  std::size_t object = 0;
  ShapeObservation view;
  Transform T_world_camera = Transform::Identity();  ///< true
  ObjectModel truth;
  SingleViewRow row;  ///< what does not depend on the estimator
};

ViewCase makeCase(const Chosen& choice, std::size_t index, const TrueInstances& truth,
                  const LabelSpace& label_space, const ObjectModel::Config& config) {
  const GroundTruthObject& object = truth.objects()[index];
  const Frame& frame = choice.frame;
  ViewCase result{index,
                  {.stamp_ns = frame.stamp_ns,
                   .camera = frame.camera,
                   .T_world_camera = frame.T_world_camera,
                   .color = frame.color,
                   .depth = frame.depth,
                   .mask = choice.view.mask,
                   .label = object.label},
                  truth.cameraPose(frame.stamp_ns, frame.T_world_camera),
                  ObjectModel(transformed(object.T_world_object, *object.mesh),
                              ObjectModel::Role::kTruth, config),
                  {}};
  const LabelSpace::Entry* label = label_space.find(object.label);
  SingleViewRow& row = result.row;
  row.object = object.name;
  row.class_name = label ? label->name : "unknown";
  row.subtype = object.subtype;
  row.stamp_ns = frame.stamp_ns;
  row.pixels = choice.view.pixels;
  row.cut = choice.view.cut;
  row.distance_m = (result.truth.box().center() - result.T_world_camera.translation()).norm();
  row.seen_fraction = truth.visibleFraction(index, frame.camera, result.T_world_camera);
  return result;
}

SingleViewRow estimated(const ViewCase& view_case, const ShapeEstimator& estimator,
                        std::uint64_t seed, const ObjectModel::Config& config) {
  SingleViewRow row = view_case.row;
  const auto start = std::chrono::steady_clock::now();
  const ShapeOutcome outcome =
      estimator.estimate(view_case.view, {}, hashSeed(seed, view_case.object));
  row.wall_ms["total"] = millisecondsSince(start);
  for (const StageTimes::Stage& stage : outcome.times.stages()) {
    for (const StageTimes::Sample& sample : stage.samples)
      row.wall_ms[stage.name] += sample.wall_ms;
  }
  row.failure = outcome.failure;
  // The true pose: an estimate in the camera frame is not to blame for odometry.
  if (outcome.estimate) {
    score(*outcome.estimate, view_case.T_world_camera, view_case.truth, config, row);
  }
  return row;
}

/// Every case through one estimator.
std::vector<SingleViewRow> askAll(const SingleViewStudy::Estimator& item, const Dataset& dataset,
                                  const std::vector<ViewCase>& cases, const SingleViewStudy& study,
                                  const ObjectModel::Config& config) {
  std::vector<SingleViewRow> rows;
  std::string why_not;
  std::shared_ptr<const ShapeEstimator> estimator;
  try {
    estimator = item.start(dataset);
  } catch (const InputError& error) {
    why_not = error.what();
  }
  if (estimator && !cases.empty()) estimated(cases.front(), *estimator, study.seed, config);
  for (const ViewCase& view_case : cases) {
    SingleViewRow& row = rows.emplace_back(
        estimator ? estimated(view_case, *estimator, study.seed, config) : view_case.row);
    if (!estimator) row.failure = why_not;
    row.estimator = item.name;
    if (!item.trained_on.empty()) {
      row.in_domain = std::find(item.trained_on.begin(), item.trained_on.end(), row.class_name) !=
                      item.trained_on.end();
    }
  }
  return rows;
}

void requireOneStarted(const std::vector<SingleViewRow>& rows) {
  const auto asked = [](const SingleViewRow& row) { return !row.wall_ms.empty(); };
  if (rows.empty() || std::any_of(rows.begin(), rows.end(), asked)) return;
  throw InputError(rows.front().failure);
}

}  // namespace

bool SingleViewRow::failed() const {
  if (!failure.empty()) return true;
  return chamfer_l1_m.value_or(1) > kFailedChamfer_m || v_iou.value_or(0) < kFailedIou;
}

SingleViewStudy readSingleViewStudy(const std::filesystem::path& config,
                                    const std::vector<std::string>& overrides) {
  ConfigDocument document = ConfigDocument::fromFile(config);
  std::vector<std::string> for_datasets;
  for (const std::string& assignment : overrides) {
    if (assignment.starts_with("dataset.")) {
      for_datasets.push_back(assignment.substr(8));
    } else {
      document.set(assignment);
    }
  }
  ConfigReader reader(document);
  if (reader.has("methods") && !reader.has("estimators")) {
    throw InputError(fmt::format(
        "{0}: an experiment, expected a study of shape estimators; 'hydrabench run {0}' runs it",
        config.string()));
  }
  SingleViewStudy study;
  study.name = config.stem().string();
  reader.field("name", study.name);
  reader.field("seed", study.seed);
  study.datasets = readDatasetEntries(reader, for_datasets);
  reader.require("estimators");
  for (ConfigReader& item : reader.list("estimators")) {
    SingleViewStudy::Estimator estimator;
    item.require("name");
    item.field("name", estimator.name);
    if (!estimator.name.empty() && !isPlainName(estimator.name)) {
      item.fault("name", fmt::format("'{}', {}", estimator.name, kPlainNameExpected));
    }
    item.field("trained_on", estimator.trained_on);
    estimator.start = readEstimator(item);
    study.estimators.push_back(std::move(estimator));
  }
  auto views = reader.section("views");
  views.choice("choose", study.views.choose, {"largest_box", "random"});
  views.choice("masks", study.views.masks, {"true", "given"});
  views.field("frame_step", study.views.frame_step, {1, 1e6});
  views.field("min_pixels", study.views.min_pixels, {5, 1e8});
  views.field("max_range_m", study.views.max_range_m, {0.01, 1000});
  auto evaluation = reader.section("evaluation");
  read(evaluation, study.evaluation);
  reader.finish();
  study.resolved_config = reader.resolved();
  return study;
}

std::vector<SingleViewRow> runSingleViewStudy(
    const SingleViewStudy& study,
    const std::function<void(const std::string&, const std::string&)>& on_world) {
  std::vector<SingleViewRow> rows;
  const ObjectModel::Config model_config = study.evaluation.modelConfig();
  for (const ExperimentConfig::DatasetEntry& entry : study.datasets) {
    for (std::size_t world = 0; world < entry.numWorlds(); ++world) {
      const std::unique_ptr<const Dataset> opened = entry.read(world).open();
      const Dataset& dataset = *opened;
      const std::string name = entry.name.empty() ? dataset.name() : entry.name;
      const std::string world_seed = std::to_string(dataset.seed());
      on_world(name, world_seed);
      const TrueInstances truth(dataset.groundTruth());
      const std::map<std::size_t, Chosen> chosen = chooseViews(study, dataset, truth);
      std::vector<ViewCase> cases;
      for (const auto& [index, choice] : chosen) {
        cases.push_back(makeCase(choice, index, truth, dataset.labelSpace(), model_config));
        cases.back().row.dataset = name;
        cases.back().row.world_seed = world_seed;
      }
      for (const SingleViewStudy::Estimator& item : study.estimators) {
        for (SingleViewRow& row : askAll(item, dataset, cases, study, model_config)) {
          rows.push_back(std::move(row));
        }
      }
    }
  }
  requireOneStarted(rows);
  return rows;
}

}  // namespace hydrabench
