// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_objects.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "eval/simulation/campus_labels.h"
#include "eval/simulation/ground_pose.h"
#include "eval/simulation/sdf_queries.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Station = CampusLoop::Station;

constexpr double kPi = std::numbers::pi;
constexpr double kGap_m = 0.08;          // between any two objects
constexpr double kBay_m = 6.4;           // length of a parking bay
constexpr double kInnerShare = 0.75;     // of scored objects on the side of the way
constexpr double kBenchSlope = 0.004;    // benches stand where it is no steeper
constexpr double kHydrantSlope = 0.035;  // likewise: a flange of 0.2 m is then level within 7 mm
constexpr double kFreeHeight_m = 2.0;    // above the way; crowns may hang over it
constexpr double kKerbside_m = CampusTerrain::kRoadHalfWidth_m + 0.42;
constexpr double kLawn_m = CampusTerrain::kRoadHalfWidth_m + CampusTerrain::kPavementWidth_m;

/// Places along the way, given by the distance from its start and the offset from the road's
/// middle.
class Placer {
 public:
  Placer(const CampusConfig& config, const CampusTerrain& terrain, const CampusWay& way,
         std::uint64_t seed)
      : terrain_(terrain), way_(way), seed_(seed), split_(config.split) {}

  struct Piece {
    std::shared_ptr<const ShapeInstance> shape;
    Label label = kUnknownLabel;
    Aabb box;  ///< object frame
  };

  Random random(std::uint64_t stream) const { return Random(seed_).fork(stream); }
  double wayLength() const { return way_.to_m - way_.from_m; }
  const CampusTerrain& terrain() const { return terrain_; }

  /// A new instance of one of the families of a class.
  Piece draw(const std::string& class_name, Label label, Random& random) {
    const ShapeFamily& family = drawOutdoorFamily(class_name, random);
    Piece piece;
    piece.shape = std::make_shared<const ShapeInstance>(
        family.draw(Random(instanceSeed(split_, instanceIndex(seed_, drawn_++)))));
    piece.label = label;
    piece.box = tightBounds(*piece.shape->sdf);
    return piece;
  }

  /// Across from a place of the way; `point` is moved to the offset.
  Station at(double distance, double offset) const {
    Station station = terrain_.loop().along(way_.from_m + distance, CampusWay::kOffset_m);
    station.point += (offset - CampusWay::kOffset_m) * station.out;
    return station;
  }

  Transform uprightPose(const Vector2d& place, double yaw) const {
    return leaningPose({place.x(), place.y(), terrain_.heightAt(place)}, yaw, Vector2d::Zero());
  }

  /// Takes the place if nothing is in the way.
  bool put(const Piece& piece, const Transform& T_world_object) {
    Aabb box;
    for (int i = 0; i < 8; ++i) {
      box.extend(T_world_object * piece.box.corner(static_cast<Aabb::CornerType>(i)));
    }
    box.min().array() -= kGap_m;
    box.max().array() += kGap_m;
    const PlacedSdf own{piece.shape->sdf.get(), T_world_object, box};
    for (const PlacedSdf& other : taken_) {
      if (other.box.intersects(box) && interpenetrate(own, other, -kGap_m)) return false;
    }
    if (onTheWay(own)) return false;
    placed_.push_back({piece.shape, piece.label, "", T_world_object});
    taken_.push_back(own);
    return true;
  }

  std::vector<PlacedShape> take() { return std::move(placed_); }

 private:
  bool onTheWay(const PlacedSdf& object) const {
    constexpr double kStep_m = 0.2;
    constexpr double kReach_m = CampusWay::kClearance_m + 0.1;
    const Transform T_object_world = object.T_world_sdf.inverse();
    for (double s = 0; s <= wayLength(); s += kStep_m) {
      const Vector2d p = at(s, CampusWay::kOffset_m).point;
      if ((p.array() < object.box.min().head<2>().array() - kReach_m).any() ||
          (p.array() > object.box.max().head<2>().array() + kReach_m).any()) {
        continue;
      }
      const double ground = terrain_.heightAt(p);
      for (double up = 0.1; up < kFreeHeight_m; up += kStep_m) {
        if (object.sdf->value(T_object_world * Vector3d(p.x(), p.y(), ground + up)) < kReach_m) {
          return true;
        }
      }
    }
    return false;
  }

