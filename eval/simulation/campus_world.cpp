// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_world.h"

#include <cmath>
#include <numbers>

#include "eval/simulation/campus_buildings.h"
#include "eval/simulation/campus_ground.h"
#include "eval/simulation/campus_labels.h"
#include "eval/simulation/campus_objects.h"
#include "eval/simulation/campus_traffic.h"

namespace hydrabench {
namespace {

// Streams of the world's seed.
constexpr std::uint64_t kTerrainStream = 1;
constexpr std::uint64_t kObjectStream = 2;
constexpr std::uint64_t kBuildingStream = 3;
constexpr std::uint64_t kSunStream = 4;

Sun drawSun(Random random) {
  constexpr double kDegree = std::numbers::pi / 180;
  const double height = random.uniform(38, 55) * kDegree;
  const double azimuth = random.uniform(0, 2 * std::numbers::pi);
  Sun sun;
  sun.to_sun = {std::cos(height) * std::cos(azimuth), std::cos(height) * std::sin(azimuth),
                std::sin(height)};
  return sun;
}

}  // namespace

CampusConfig CampusConfig::quick() {
  CampusConfig config;
  config.world = "campus_quick";
  config.hydrants = 5;
  config.cars = 6;
  config.benches = 5;
  return config;
}

void read(ConfigReader& reader, CampusConfig& config) {
  reader.field("hydrants", config.hydrants, {0, 1000});
  reader.field("cars", config.cars, {0, 1000});
  reader.field("benches", config.benches, {0, 1000});
  ConfigReader movers = reader.section("movers");
  movers.field("cars", config.movers.cars, {0, kMaxMovingCars});
  movers.field("pedestrians", config.movers.pedestrians, {0, kMaxPedestrians});
}

CampusWay campusWay(const CampusConfig& config, const CampusTerrain& terrain) {
  if (config.world == "campus") return {0, terrain.loop().lengthAt(CampusWay::kOffset_m)};
  // From before the steps, past the eastern end of the terrace, over the hill.
  const double steps = 0.5 * (terrain.stairs().x_low + terrain.stairs().x_high);
  const double from = steps + terrain.loop().half_x_m - 9;
  return {from, from + 40};
}

CampusTerrain campusTerrain(std::uint64_t seed) {
  return CampusTerrain(Random(seed).fork(kTerrainStream));
}

CampusLayout layOutCampus(const CampusConfig& config, std::uint64_t seed) {
  CampusTerrain terrain = campusTerrain(seed);
  const CampusWay way = campusWay(config, terrain);
  std::vector<PlacedShape> objects =
      placeCampusObjects(config, terrain, way, hashSeed(seed, kObjectStream));
  return {std::move(terrain), way, std::move(objects)};
}

Scene makeCampus(const CampusConfig& config, std::uint64_t seed) {
  const CampusLayout layout = layOutCampus(config, seed);
  const Random random(seed);
  Scene scene;
  scene.label_space = campusLabelSpace();
  scene.sun = drawSun(random.fork(kSunStream));
  buildCampusGround(layout.terrain, scene);
  buildCampusBuildings(layout.terrain, random.fork(kBuildingStream), scene);
  appendShapes(layout.objects, scene);
  return scene;
}

}  // namespace hydrabench
