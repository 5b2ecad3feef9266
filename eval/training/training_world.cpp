// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_world.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>

#include "core/geometry/surface_sampling.h"
#include "eval/simulation/clearance_map.h"
#include "eval/simulation/depth_noise.h"
#include "eval/simulation/mask_corruption.h"
#include "eval/simulation/office_world.h"
#include "eval/simulation/rgbd_renderer.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kOfficeStream = 1;
constexpr std::uint64_t kFrameStream = 2;
constexpr std::uint64_t kShapeStream = 3;
constexpr double kCube = 1.15;  // object coordinates: where distances are sampled

double radians(double degrees) { return degrees * kPi / 180; }

/// Scored objects of a scene as training shapes.
struct Shapes {
  std::vector<TrainingShape> shapes;
  std::map<std::int32_t, std::uint32_t> of_object;  ///< index into Scene::objects -> into shapes
  std::vector<Eigen::Vector3d> centers;             ///< of each shape's box, world [m]
  std::vector<double> yaws;                         ///< world [rad]
};

Eigen::Vector3d inCube(Random& random) {
  return {random.uniform(-kCube, kCube), random.uniform(-kCube, kCube),
          random.uniform(-kCube, kCube)};
}

TrainingShape shapeOf(const SceneObject& object, const Aabb& box, int count, Random random) {
  TrainingShape shape;
  shape.family = object.subtype;
  shape.class_name = shapeFamily(object.subtype).class_name;
  shape.yaw_symmetry = shape.class_name == "plant" ? 0 : object.shape->yaw_symmetry;
  const Eigen::Vector3d center = box.center();
  double half = 0.5 * box.sizes().maxCoeff();
  if (shape.yaw_symmetry == 0) {
    half = 0.5 * box.sizes().z();
    for (const Eigen::Vector3d& p : object.surface->mesh.vertices) {
      half = std::max(half, (p - center).head<2>().norm());
    }
  }
  shape.half_extent_m = static_cast<float>(half);
  const auto n = static_cast<std::size_t>(count);
  const std::size_t near = n / 2;
  const SurfaceSamples surface = sampleSurface(object.surface->mesh, near, random.bits());
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector3d p;
    if (i < near) {
      const double sigma = i % 2 ? 0.015 : 0.06;
      p = (surface.points[i] - center) / half;
      p += sigma * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    } else if (i % 4 == 0) {
      p = inCube(random);
    } else {  // within the box, a little beyond its sides
      p = inCube(random).cwiseProduct(0.5 / half * box.sizes());
    }
    p = p.cwiseMax(-1.6).cwiseMin(1.6);
    shape.points.push_back(p.cast<float>());
    shape.distances.push_back(static_cast<float>(
        std::clamp(object.shape->sdf->value(center + half * p) / half, -0.5, 0.5)));
  }
  return shape;
}

Shapes collectShapes(const Scene& scene, int sdf_points, Random random) {
  Shapes result;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (!object.scored || !object.shape) continue;
    const Aabb box = bounds(object.surface->mesh);
    result.of_object[static_cast<std::int32_t>(i)] =
        static_cast<std::uint32_t>(result.shapes.size());
    result.shapes.push_back(shapeOf(object, box, sdf_points, random.fork(i)));
    result.centers.push_back(object.T_world_object * box.center());
    const Eigen::Matrix3d R = object.T_world_object.linear();
    result.yaws.push_back(std::atan2(R(1, 0), R(0, 0)));
  }
  return result;
}

Camera drawCamera(int width, Random& random) {
  Camera camera;
  camera.width = width;
  camera.height = width * 2 / 3;
  camera.fx = camera.fy = width * random.uniform(0.5, 0.9);
  camera.cx = 0.5 * camera.width;
  camera.cy = 0.5 * camera.height;
  return camera;
}

