// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/scene_evaluator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/geometry/raycaster.h"
#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr std::size_t kGrain = 256;
constexpr const char* kElsewhere = "elsewhere";
constexpr double kUpright = 0.7;  // cosine of 45 degrees: steeper ground is the face of a kerb

Mesh facesOf(const Mesh& mesh, const std::vector<char>& chosen) {
  Mesh part;
  part.vertices = mesh.vertices;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (chosen[f]) part.faces.push_back(mesh.faces[f]);
  }
  return part;
}

Eigen::Vector3d faceNormal(const Mesh& mesh, std::size_t face) {
  const Eigen::Vector3i& f = mesh.faces[face];
  return (mesh.vertices[static_cast<std::size_t>(f[1])] -
          mesh.vertices[static_cast<std::size_t>(f[0])])
      .cross(mesh.vertices[static_cast<std::size_t>(f[2])] -
             mesh.vertices[static_cast<std::size_t>(f[0])]);
}

Raycaster raycasterOf(const Mesh& mesh) {
  Raycaster raycaster;
  raycaster.add(mesh);
  raycaster.commit();
  return raycaster;
}

/// Places on the path, at least so far apart.
std::vector<Eigen::Vector3d> eyesOf(const std::vector<StampedPose>& trajectory, double spacing_m) {
  std::vector<Eigen::Vector3d> eyes;
  for (const StampedPose& pose : trajectory) {
    const Eigen::Vector3d eye = pose.T_world_camera.translation();
    if (eyes.empty() || (eye - eyes.back()).norm() >= spacing_m) eyes.push_back(eye);
  }
  return eyes;
}

}  // namespace

struct SceneEvaluator::Impl {
  struct Point {
    Eigen::Vector3d position;
    std::size_t square = 0;
    int band = -1;  ///< of ground; -1: not ground
  };
  struct Feature {
    std::string name;
    Raycaster surface;
  };
  using Square = std::pair<int, int>;

  SceneScoringConfig config;
  Mesh surface;
  std::vector<char> is_ground;  ///< per face
  Raycaster world;
  std::vector<Feature> features;
  std::vector<Eigen::Vector3d> eyes;
  std::map<Square, std::vector<std::size_t>> eyes_near;  ///< by the square they are in
  std::map<Square, std::size_t> squares;
  std::vector<Point> points;  ///< true and in view
  double m2_per_point = 0;

  Square squareOf(const Eigen::Vector3d& p) const {
    return {static_cast<int>(std::floor(p.x() / config.square_m)),
            static_cast<int>(std::floor(p.y() / config.square_m))};
  }

  /// Eyes within the radius, on the ground plan, the nearest first.
  std::vector<std::pair<double, std::size_t>> eyesAround(const Eigen::Vector3d& p) const {
    const int reach = static_cast<int>(std::ceil(config.radius_m / config.square_m));
    const Square own = squareOf(p);
    std::vector<std::pair<double, std::size_t>> around;
    for (int x = own.first - reach; x <= own.first + reach; ++x) {
      for (int y = own.second - reach; y <= own.second + reach; ++y) {
        const auto found = eyes_near.find({x, y});
        if (found == eyes_near.end()) continue;
        for (const std::size_t eye : found->second) {
          const double distance = (eyes[eye] - p).head<2>().norm();
          if (distance <= config.radius_m) around.emplace_back(distance, eye);
        }
      }
    }
    std::sort(around.begin(), around.end());
    return around;
  }

  bool sees(const Eigen::Vector3d& eye, const Eigen::Vector3d& p) const {
    const Eigen::Vector3d way = p - eye;
    const double distance = way.norm();
    constexpr double kBefore_m = 0.01;  // the surface itself does not hide the point
    if (distance <= kBefore_m) return true;
    const Raycaster::Ray ray{eye.cast<float>(), (way / distance).cast<float>(), 0,
                             static_cast<float>(distance - kBefore_m)};
    std::uint8_t blocked = 0;
    world.occluded({&ray, 1}, {&blocked, 1});
    return blocked == 0;
  }

  void takePoints() {
    const double area = surfaceArea(surface);
    const auto count = static_cast<std::size_t>(area * config.points_per_m2);
    if (count == 0) return;
    m2_per_point = area / static_cast<double>(count);
    const SurfaceSamples samples = sampleSurface(surface, count, 0);
    std::vector<double> distances(count, -1);  // from the path; negative: out of view
    parallelFor(
        count,
        [&](std::size_t i) {
          const auto around = eyesAround(samples.points[i]);
          for (const auto& [distance, eye] : around) {
            if (!sees(eyes[eye], samples.points[i])) continue;
            distances[i] = around.front().first;
            return;
          }
        },
        kGrain);
    for (std::size_t i = 0; i < count; ++i) {
      if (distances[i] < 0) continue;
      Point point{samples.points[i], 0, -1};
      const std::size_t next = squares.size();
      point.square = squares.try_emplace(squareOf(point.position), next).first->second;
      if (is_ground[samples.faces[i]]) point.band = bandOf(distances[i]);
      points.push_back(point);
    }
  }

