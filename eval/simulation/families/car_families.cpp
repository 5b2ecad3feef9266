// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/families/car_body.h"

namespace hydrabench {
namespace {

constexpr double kThinnest = 0.05;  ///< [m] spokes and the mirrors' arms
/// Panels bend over decimetres; a pitch as fine as furniture's would cost seconds.
constexpr double kCarPitch = 0.025;

Material carPaint(Parameters& parameters) {
  return plain(parameters.color({{226, 228, 228},
                                 {168, 172, 176},
                                 {56, 58, 64},
                                 {96, 100, 106},
                                 {158, 28, 32},
                                 {36, 70, 128},
                                 {46, 82, 68},
                                 {190, 170, 136},
                                 {206, 118, 38}}),
               0.7);
}

Material rimPaint(Parameters& parameters) {
  return plain(parameters.color({{178, 182, 186}, {120, 124, 128}, {62, 64, 68}}), 0.7);
}

/// What a body style fixes, as shares of the length from the front bumper.
struct Outline {
  double screen_foot;
  double screen_top;
  double roof_rear;
  double rear_foot;
};

/// Size with axles at usual places: front overhang a fifth of the length.
CarSize drawSize(Parameters& parameters, double length, double width, double height,
                 const Outline& outline) {
  const auto at = [&](double share) { return (0.5 - share) * length; };
  const double jitter = parameters.range(-0.008, 0.008);
  CarSize size{};
  size.length = length;
  size.width = width;
  size.height = height;
  size.clearance = parameters.range(0.17, 0.20);
  size.belt = height * parameters.range(0.635, 0.665);
  size.nose = size.belt * parameters.range(0.76, 0.81);
  size.deck = size.belt + 0.02;
  size.wheel = parameters.range(0.300, 0.335);
  size.front_axle = at(parameters.range(0.185, 0.205));
  size.rear_axle = at(parameters.range(0.81, 0.83));
  size.screen_foot = at(outline.screen_foot + jitter);
  size.screen_top = at(outline.screen_top + jitter + parameters.range(-0.01, 0.01));
  size.roof_rear = at(outline.roof_rear + parameters.range(-0.012, 0.012));
  size.rear_foot = at(outline.rear_foot + parameters.range(-0.006, 0.006));
  size.tumblehome = parameters.range(0.13, 0.18);
  return size;
}

/// Everything that all body styles share.
struct Fittings {
  std::vector<double> pillars;  ///< x of the uprights between panes
  double last_pane_to = -10;    ///< x where the sides' glass ends
  bool rear_window = true;
  TailLights tail_lights = TailLights::kTall;
};

void addCar(Parameters& parameters, const CarSize& size, const CarBody& body, const Material& paint,
            const Fittings& fittings, InstanceBuilder& builder) {
  builder.add({body.tub, body.cabin}, paint);
  addSidePanes(size, body, fittings.pillars, fittings.last_pane_to, builder);
  addScreens(size, body, fittings.rear_window, builder);
  addTrim(size, body, fittings.tail_lights, builder);
  std::vector<double> handles;
  for (const double pillar : fittings.pillars) handles.push_back(pillar + 0.14);
  const Material mirrors = parameters.chance(0.6) ? paint : blackPlastic();
  addMirrorsAndHandles(size, body, mirrors, handles, builder);
  const int spokes = parameters.count(5, 7);
  addWheels(size, spokes, rimPaint(parameters), builder);
}

ShapeInstance finishCar(InstanceBuilder& builder) {
  ShapeInstance car = builder.finish(kThinnest);
  car.max_pitch_m = kCarPitch;
  return car;
}

/// x of the upright between front and rear doors.
double middlePillar(const CarSize& size) { return 0.5 * (size.screen_top + size.roof_rear) + 0.05; }

ShapeInstance buildHatchback(Parameters& parameters) {
  InstanceBuilder builder("car_hatchback");
  const double length = parameters.range(3.62, 4.32);
  const double width = parameters.range(1.66, 1.80);
  const double height = parameters.range(1.43, 1.55);
  const CarSize size = drawSize(parameters, length, width, height, {0.255, 0.43, 0.86, 0.965});
  addCar(parameters, size, carBody(size), carPaint(parameters), {{middlePillar(size)}}, builder);
  return finishCar(builder);
}

ShapeInstance buildSedan(Parameters& parameters) {
  InstanceBuilder builder("car_sedan");
  const double length = parameters.range(4.35, 4.98);
  const double width = parameters.range(1.76, 1.88);
  const double height = parameters.range(1.41, 1.49);
  CarSize size = drawSize(parameters, length, width, height, {0.28, 0.425, 0.705, 0.845});
  size.deck = size.belt + parameters.range(0.03, 0.07);
  size.rear_axle = (0.5 - parameters.range(0.78, 0.80)) * length;
  Fittings fittings{{middlePillar(size)}};
  fittings.tail_lights = TailLights::kWide;
  addCar(parameters, size, carBody(size), carPaint(parameters), fittings, builder);
  return finishCar(builder);
}

ShapeInstance buildEstate(Parameters& parameters) {
  InstanceBuilder builder("car_estate");
  const double length = parameters.range(4.42, 4.95);
  const double width = parameters.range(1.76, 1.88);
  const double height = parameters.range(1.45, 1.56);
  CarSize size = drawSize(parameters, length, width, height, {0.27, 0.415, 0.90, 0.975});
  size.rear_axle = (0.5 - parameters.range(0.785, 0.805)) * length;
  const double first = size.screen_top - 0.26 * length;
  const CarBody body = carBody(size);
  addCar(parameters, size, body, carPaint(parameters), {{first + 0.05, first - 0.20 * length}},
         builder);
  if (parameters.chance(0.7)) {  // rails along the roof
    const double y = 0.5 * size.width - size.tumblehome - 0.12;
    const double front = size.screen_top - 0.15;
    const double rear = size.roof_rear + 0.25;
    std::vector<SdfPtr> rails;
    for (const double s : {-1.0, 1.0}) {
      const auto onRoof = [&](double x) {
        return surfacePoint(*body.cabin, {x, s * y, height + 1}, {0, 0, -1});
      };
      std::vector<Eigen::Vector3d> points;
      for (int i = 0; i <= 4; ++i) points.push_back(onRoof(front + 0.25 * i * (rear - front)));
      for (Eigen::Vector3d& point : points) point.z() += 0.02;
      rails.push_back(tube(points, std::vector<double>(points.size(), 0.028)));
    }
    builder.add(rails, metal(parameters));
  }
  return finishCar(builder);
}

/// With panes all around, or closed behind the doors.
ShapeInstance buildVan(Parameters& parameters) {
  InstanceBuilder builder("car_van");
  const double length = parameters.range(4.35, 5.25);
  const double width = parameters.range(1.82, 1.98);
  const double height = parameters.range(1.84, 2.06);
  CarSize size = drawSize(parameters, length, width, height, {0.165, 0.285, 0.965, 0.988});
  size.belt = height * parameters.range(0.55, 0.58);
  size.nose = size.belt * parameters.range(0.80, 0.86);
  size.deck = size.belt + 0.02;
  size.tumblehome = parameters.range(0.09, 0.13);
  const double first = size.screen_top - 0.17 * length;
  Fittings fittings;
  if (parameters.chance(0.55)) {
    fittings.pillars = {first, first - 0.27 * length};
  } else {
    fittings.pillars = {first};
    fittings.last_pane_to = first;  // no glass behind the driver's door
    fittings.rear_window = parameters.chance(0.5);
  }
  const Material paint =
      parameters.chance(0.5) ? plain({230, 231, 230}, 0.6) : carPaint(parameters);
  addCar(parameters, size, carBody(size), paint, fittings, builder);
  return finishCar(builder);
}

/// Double cab and an open bed.
ShapeInstance buildPickup(Parameters& parameters) {
  InstanceBuilder builder("car_pickup");
  const double length = parameters.range(4.95, 5.32);
  const double width = parameters.range(1.84, 1.98);
  const double height = parameters.range(1.74, 1.86);
  CarSize size = drawSize(parameters, length, width, height, {0.27, 0.375, 0.605, 0.64});
  size.clearance = parameters.range(0.24, 0.28);
  size.wheel = parameters.range(0.365, 0.395);
  size.nose = size.belt * parameters.range(0.86, 0.90);
  size.rear_axle = (0.5 - parameters.range(0.78, 0.80)) * length;
  CarBody body = carBody(size);
  const double rear = -0.5 * length + 0.09;
  const double front = size.rear_foot - 0.10;
  const double floor = 2 * size.wheel + 0.055 + 0.05;  // above the wheel arches
  // Corners as round as the body's, less the wall.
  const SdfPtr bed = moved(
      extrusion(rectangleProfile({0, 0}, {front - rear, width - 0.24}, 0.34), Axis::kZ, 1.0, 0.03),
      {0.5 * (rear + front), 0, floor + 0.5});
  body.tub = subtract(body.tub, bed);
  Fittings fittings{{middlePillar(size)}};
  fittings.tail_lights = TailLights::kSlim;
  addCar(parameters, size, body, carPaint(parameters), fittings, builder);
  return finishCar(builder);
}

}  // namespace

std::vector<ShapeFamily> carFamilies() {
  return {makeFamily<buildHatchback>("car_hatchback", "car"),
          makeFamily<buildSedan>("car_sedan", "car"), makeFamily<buildEstate>("car_estate", "car"),
          makeFamily<buildVan>("car_van", "car"), makeFamily<buildPickup>("car_pickup", "car")};
}

}  // namespace hydrabench
