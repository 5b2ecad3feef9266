// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/training_world.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <numbers>

#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"
#include "core/shape/latent_flow/latent_grid.h"
#include "eval/simulation/depth_noise.h"
#include "eval/simulation/mask_corruption.h"
#include "eval/simulation/office_world.h"
#include "eval/simulation/rgbd_renderer.h"
#include "eval/simulation/street_block.h"
#include "eval/training/training_views.h"

namespace hydrabench {
namespace {

constexpr std::uint64_t kOfficeStream = 1;
constexpr std::uint64_t kFrameStream = 2;
constexpr std::uint64_t kShapeStream = 3;
constexpr double kCube = 1.15;  // object coordinates: where distances are sampled

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

/// How an object leans, apart from its yaw: a car on an incline. The identity for all that stand
/// upright, to the last bit.
Eigen::Matrix3d leanOf(const SceneObject& object) {
  const Eigen::Matrix3d R = object.T_world_object.linear();
  if (R(2, 2) > 1 - 1e-12) return Eigen::Matrix3d::Identity();
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  return Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R;
}

/// A frame as it comes from an estimated pose: a little off, now and then turned altogether.
LocalFrame drawFrame(int yaw_symmetry, Random& random) {
  LocalFrame frame;
  for (int axis = 0; axis < 3; ++axis) frame.center[axis] = 0.06 * random.normal();
  frame.scale = std::exp(0.03 + 0.08 * random.normal());
  frame.bearing = 0.09 * random.normal();
  if (yaw_symmetry > 1) {
    const auto turns = random.index(static_cast<std::uint32_t>(yaw_symmetry));
    frame.bearing += 2 * std::numbers::pi * turns / yaw_symmetry;
  }
  if (yaw_symmetry == 0 || random.chance(0.15)) {
    frame.bearing = random.uniform(-std::numbers::pi, std::numbers::pi);
  }
  return frame;
}

/// @param distance  in object coordinates; its magnitude is never larger than the distance
ShapeGrid gridOf(const LocalFrame& frame,
                 const std::function<double(const Eigen::Vector3d&)>& distance) {
  constexpr int kBlock = 4;  // nodes a side that are left out together where the surface is far
  constexpr double kReach = 0.5 * std::numbers::sqrt3 * kBlock * kGridCell;
  ShapeGrid grid;
  grid.frame = frame;
  grid.values.resize(kGridSide * kGridSide * kGridSide);
  const auto at = [&](const Eigen::Vector3d& p) {
    return distance(frame.toLevel(p)) / frame.scale;
  };
  for (int z = 0; z < kGridSide; z += kBlock) {
    for (int y = 0; y < kGridSide; y += kBlock) {
      for (int x = 0; x < kGridSide; x += kBlock) {
        const Eigen::Vector3d middle =
            0.5 * (gridNode(x, y, z) + gridNode(x + kBlock - 1, y + kBlock - 1, z + kBlock - 1));
        const double there = at(middle);
        const bool far = std::abs(there) > kTruncation + kReach;
        for (int k = 0; k < kBlock * kBlock * kBlock; ++k) {
          const int i = x + k % kBlock;
          const int j = y + k / kBlock % kBlock;
          const int l = z + k / (kBlock * kBlock);
          grid.values[gridIndex(i, j, l)] = quantizedDistance(far ? there : at(gridNode(i, j, l)));
        }
      }
    }
  }
  return grid;
}

/// A leaning object as a shape of its own: object coordinates are upright, as are all estimates.
/// @param mesh  in the object's frame, turned by `lean`
TrainingShape shapeOf(const SceneObject& object, const std::string& class_name, const Mesh& mesh,
                      const Eigen::Matrix3d& lean, const TrainingWorldConfig& config,
                      int grid_frames, Random random) {
  const Aabb box = bounds(mesh);
  TrainingShape shape;
  shape.family = object.subtype;
  shape.class_name = class_name;
  shape.yaw_symmetry = shape.class_name == "plant" ? 0 : object.shape->yaw_symmetry;
  const Eigen::Vector3d center = box.center();
  double half = 0.5 * box.sizes().maxCoeff();
  if (shape.yaw_symmetry == 0) {
    half = 0.5 * box.sizes().z();
    for (const Eigen::Vector3d& p : mesh.vertices) {
      half = std::max(half, (p - center).head<2>().norm());
    }
  }
  shape.half_extent_m = static_cast<float>(half);
  const auto n = static_cast<std::size_t>(config.sdf_points);
  const auto distance = [&](const Eigen::Vector3d& p) {
    return object.shape->sdf->value(lean.transpose() * (center + half * p)) / half;
  };
  const std::size_t near = n / 2;
  const SurfaceSamples surface = sampleSurface(mesh, near, random.bits());
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
    shape.distances.push_back(static_cast<float>(std::clamp(distance(p), -0.5, 0.5)));
  }
  for (int i = 0; i < grid_frames; ++i) {
    shape.grids.push_back(gridOf(drawFrame(shape.yaw_symmetry, random), distance));
  }
  return shape;
}

Shapes collectShapes(const Scene& scene, const TrainingWorldConfig& config, Random random) {
  Shapes result;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (!object.shape || !(object.scored || config.objects == "all")) continue;
    const Eigen::Matrix3d lean = leanOf(object);
    Transform turned = Transform::Identity();
    turned.linear() = lean;
    const Aabb box = bounds(transformed(turned, object.surface->mesh));
    result.of_object[static_cast<std::int32_t>(i)] = static_cast<std::uint32_t>(chosen.size());
    chosen.push_back(i);
    result.centers.push_back(object.T_world_object * (lean.transpose() * box.center()));
    const Eigen::Matrix3d R = object.T_world_object.linear();
    result.yaws.push_back(std::atan2(R(1, 0), R(0, 0)));
  }
  // Desks of one island share their shape, and so their grids.
  std::vector<std::size_t> same_as(chosen.size());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const SceneObject& object = scene.objects[chosen[k]];
    while (scene.objects[chosen[same_as[k]]].shape != object.shape ||
           leanOf(scene.objects[chosen[same_as[k]]]) != leanOf(object)) {
      ++same_as[k];
    }
  }
  result.shapes.resize(chosen.size());
  parallelFor(chosen.size(), [&](std::size_t k) {
    const SceneObject& object = scene.objects[chosen[k]];
    const Eigen::Matrix3d lean = leanOf(object);
    Transform turned = Transform::Identity();
    turned.linear() = lean;
    const Mesh mesh = transformed(turned, object.surface->mesh);
    result.shapes[k] = shapeOf(object, scene.label_space.nameOf(object.label), mesh, lean, config,
                               same_as[k] == k ? config.grid_frames : 0, random.fork(chosen[k]));
  });
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    result.shapes[k].grids = result.shapes[same_as[k]].grids;
  }
  return result;
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
  reader.choice("world", config.world, {"office", "quick", "street"});
  reader.choice("objects", config.objects, {"scored", "all"});
  reader.field("frames", config.frames, {1, 100000});
  reader.field("max_views_per_shape", config.max_views_per_shape, {1, 100000});
  reader.field("sdf_points", config.sdf_points, {100, 1000000});
  reader.field("min_pixels", config.min_pixels, {5, 100000});
  reader.field("image_width_px", config.image_width, {60, 4000});
  reader.field("clean_masks", config.clean_masks, {0, 1});
  reader.field("max_depth_m", config.max_depth_m, {0.5, 20});
  reader.field("grid_frames", config.grid_frames, {0, 64});
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
  if (config.objects == "all") {  // a broader mix
    office.chairs = 20;
    office.couches = 8;
    office.plants = 12;
    office.bins = 14;
    office.computers = 48;
  }
  return office;
}

