// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/street_block.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "eval/simulation/campus_labels.h"
#include "eval/simulation/ground_pose.h"
#include "eval/simulation/placed_shape.h"
#include "eval/simulation/sdf_queries.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Pattern = Material::Pattern;

constexpr std::uint64_t kGroundStream = 1;
constexpr std::uint64_t kInstanceStream = 2;
constexpr std::uint64_t kPlaceStream = 3;

constexpr double kPi = std::numbers::pi;
constexpr double kKerb_m = 0.13;
constexpr double kRoad_m = 3.5;      ///< half its width
constexpr double kPavement_m = 7.0;  ///< outer edge
constexpr double kHouses_m = 15.0;   ///< fronts
constexpr double kGap_m = 0.25;
constexpr int kAttempts = 40;

/// A strip along the street between two lines, or a kerb's face between two heights.
void addStrip(const StreetBlock& block, double y0, double up0, double y1, double up1, Label label,
              const Material& material, Scene& scene) {
  StructurePart part{scene.label_space.nameOf(label), label, {}, false, false};
  part.surface.materials = {material};
  const auto corner = [&](double x, double y, double up) {
    return Vector3d(x, y, block.slope_x * x + block.slope_y * y + up);
  };
  const double x = kBlockHalfLength_m;
  part.surface.mesh.vertices = {corner(-x, y0, up0), corner(x, y0, up0), corner(x, y1, up1),
                                corner(-x, y1, up1)};
  part.surface.mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  part.surface.face_material.assign(2, 0);
  scene.structure.push_back(std::move(part));
}

void addGround(const StreetBlock& block, Scene& scene) {
  const Material asphalt{{84, 84, 88}, {70, 70, 74}, Pattern::kNoise, 0.05};
  const Material paving{{160, 158, 152}, {138, 136, 130}, Pattern::kTiles, 0.4};
  const Material lawn{{84, 124, 58}, {62, 98, 44}, Pattern::kLeaves, 0.3};
  const double w = kBlockHalfWidth_m;
  namespace id = campus_label;
  addStrip(block, -w, kKerb_m, -kPavement_m, kKerb_m, id::kGrass, lawn, scene);
  addStrip(block, -kPavement_m, kKerb_m, -kRoad_m, kKerb_m, id::kSidewalk, paving, scene);
  addStrip(block, -kRoad_m, kKerb_m, -kRoad_m, 0, id::kSidewalk, paving, scene);
  addStrip(block, -kRoad_m, 0, kRoad_m, 0, id::kRoad, asphalt, scene);
  addStrip(block, kRoad_m, 0, kRoad_m, kKerb_m, id::kSidewalk, paving, scene);
  addStrip(block, kRoad_m, kKerb_m, kPavement_m, kKerb_m, id::kSidewalk, paving, scene);
  addStrip(block, kPavement_m, kKerb_m, w, kKerb_m, id::kGrass, lawn, scene);
}

/// Fronts on either side, with gaps between houses.
void addHouses(Random random, Scene& scene) {
  StructurePart part{"houses", campus_label::kBuilding, {}, false, false};
  part.surface.materials = {{{178, 148, 128}, {150, 120, 100}, Pattern::kTiles, 0.5}};
  for (const double side : {-1.0, 1.0}) {
    double x = -kBlockHalfLength_m;
    while (x < kBlockHalfLength_m) {
      const double to = x + random.uniform(8, 20);
      const double front = side * (kHouses_m + random.uniform(0, 3));
      const double back = side * kBlockHalfWidth_m;
      appendBox({Vector3d(x, std::min(front, back), -6), Vector3d(to, std::max(front, back), 9)}, 0,
                part.surface);
      x = to + random.uniform(2, 14);
    }
  }
  scene.structure.push_back(std::move(part));
}

/// What stands where.
struct Kind {
  const char* class_name;
  Label label;
  int count;
};

/// A place to try and the way something looks there.
struct Spot {
  Vector2d place;
  double yaw = 0;
};