  const CampusTerrain& terrain_;
  CampusWay way_;
  std::uint64_t seed_;
  InstanceSplit split_;
  std::uint64_t drawn_ = 0;
  std::vector<PlacedShape> placed_;
  std::vector<PlacedSdf> taken_;
};

double yawOf(const Vector2d& direction) { return std::atan2(direction.y(), direction.x()); }

/// Bays along one kerb, in random order.
void placeCars(Placer& placer, int count, double side, Random random) {
  std::vector<double> bays;
  for (double s = 0.5 * kBay_m; s + 0.5 * kBay_m < placer.wayLength(); s += kBay_m) {
    const auto bends = [&](double at) { return placer.at(at, 0).in_bend; };
    if (!bends(s - 0.5 * kBay_m) && !bends(s + 0.5 * kBay_m)) bays.push_back(s);
  }
  for (std::size_t i = bays.size(); i > 1; --i) {
    std::swap(bays[i - 1], bays[random.index(static_cast<std::uint32_t>(i))]);
  }
  for (const double bay : bays) {
    if (count == 0) break;
    const Placer::Piece car = placer.draw("car", campus_label::kCar, random);
    const double from_kerb = 0.5 * car.box.sizes().y() + random.uniform(0.12, 0.3);
    const Station station = placer.at(bay + random.uniform(-0.3, 0.3),
                                      side * (CampusTerrain::kRoadHalfWidth_m - from_kerb));
    const bool backwards = random.chance(0.25);
    const double yaw = yawOf(station.ahead) + (backwards ? kPi : 0) + 0.012 * random.normal();
    if (placer.put(car, wheeledPose(placer.terrain(), station.point, yaw, car.box))) --count;
  }
}

/// Tries places until `count` pieces stand; a piece that fits nowhere gives way to another.
/// @param poseFor  of a drawn piece at a random place; nullopt where it must not stand
void scatter(Placer& placer, const std::string& class_name, Label label, int count, Random random,
             const std::function<std::optional<Transform>(const Placer::Piece&, double s, Random&)>&
                 poseFor) {
  constexpr int kAttempts = 60;
  constexpr int kDraws = 6;
  const auto stands = [&](const Placer::Piece& piece) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const double s = random.uniform(0, placer.wayLength());
      const auto pose = poseFor(piece, s, random);
      if (pose && placer.put(piece, *pose)) return true;
    }
    return false;
  };
  for (int i = 0; i < count; ++i) {
    int draws = 0;
    while (!stands(placer.draw(class_name, label, random)) && ++draws < kDraws) {
    }
  }
}

void placeHydrants(Placer& placer, int count, double side, Random random) {
  scatter(placer, "fire_hydrant", campus_label::kFireHydrant, count, random,
          [&](const Placer::Piece&, double s, Random& draw) -> std::optional<Transform> {
            const Station station = placer.at(s, side * (kKerbside_m + draw.uniform(0, 0.08)));
            if (placer.terrain().baseSlopeAt(station.point).norm() > kHydrantSlope) return {};
            // To the road, more or less.
            return placer.uprightPose(station.point,
                                      yawOf(-side * station.out) + 0.3 * draw.normal());
          });
}

void placeBenches(Placer& placer, int count, double side, Random random) {
  scatter(placer, "bench", campus_label::kBench, count, random,
          [&](const Placer::Piece& bench, double s, Random& draw) -> std::optional<Transform> {
            const double depth = bench.box.sizes().x();
            const Station station =
                placer.at(s, side * (kLawn_m + 0.1 + 0.5 * depth + draw.uniform(0, 0.3)));
            const double half = 0.5 * bench.box.sizes().norm();
            for (const double along : {-half, 0.0, half}) {
              const Vector2d p = station.point + along * station.ahead;
              if (placer.terrain().baseSlopeAt(p).norm() > kBenchSlope) return {};
              if (placer.terrain().labelAt(p) != campus_label::kGrass) return {};
            }
            return placer.uprightPose(station.point,
                                      yawOf(-side * station.out) + 0.04 * draw.normal());
          });
}

void placeLampPoles(Placer& placer, Random random) {
  constexpr double kSpacing_m = 24;
  double side = 1;
  for (double s = 8; s < placer.wayLength(); s += kSpacing_m, side = -side) {
    const Placer::Piece pole = placer.draw("pole", campus_label::kLampPole, random);
    for (const double shift : {0.0, 1.0, -1.0, 2.0}) {
      const Station station = placer.at(s + shift, side * kKerbside_m);
      if (placer.put(pole, placer.uprightPose(station.point, yawOf(-side * station.out)))) break;
    }
  }
}