StreetBlockConfig trainingStreet(InstanceSplit split) {
  StreetBlockConfig street;
  street.split = split;
  return street;
}

TrainingWorld makeTrainingWorld(const TrainingWorldConfig& config, InstanceSplit split,
                                std::uint64_t index) {
  const std::uint64_t seed = trainingWorldSeed(split, index);
  const Random random(seed);
  const bool outdoors = config.world == "street";
  StreetBlock block;
  if (outdoors) {
    block = makeStreetBlock(trainingStreet(split), seed);
  } else {
    block.scene = makeOffice(trainingOffice(config, split, index), seed);
  }
  const std::shared_ptr<const Scene> scene(&block.scene, [](const Scene*) {});  // outlives it
  const Shapes shapes = collectShapes(*scene, config, random.fork(kShapeStream));
  const RgbdRenderer renderer(scene, {.with_overhead = true, .with_color = false});
  const TrainingViewsConfig wishes{config.image_width, config.max_depth_m, shapes.centers};
  const std::unique_ptr<TrainingViews> views =
      outdoors ? streetViews(block, wishes) : officeViews(*scene, wishes);
  TrainingWorld world;
  world.shapes = shapes.shapes;
  ViewCollector collector(config, *scene, shapes, world);
  for (int i = 0; i < config.frames; ++i) {
    Random frame = random.fork(kFrameStream).fork(static_cast<std::uint64_t>(i));
    const std::optional<DrawnView> drawn = views->draw(frame);
    if (!drawn) continue;
    ShapeObservation observation;
    observation.camera = drawn->camera;
    observation.T_world_camera = drawn->T_world_camera;
    const RenderedView view = renderer.render(observation.camera, observation.T_world_camera);
    observation.depth = noisyDepth(view, observation.camera, drawn->noise, frame.bits());
    for (float& depth : observation.depth) {
      if (depth > drawn->max_depth_m) depth = 0;
    }
    collector.add(view, std::move(observation), frame);
  }
  return world;
}

}  // namespace hydrabench