/// A camera in free space that looks towards some object, not always well.
std::optional<Transform> drawPose(const ClearanceMap& clearance,
                                  const std::vector<Eigen::Vector3d>& targets, Random& random) {
  for (int attempt = 0; attempt < 40; ++attempt) {
    const Eigen::Vector3d& target =
        targets[random.index(static_cast<std::uint32_t>(targets.size()))];
    const double distance = random.uniform(0.7, 4.2);
    const double angle = random.uniform(-kPi, kPi);
    const Eigen::Vector2d place =
        target.head<2>() + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    if (clearance.at(place) < 0.2) continue;
    const double height =
        random.chance(0.7) ? random.uniform(0.65, 0.95) : random.uniform(0.35, 1.6);
    const double yaw = angle + kPi + radians(14) * random.normal();
    const double to_target = std::atan2(height - target.z(), distance);
    const double pitch = random.chance(0.6) ? radians(8 + 3 * random.normal())
                                            : to_target + radians(6) * random.normal();
    return cameraPose(place, height, yaw, std::clamp(pitch, radians(-15), radians(50)));
  }
  return std::nullopt;
}

/// The built-in camera's errors at half its resolution, more or less of them.
DepthNoiseConfig drawNoise(Random& random) {
  DepthNoiseConfig noise;
  noise.lateral_px *= 0.5;
  noise.correlation_px *= 0.5;
  noise.disparity_step_px *= 0.5;
  noise.axial_quadratic *= random.uniform(0.4, 2.5);
  noise.edge_dropout = random.uniform(0, 0.8);
  noise.grazing_start_deg = random.uniform(68, 86);
  return noise;
}

MaskCorruptionConfig drawCorruption(Random& random) {
  MaskCorruptionConfig masks;
  masks.boundary_jitter_px = random.uniform(0.2, 1.5);
  masks.boundary_correlation_px *= 0.5;
  masks.split_probability = 0.06;
  masks.miss_probability = 0;
  masks.min_pixels = 10;
  return masks;
}

/// Instance that holds most of an object, if most of that instance is the object.
InstanceId instanceOf(std::int32_t object, const Image<std::int32_t>& objects,
                      const Image<InstanceId>& instances) {
  std::map<InstanceId, std::size_t> shared;
  std::map<InstanceId, std::size_t> size;
  for (int v = 0; v < objects.height(); ++v) {
    for (int u = 0; u < objects.width(); ++u) {
      const InstanceId id = instances(u, v);
      if (id == kNoInstance) continue;
      ++size[id];
      if (objects(u, v) == object) ++shared[id];
    }
  }
  InstanceId best = kNoInstance;
  for (const auto& [id, count] : shared) {
    if (best == kNoInstance || count > shared[best]) best = id;
  }
  return best != kNoInstance && 2 * shared[best] > size[best] ? best : kNoInstance;
}

/// Collects the views that one frame gives.
class ViewCollector {
 public:
  ViewCollector(const TrainingWorldConfig& config, const Scene& scene, const Shapes& shapes,
                TrainingWorld& world)
      : config_(config), shapes_(shapes), world_(world), counts_(shapes.shapes.size(), 0) {
    for (const SceneObject& object : scene.objects) object_labels_.push_back(object.label);
  }

  void add(const RenderedView& view, ShapeObservation observation, Random random) {
    std::map<std::int32_t, int> pixels;
    for (int v = 0; v < view.objects.height(); ++v) {
      for (int u = 0; u < view.objects.width(); ++u) {
        if (observation.depth(u, v) > 0 && shapes_.of_object.count(view.objects(u, v))) {
          ++pixels[view.objects(u, v)];
        }
      }
    }
    const Segmentation segmentation = corruptMasks(view.objects, view.labels, object_labels_,
                                                   drawCorruption(random), random.bits());
    for (const auto& [object, count] : pixels) {
      const std::uint32_t shape = shapes_.of_object.at(object);
      Random view_random = random.fork(shape);
      if (count < config_.min_pixels || counts_[shape] >= config_.max_views_per_shape) continue;
      const bool clean = view_random.chance(config_.clean_masks);
      const InstanceId instance =
          clean ? kNoInstance : instanceOf(object, view.objects, segmentation.instances);
      if (!clean && instance == kNoInstance) continue;
      observation.mask = Image<std::uint8_t>(view.objects.width(), view.objects.height());
      for (std::size_t i = 0; i < observation.mask.size(); ++i) {
        observation.mask.data()[i] =
            clean ? view.objects.data()[i] == object : segmentation.instances.data()[i] == instance;
      }
      TrainingView sample;
      sample.shape = shape;
      sample.clean = clean;
      sample.center =
          (shapes_.centers[shape] - observation.T_world_camera.translation()).cast<float>();
      sample.yaw = static_cast<float>(shapes_.yaws[shape]);
      sample.points = gatherObjectPoints(observation, {}, view_random.bits());
      if (sample.points.object.size() < 30) continue;
      for (const Eigen::Vector3f& p : sample.points.object) {
        sample.on_object.push_back(lies(p, object, view, observation) ? 1 : 0);
      }
      ++counts_[shape];
      world_.views.push_back(std::move(sample));
    }
  }