Spot spotFor(const std::string& class_name, const Aabb& box, Random& random) {
  const double side = random.chance(0.5) ? 1 : -1;
  const double x = random.uniform(-kBlockHalfLength_m + 3, kBlockHalfLength_m - 3);
  const double any = random.uniform(-kPi, kPi);
  const auto across = [&](double low, double high) {
    return Vector2d(x, side * random.uniform(low, high));
  };
  if (class_name == "car") {
    if (random.chance(0.6)) {  // at the kerb, along the street
      const double yaw = (random.chance(0.5) ? 0 : kPi) + 0.04 * random.normal();
      const double half_width = 0.5 * box.sizes().y();
      return {across(kRoad_m - half_width - 0.5, kRoad_m - half_width - 0.12), yaw};
    }
    return {across(kPavement_m + 1.5, kHouses_m - 2.5), any};
  }
  if (class_name == "bench") {
    const bool turned_away = random.chance(0.4);
    const double yaw = (turned_away ? side : -side) * 0.5 * kPi + 0.05 * random.normal();
    return {across(kRoad_m + 1, kHouses_m - 1), random.chance(0.6) ? yaw : any};
  }
  return {across(kRoad_m + 0.35, random.chance(0.6) ? kPavement_m : kHouses_m - 1), any};
}

class Filler {
 public:
  Filler(const StreetBlock& block, std::uint64_t seed, InstanceSplit split)
      : block_(block), seed_(seed), split_(split) {}

  void add(const std::vector<const ShapeFamily*>& families, Label label, Random random) {
    const ShapeFamily& family =
        *families[random.index(static_cast<std::uint32_t>(families.size()))];
    const std::uint64_t index = instanceIndex(hashSeed(seed_, kInstanceStream), drawn_++);
    const auto shape =
        std::make_shared<const ShapeInstance>(family.draw(Random(instanceSeed(split_, index))));
    const Aabb box = tightBounds(*shape->sdf);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const Spot spot = spotFor(family.class_name, box, random);
      const Transform pose = poseAt(spot, family.class_name == "car");
      Aabb around;
      for (int i = 0; i < 8; ++i) {
        around.extend(pose * box.corner(static_cast<Aabb::CornerType>(i)));
      }
      around.min().array() -= 0.5 * kGap_m;
      around.max().array() += 0.5 * kGap_m;
      if (std::any_of(taken_.begin(), taken_.end(),
                      [&](const Aabb& other) { return other.intersects(around); })) {
        continue;
      }
      taken_.push_back(around);
      placed_.push_back({shape, label, "", pose});
      return;
    }
  }
  const std::vector<PlacedShape>& placed() const { return placed_; }

 private:
  Transform poseAt(const Spot& spot, bool leans) const {
    const Vector3d place(spot.place.x(), spot.place.y(), block_.heightAt(spot.place));
    return leaningPose(place, spot.yaw,
                       leans ? Vector2d(block_.slope_x, block_.slope_y) : Vector2d::Zero());
  }

  const StreetBlock& block_;
  std::uint64_t seed_;
  InstanceSplit split_;
  std::uint64_t drawn_ = 0;
  std::vector<Aabb> taken_;
  std::vector<PlacedShape> placed_;
};

}  // namespace

double StreetBlock::heightAt(const Vector2d& place) const {
  return slope_x * place.x() + slope_y * place.y() + (std::abs(place.y()) > kRoad_m ? kKerb_m : 0);
}

StreetBlock makeStreetBlock(const StreetBlockConfig& config, std::uint64_t seed) {
  const Random random(seed);
  StreetBlock block;
  block.scene.label_space = campusLabelSpace();
  Random ground = random.fork(kGroundStream);
  const double incline = ground.uniform(-1, 1);
  block.slope_x = 0.1 * incline * std::abs(incline);  // most streets are nearly level
  block.slope_y = ground.uniform(-0.02, 0.02);
  addGround(block, block.scene);
  addHouses(ground, block.scene);

  namespace id = campus_label;
  const int quarter = config.unscored / 4;
  const std::array<Kind, 7> kinds = {{{"car", id::kCar, config.cars},
                                      {"bench", id::kBench, config.benches},
                                      {"fire_hydrant", id::kFireHydrant, config.hydrants},
                                      {"tree", id::kTree, quarter},
                                      {"pole", id::kLampPole, quarter},
                                      {"bollard", id::kBollard, quarter},
                                      {"sign", id::kSign, config.unscored - 3 * quarter}}};
  Filler filler(block, seed, config.split);
  std::uint64_t object = 0;
  for (const Kind& kind : kinds) {
    std::vector<const ShapeFamily*> families;
    for (const ShapeFamily& family : outdoorFamilies()) {
      if (family.class_name == kind.class_name) families.push_back(&family);
    }
    for (int i = 0; i < kind.count; ++i) {
      filler.add(families, kind.label, random.fork(kPlaceStream).fork(object++));
    }
  }
  appendShapes(filler.placed(), block.scene);
  return block;
}

}  // namespace hydrabench
