// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "core/mapping/ground/patchwork.h"

namespace hydrabench {
namespace {

/// At 0.5 m, lines 2 degrees apart meet level ground at 1.9, 2.2, 2.6, 3.2, 4.1, 5.7, 9.5 and 28.6
/// m. Rings are so wide that each sees at least one of them: zones begin at 1, 8.4, 15.8 and 30.5
/// m. Where it is one line, the plane rests on the bend of the arc: sectors may not be narrow.
/// Height and flatness are asked of every ring, for a line across a wall is level, too. Heights of
/// seeds and of the plane as Patchwork has them for a VLP-16 on a robot of 0.6 m.
Patchwork::Config vlp16() {
  Patchwork::Config config;
  config.sensor = "vlp16";
  config.zones = {1, 60, {2, 1, 1, 1}, {24, 32, 32, 32}};
  config.adaptive.rings = 5;
  config.fit.seed_height_m = 0.2;
  config.fit.thickness_m = 0.075;
  return config;
}

struct Sensor {
  const char* name;
  Patchwork::Config (*config)();
};
constexpr Sensor kSensors[] = {
    {"hdl64", [] { return Patchwork::Config(); }},
    {"vlp16", vlp16},
};

}  // namespace

Patchwork::Config Patchwork::Config::forSensor(const std::string& sensor) {
  for (const Sensor& candidate : kSensors) {
    if (sensor == candidate.name) return candidate.config();
  }
  std::abort();
}

std::vector<std::string> Patchwork::Config::sensors() {
  std::vector<std::string> names;
  for (const Sensor& sensor : kSensors) names.emplace_back(sensor.name);
  return names;
}

void read(ConfigReader& reader, Patchwork::Config& config) {
  std::string sensor = config.sensor;
  reader.choice("sensor", sensor, Patchwork::Config::sensors());
  if (sensor != config.sensor) config = Patchwork::Config::forSensor(sensor);
  reader.field("min_points", config.min_points, Bounds{3, 1e6});
  reader.field("min_lines", config.min_lines, Bounds{1, 65536});
  auto reflection = reader.section("reflection");
  reflection.field("enabled", config.reflection.enabled);
  reflection.field("max_angle_deg", config.reflection.max_angle_deg, Bounds{-90, 90});
  reflection.field("max_intensity", config.reflection.max_intensity, Bounds{0, 1});
  reflection.field("below_ground_m", config.reflection.below_ground_m, Bounds{0, 100});
  auto zones = reader.section("zones");
  read(zones, config.zones);
  auto fit = reader.section("fit");
  read(fit, config.fit);
  auto adaptive = reader.section("adaptive");
  read(adaptive, config.adaptive);
  auto revert = reader.section("revert");
  read(revert, config.revert);
}

}  // namespace hydrabench