 private:
  /// Whether the pixel of a level point shows the object.
  static bool lies(const Eigen::Vector3f& p_level, std::int32_t object, const RenderedView& view,
                   const ShapeObservation& observation) {
    const auto pixel = observation.camera.project(observation.T_world_camera.linear().transpose() *
                                                  p_level.cast<double>());
    const int u = static_cast<int>(std::lround(pixel->x()));
    const int v = static_cast<int>(std::lround(pixel->y()));
    return view.objects.contains(u, v) && view.objects(u, v) == object;
  }

  const TrainingWorldConfig& config_;
  const Shapes& shapes_;
  TrainingWorld& world_;
  std::vector<Label> object_labels_;
  std::vector<int> counts_;
};

}  // namespace

void read(ConfigReader& reader, TrainingWorldConfig& config) {
  reader.choice("world", config.world, {"office", "quick"});
  reader.field("frames", config.frames, {1, 100000});
  reader.field("max_views_per_shape", config.max_views_per_shape, {1, 100000});
  reader.field("sdf_points", config.sdf_points, {100, 1000000});
  reader.field("min_pixels", config.min_pixels, {5, 100000});
  reader.field("image_width_px", config.image_width, {60, 4000});
  reader.field("clean_masks", config.clean_masks, {0, 1});
  reader.field("max_depth_m", config.max_depth_m, {0.5, 20});
}

std::uint64_t trainingWorldSeed(InstanceSplit split, std::uint64_t index) {
  if (split == InstanceSplit::kEvaluation || index >> 61) std::abort();
  return (std::uint64_t{1} << 63) |
         (split == InstanceSplit::kTraining ? 0 : std::uint64_t{1} << 62) | index;
}

OfficeConfig trainingOffice(const TrainingWorldConfig& config, InstanceSplit split,
                            std::uint64_t index) {
  Random random = Random(trainingWorldSeed(split, index)).fork(kOfficeStream);
  OfficeConfig office = config.world == "quick" ? OfficeConfig::quick() : OfficeConfig();
  office.split = split;
  if (config.world == "quick") return office;
  office.chairs = static_cast<int>(random.uniform(26, 44));
  office.couches = 16;
  office.plants = 26;
  office.bins = 26;
  office.computers = static_cast<int>(random.uniform(4, 18));
  return office;
}

TrainingWorld makeTrainingWorld(const TrainingWorldConfig& config, InstanceSplit split,
                                std::uint64_t index) {
  const Random random(trainingWorldSeed(split, index));
  const auto scene = std::make_shared<const Scene>(
      makeOffice(trainingOffice(config, split, index), trainingWorldSeed(split, index)));
  const Shapes shapes = collectShapes(*scene, config.sdf_points, random.fork(kShapeStream));
  const RgbdRenderer renderer(scene, {.with_overhead = true, .with_color = false});
  const ClearanceMap clearance(*scene, 0.05, 1.2);
  TrainingWorld world;
  world.shapes = shapes.shapes;
  ViewCollector collector(config, *scene, shapes, world);
  for (int i = 0; i < config.frames; ++i) {
    Random frame = random.fork(kFrameStream).fork(static_cast<std::uint64_t>(i));
    ShapeObservation observation;
    observation.camera = drawCamera(config.image_width, frame);
    const std::optional<Transform> pose = drawPose(clearance, shapes.centers, frame);
    if (!pose) continue;
    observation.T_world_camera = *pose;
    const RenderedView view = renderer.render(observation.camera, *pose);
    observation.depth = noisyDepth(view, observation.camera, drawNoise(frame), frame.bits());
    for (float& depth : observation.depth) {
      if (depth > config.max_depth_m) depth = 0;
    }
    collector.add(view, std::move(observation), frame);
  }
  return world;
}

}  // namespace hydrabench
