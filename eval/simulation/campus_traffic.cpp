// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_traffic.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/campus_labels.h"
#include "eval/simulation/campus_objects.h"
#include "eval/simulation/ground_pose.h"
#include "eval/simulation/pedestrian.h"
#include "eval/simulation/placed_shape.h"
#include "eval/simulation/sdf_queries.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;

// Streams of the world's seed.
constexpr std::uint64_t kTrafficStream = 5;
// Within it.
constexpr std::uint64_t kCarLane = 1;
constexpr std::uint64_t kFootLanes = 2;
constexpr std::uint64_t kCar = 3;
constexpr std::uint64_t kPerson = 4;

constexpr double kCarGap_m = 0.10;     // on either side of a car
constexpr double kPersonGap_m = 0.05;  // on either side of someone
constexpr double kCarHeight_m = 2.2;   // what is higher up is in nobody's way
constexpr double kPersonHeight_m = 2.1;
constexpr double kKerb_m = 0.1;   // nobody walks nearer to the edge of the pavement
constexpr double kUneven = 0.25;  // of the distance between two in a lane, either way
constexpr double kPoses_hz = 10;  // between them a car in a bend is 4 mm off its lane

/// Offsets from the middle of the road.
struct Strip {
  double low = 0;
  double high = 0;
  double middle() const { return 0.5 * (low + high); }
  double width() const { return high - low; }
};

struct Lane {
  double offset_m = 0;
  double direction = 1;  ///< 1: as the loop is driven, -1: against it
  double speed_m_s = 0;
  double length_m = 0;
};

/// What is left of a strip, all along the loop, between the things that reach into it on either
/// side of its middle.
Strip freePart(const Strip& strip, double height_m, const CampusTerrain& terrain,
               const Scene& scene) {
  Strip free = strip;
  for (const SceneObject& object : scene.objects) {
    for (const Eigen::Vector3d& vertex : object.surface->mesh.vertices) {
      const Eigen::Vector3d p = object.T_world_object * vertex;
      const double offset = terrain.loop().offsetOf(p.head<2>());
      if (offset <= free.low || offset >= free.high) continue;
      if (p.z() - terrain.heightAt(p.head<2>()) > height_m) continue;
      (offset < strip.middle() ? free.low : free.high) = offset;
    }
  }
  return free;
}

Lane makeLane(const CampusTerrain& terrain, double offset, double direction, double speed) {
  return {offset, direction, speed, terrain.loop().lengthAt(offset)};
}

/// Where number `index` of `count` in a lane starts.
double startOf(const Lane& lane, int index, int count, Random& random) {
  return (index + random.uniform(-kUneven, kUneven)) / count * lane.length_m;
}

/// Poses at all times.
/// @param poseAfter  of the distance travelled [m]
template <typename PoseAfter>
std::vector<TimedPose> posesAlong(const Lane& lane, std::int64_t end_ns,
                                  const PoseAfter& poseAfter) {
  constexpr auto kStep_ns = static_cast<std::int64_t>(1e9 / kPoses_hz);
  std::vector<TimedPose> poses;
  for (std::int64_t stamp_ns = 0; stamp_ns < end_ns + kStep_ns; stamp_ns += kStep_ns) {
    poses.push_back({stamp_ns, poseAfter(lane.speed_m_s * 1e-9 * static_cast<double>(stamp_ns))});
  }
  return poses;
}

/// Place and heading in a lane.
struct Heading {
  Vector2d place;
  double yaw_rad;
};

/// Both axles are in the lane.
Heading carIn(const Lane& lane, const CampusLoop& loop, double along_m, double wheelbase_m) {
  const auto axle = [&](double ahead) {
    return loop.along(along_m + lane.direction * ahead, lane.offset_m).point;
  };
  const Vector2d front = axle(0.5 * wheelbase_m);
  const Vector2d rear = axle(-0.5 * wheelbase_m);
  const Vector2d ahead = front - rear;
  return {0.5 * (front + rear), std::atan2(ahead.y(), ahead.x())};
}