  static int bandOf(double distance_m) {
    for (std::size_t i = 0; i < SceneTally::kBandEnds_m.size(); ++i) {
      if (distance_m <= SceneTally::kBandEnds_m[i]) return static_cast<int>(i);
    }
    return -1;
  }

  /// The square of a place of the estimate; nullopt far from all that counts.
  std::optional<std::size_t> counted(const Eigen::Vector3d& p) const {
    const auto square = squares.find(squareOf(p));
    if (square == squares.end() || eyesAround(p).empty()) return std::nullopt;
    return square->second;
  }

  void tallyTruth(const Mesh& estimate, std::vector<SceneTally>& tallies) const {
    const std::optional<Raycaster> map =
        estimate.faces.empty() ? std::nullopt : std::optional(raycasterOf(estimate));
    std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
    if (map) {
      parallelFor(
          points.size(),
          [&](std::size_t i) { distances[i] = map->nearest(points[i].position).distance; }, kGrain);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      SceneTally& tally = tallies[points[i].square];
      ++tally.truth_points;
      if (map) tally.truth_distance_m += distances[i];
      for (std::size_t t = 0; t < SceneTally::kWithin_m.size(); ++t) {
        tally.truth_within[t] += distances[i] < SceneTally::kWithin_m[t];
      }
      if (points[i].band < 0) continue;
      const auto band = static_cast<std::size_t>(points[i].band);
      tally.ground_m2[band] += m2_per_point;
      if (distances[i] <= config.voxel_m) tally.covered_ground_m2[band] += m2_per_point;
    }
  }

  void tallyEstimate(const Mesh& estimate, std::vector<SceneTally>& tallies) const {
    const auto count = static_cast<std::size_t>(surfaceArea(estimate) * config.points_per_m2);
    if (count == 0) return;
    const SurfaceSamples samples = sampleSurface(estimate, count, 0);
    std::vector<std::optional<std::size_t>> square(count);
    std::vector<Raycaster::SurfacePoint> nearest(count);
    parallelFor(
        count,
        [&](std::size_t i) {
          square[i] = counted(samples.points[i]);
          if (square[i]) nearest[i] = world.nearest(samples.points[i]);
        },
        kGrain);
    for (std::size_t i = 0; i < count; ++i) {
      if (!square[i]) continue;
      SceneTally& tally = tallies[*square[i]];
      ++tally.estimate_points;
      tally.estimate_distance_m += nearest[i].distance;
      for (std::size_t t = 0; t < SceneTally::kWithin_m.size(); ++t) {
        tally.estimate_within[t] += nearest[i].distance < SceneTally::kWithin_m[t];
      }
      if (!is_ground[nearest[i].face]) continue;
      ++tally.ground_points;
      tally.ground_square_error_m2 += nearest[i].distance * nearest[i].distance;
    }
  }

  void tallyBoundary(const Mesh& estimate, std::vector<SceneTally>& tallies) const {
    std::map<std::pair<int, int>, int> faces_of_edge;
    for (const Eigen::Vector3i& face : estimate.faces) {
      for (int i = 0; i < 3; ++i) {
        const auto edge = std::minmax(face[i], face[(i + 1) % 3]);
        ++faces_of_edge[{edge.first, edge.second}];
      }
    }
    for (const auto& [edge, faces] : faces_of_edge) {
      if (faces != 1) continue;
      const Eigen::Vector3d& a = estimate.vertices[static_cast<std::size_t>(edge.first)];
      const Eigen::Vector3d& b = estimate.vertices[static_cast<std::size_t>(edge.second)];
      const Eigen::Vector3d middle = (a + b) / 2;
      const auto square = counted(middle);
      if (square && is_ground[world.nearest(middle).face]) {
        tallies[*square].boundary_m += (a - b).norm();
      }
    }
  }

  /// Free, and farther than a voxel from every surface: looking up, the first surface is seen from
  /// outside, or there is none.
  bool falselyFilled(const Eigen::Vector3d& p) const {
    if (world.nearest(p, config.voxel_m).face != Raycaster::kMiss) return false;
    const Raycaster::Hit above = world.intersect({p.cast<float>(), Eigen::Vector3f::UnitZ()});
    return !above || faceNormal(surface, above.face).z() < 0;
  }

  const std::string& nearby(const Eigen::Vector3d& p) const {
    static const std::string elsewhere = kElsewhere;
    const std::string* name = &elsewhere;
    double least = config.feature_reach_m;
    for (const Feature& feature : features) {
      const auto nearest = feature.surface.nearest(p, least);
      if (nearest.face == Raycaster::kMiss) continue;
      least = nearest.distance;
      name = &feature.name;
    }
    return *name;
  }