void placeBollards(Placer& placer, int groups, Random random) {
  for (int group = 0; group < groups; ++group) {
    // One shape for the whole row.
    const Placer::Piece bollard = placer.draw("bollard", campus_label::kBollard, random);
    const double s = random.uniform(0, placer.wayLength());
    const double side = random.chance(0.7) ? -1 : 1;
    for (int i = 0; i < 4; ++i) {
      const Station station = placer.at(s + 1.5 * i, side * (kKerbside_m - 0.05));
      placer.put(bollard, placer.uprightPose(station.point, 0));
    }
  }
}

void placeSigns(Placer& placer, int count, Random random) {
  scatter(placer, "sign", campus_label::kSign, count, random,
          [&](const Placer::Piece&, double s, Random& draw) -> std::optional<Transform> {
            const double side = draw.chance(0.5) ? 1 : -1;
            const Station station = placer.at(s, side * kKerbside_m);
            return placer.uprightPose(station.point, yawOf(side * station.ahead));
          });
}

void placeTrees(Placer& placer, int count, double side, Random random) {
  scatter(placer, "tree", campus_label::kTree, count, random,
          [&](const Placer::Piece&, double s, Random& draw) -> std::optional<Transform> {
            const Station station = placer.at(s, side * draw.uniform(8.4, 9.7));
            if (placer.terrain().labelAt(station.point) != campus_label::kGrass) return {};
            if (placer.terrain().featureAt(station.point) == TerrainFeature::kStairs) return {};
            return placer.uprightPose(station.point, draw.uniform(-kPi, kPi));
          });
}

}  // namespace

const ShapeFamily& drawOutdoorFamily(const std::string& class_name, Random& random) {
  std::vector<const ShapeFamily*> families;
  for (const ShapeFamily& family : outdoorFamilies()) {
    if (family.class_name == class_name) families.push_back(&family);
  }
  return *families[random.index(static_cast<std::uint32_t>(families.size()))];
}

Transform wheeledPose(const CampusTerrain& terrain, const Vector2d& place, double yaw_rad,
                      const Aabb& box) {
  const Vector2d ahead(std::cos(yaw_rad), std::sin(yaw_rad));
  const Vector2d left(-ahead.y(), ahead.x());
  const double a = 0.29 * box.sizes().x();
  const double b = 0.36 * box.sizes().y();
  const auto height = [&](double x, double y) {
    return terrain.heightAt(place + x * ahead + y * left);
  };
  const double front = 0.5 * (height(a, b) + height(a, -b));
  const double rear = 0.5 * (height(-a, b) + height(-a, -b));
  const double across = (height(a, b) + height(-a, b) - height(a, -b) - height(-a, -b)) / (4 * b);
  const Vector2d slope = (front - rear) / (2 * a) * ahead + across * left;
  return leaningPose({place.x(), place.y(), 0.5 * (front + rear)}, yaw_rad, slope);
}

std::vector<PlacedShape> placeCampusObjects(const CampusConfig& config,
                                            const CampusTerrain& terrain, const CampusWay& way,
                                            std::uint64_t seed) {
  Placer placer(config, terrain, way, seed);
  const auto inner = [](int count) { return static_cast<int>(std::ceil(kInnerShare * count)); };
  std::uint64_t stream = 0;
  for (const double side : {-1.0, 1.0}) {  // of the way, across the road
    const auto share = [&](int count) { return side < 0 ? inner(count) : count - inner(count); };
    placeCars(placer, share(config.cars), side, placer.random(++stream));
    placeHydrants(placer, share(config.hydrants), side, placer.random(++stream));
    placeBenches(placer, share(config.benches), side, placer.random(++stream));
  }
  const double length = placer.wayLength();
  const auto every = [&](double spacing) { return static_cast<int>(std::ceil(length / spacing)); };
  placeLampPoles(placer, placer.random(++stream));
  placeBollards(placer, every(60), placer.random(++stream));
  placeSigns(placer, every(45), placer.random(++stream));
  placeTrees(placer, every(18), -1, placer.random(++stream));
  placeTrees(placer, every(14), 1, placer.random(++stream));
  return placer.take();
}

}  // namespace hydrabench