void addCars(const CampusConfig& config, const CampusTerrain& terrain, std::uint64_t seed,
             std::int64_t end_ns, Scene& scene) {
  constexpr std::uint64_t kDraws = 128;  // between parked cars a dozen may all be too wide
  constexpr double kWheelbase = 0.6;     // share of the length
  constexpr double kRoad_m = CampusTerrain::kRoadHalfWidth_m;
  const Strip strip = freePart({-kRoad_m, kRoad_m}, kCarHeight_m, terrain, scene);
  Random draw = Random(seed).fork(kCarLane);
  const double direction = draw.chance(0.5) ? 1 : -1;
  const Lane lane = makeLane(terrain, strip.middle(), direction, draw.uniform(3.5, 5.0));

  const int count = config.movers.cars;
  std::vector<Mover> cars(static_cast<std::size_t>(count));
  parallelFor(cars.size(), [&](std::size_t i) {
    Random random = Random(seed, kCar).fork(i);
    const double start = startOf(lane, static_cast<int>(i), count, random);
    for (std::uint64_t attempt = 0; attempt < kDraws; ++attempt) {
      const std::uint64_t instance = instanceIndex(hashSeed(seed, kCar), kDraws * i + attempt);
      const ShapeInstance shape =
          drawOutdoorFamily("car", random).draw(Random(instanceSeed(config.split, instance)));
      const Aabb box = tightBounds(*shape.sdf);
      if (box.sizes().y() + 2 * kCarGap_m > strip.width()) continue;
      cars[i].label = campus_label::kCar;
      cars[i].parts.push_back({surfaceOf(shape), posesAlong(lane, end_ns, [&](double driven) {
                                 const Heading car =
                                     carIn(lane, terrain.loop(), start + lane.direction * driven,
                                           kWheelbase * box.sizes().x());
                                 return wheeledPose(terrain, car.place, car.yaw_rad, box);
                               })});
      return;
    }
  });
  const auto missing =
      std::count_if(cars.begin(), cars.end(), [](const Mover& car) { return car.parts.empty(); });
  if (missing > 0) {
    throw InputError(fmt::format(
        "campus.movers.cars: {}, but {} of them are wider than the {:.2f} m that parked cars leave "
        "of the road; expected 0 for this seed",
        count, missing, strip.width()));
  }
  for (std::size_t i = 0; i < cars.size(); ++i)
    cars[i].name = fmt::format("car_moving_{:03d}", i + 1);
  std::move(cars.begin(), cars.end(), std::back_inserter(scene.movers));
}

std::vector<Lane> footLanes(const CampusTerrain& terrain, const Scene& scene, Random random) {
  constexpr double kNear = CampusTerrain::kRoadHalfWidth_m + kKerb_m;
  constexpr double kFar = CampusTerrain::kRoadHalfWidth_m + CampusTerrain::kPavementWidth_m;
  constexpr double kHalfLane_m = Pedestrian::kHalfWidth_m + kPersonGap_m;
  std::vector<Lane> lanes;
  const auto add = [&](double offset, double direction) {
    lanes.push_back(makeLane(terrain, offset, direction, random.uniform(0.9, 1.6)));
  };
  const Strip between = {-kFar, CampusWay::kOffset_m - CampusWay::kClearance_m};
  for (const Strip& strip : {between, Strip{kNear, kFar}}) {
    const Strip free = freePart(strip, kPersonHeight_m, terrain, scene);
    const double direction = random.chance(0.5) ? 1 : -1;
    if (free.width() >= 4 * kHalfLane_m) {
      add(free.low + kHalfLane_m, direction);
      add(free.high - kHalfLane_m, -direction);
    } else if (free.width() >= 2 * kHalfLane_m) {
      add(free.middle(), direction);
    }
  }
  return lanes;
}

Mover makePerson(const Lane& lane, double start, const CampusTerrain& terrain, std::int64_t end_ns,
                 const Pedestrian& person) {
  Mover mover;
  mover.label = campus_label::kHuman;
  for (std::size_t limb = 0; limb < person.limbs.size(); ++limb) {
    mover.parts.push_back(
        {surfaceOf(person.limbs[limb].shape), posesAlong(lane, end_ns, [&](double walked) {
           const CampusLoop::Station station =
               terrain.loop().along(start + lane.direction * walked, lane.offset_m);
           const Vector2d ahead = lane.direction * station.ahead;
           // Leaning, so that both feet are on the slope.
           const Transform T_world_person =
               leaningPose({station.point.x(), station.point.y(), terrain.heightAt(station.point)},
                           std::atan2(ahead.y(), ahead.x()), terrain.baseSlopeAt(station.point));
           return T_world_person * person.limbPose(limb, start + walked);
         })});
  }
  return mover;
}

void addPeople(const CampusConfig& config, const CampusTerrain& terrain, std::uint64_t seed,
               std::int64_t end_ns, Scene& scene) {
  const std::vector<Lane> lanes = footLanes(terrain, scene, Random(seed).fork(kFootLanes));
  if (lanes.empty()) return;
  scene.label_space.entries.push_back({campus_label::kHuman, "human", {220, 20, 60}, false, false});
  const int count = config.movers.pedestrians;
  const int num_lanes = static_cast<int>(lanes.size());
  std::vector<Mover> people(static_cast<std::size_t>(count));
  parallelFor(people.size(), [&](std::size_t i) {
    Random random = Random(seed, kPerson).fork(i);
    const int index = static_cast<int>(i);
    const Lane& lane = lanes[i % lanes.size()];
    const int in_lane = (count - index % num_lanes + num_lanes - 1) / num_lanes;
    const double start = startOf(lane, index / num_lanes, in_lane, random);
    people[i] = makePerson(lane, start, terrain, end_ns, drawPedestrian(random));
    people[i].name = fmt::format("human_{:03d}", i + 1);
  });
  std::move(people.begin(), people.end(), std::back_inserter(scene.movers));
}

}  // namespace

void addCampusTraffic(const CampusConfig& config, std::uint64_t seed, std::int64_t end_ns,
                      Scene& scene) {
  const CampusTerrain terrain = campusTerrain(seed);
  const std::uint64_t stream = hashSeed(seed, kTrafficStream);
  if (config.movers.cars > 0) addCars(config, terrain, stream, end_ns, scene);
  if (config.movers.pedestrians > 0) addPeople(config, terrain, stream, end_ns, scene);
}

}  // namespace hydrabench