  void tallyFilled(const SceneGraph& map, std::vector<SceneTally>& tallies) const {
    if (map.occupied.empty()) return;
    const double volume_m3 = std::pow(map.occupied_voxel_m, 3);
    // A place that was left and seen again may be in the list twice.
    std::set<std::array<int, 3>> seen;
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3f& center : map.occupied) {
      std::array<int, 3> voxel;
      for (int i = 0; i < 3; ++i) {
        voxel[static_cast<std::size_t>(i)] =
            static_cast<int>(std::floor(center[i] / map.occupied_voxel_m));
      }
      if (seen.insert(voxel).second) places.push_back(center.cast<double>());
    }
    std::vector<std::optional<std::size_t>> square(places.size());
    std::vector<std::string> near(places.size());
    parallelFor(
        places.size(),
        [&](std::size_t i) {
          square[i] = counted(places[i]);
          if (square[i] && !falselyFilled(places[i])) square[i].reset();
          if (square[i]) near[i] = nearby(places[i]);
        },
        kGrain);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (square[i]) tallies[*square[i]].filled_m3[near[i]] += volume_m3;
    }
  }
};

SceneEvaluator::SceneEvaluator(const GroundTruth& truth, const LabelSpace& label_space,
                               const SceneScoringConfig& config)
    : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.config = config;
  impl.surface = truth.scene_mesh;
  if (truth.scene_mesh.empty() || truth.trajectory.empty()) {
    throw InputError(
        "evaluation.scene: the dataset has no scene mesh or no path in its ground truth; expected "
        "both, or evaluation.scene.enabled: false");
  }
  if (truth.scene_labels.size() != truth.scene_mesh.faces.size()) {
    throw InputError(fmt::format(
        "evaluation.scene: the ground truth has {} labels for the {} faces of its scene mesh; "
        "expected one each",
        truth.scene_labels.size(), truth.scene_mesh.faces.size()));
  }
  const auto facesNamed = [&](const std::vector<std::string>& names) {
    std::vector<Label> labels;
    for (const std::string& name : names) {
      if (const LabelSpace::Entry* entry = label_space.find(name)) labels.push_back(entry->label);
    }
    std::vector<char> chosen(truth.scene_labels.size());
    std::transform(truth.scene_labels.begin(), truth.scene_labels.end(), chosen.begin(),
                   [&](Label label) {
                     return std::find(labels.begin(), labels.end(), label) != labels.end();
                   });
    return chosen;
  };
  const std::vector<std::string> ground =
      config.ground.empty() ? label_space.groundNames() : config.ground;
  impl.is_ground = facesNamed(ground);
  if (std::none_of(impl.is_ground.begin(), impl.is_ground.end(), [](char is) { return is; })) {
    throw InputError(fmt::format(
        "evaluation.scene.ground is [{}]; expected classes of the dataset, at least one of them "
        "with a surface",
        fmt::join(ground, ", ")));
  }
  impl.world = raycasterOf(impl.surface);
  const auto addFeature = [&](const std::string& name, const std::vector<char>& faces) {
    const Mesh part = facesOf(impl.surface, faces);
    if (!part.faces.empty()) impl.features.push_back({name, raycasterOf(part)});
  };
  for (const std::string& name : config.features) addFeature(name, facesNamed({name}));
  std::vector<char> kerbs = facesNamed(config.features);
  for (std::size_t f = 0; f < kerbs.size(); ++f) {
    const Eigen::Vector3d normal = faceNormal(impl.surface, f);
    kerbs[f] = impl.is_ground[f] && !kerbs[f] && normal.z() < kUpright * normal.norm();
  }
  addFeature("kerb", kerbs);
  impl.eyes = eyesOf(truth.trajectory, config.eye_spacing_m);
  for (std::size_t i = 0; i < impl.eyes.size(); ++i) {
    impl.eyes_near[impl.squareOf(impl.eyes[i])].push_back(i);
  }
  impl.takePoints();
}

SceneEvaluator::~SceneEvaluator() = default;
SceneEvaluator::SceneEvaluator(SceneEvaluator&&) noexcept = default;
SceneEvaluator& SceneEvaluator::operator=(SceneEvaluator&&) noexcept = default;

std::vector<SceneTally> SceneEvaluator::evaluate(const SceneGraph& map) const {
  std::vector<SceneTally> tallies(impl_->squares.size());
  impl_->tallyTruth(map.scene_mesh, tallies);
  impl_->tallyEstimate(map.scene_mesh, tallies);
  impl_->tallyBoundary(map.scene_mesh, tallies);
  impl_->tallyFilled(map, tallies);
  return tallies;
}

void read(ConfigReader& reader, SceneScoringConfig& config) {
  reader.field("enabled", config.enabled);
  reader.field("radius_m", config.radius_m, Bounds{0.1, SceneTally::kBandEnds_m.back()});
  reader.field("points_per_m2", config.points_per_m2, Bounds{0.01, 1e4});
  reader.field("voxel_m", config.voxel_m, Bounds{1e-3, 10});
  reader.field("square_m", config.square_m, Bounds{0.1, 1e4});
  reader.field("eye_spacing_m", config.eye_spacing_m, Bounds{0.01, 100});
  reader.field("feature_reach_m", config.feature_reach_m, Bounds{0, 100});
  reader.field("ground", config.ground);
  reader.field("features", config.features);
}

}  // namespace hydrabench
