// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {

/// Proportions of a car, as a side view gives them. Lengths in metres, object frame: x to the
/// front, origin midway between the bumpers, z from the road.
struct CarSize {
  double length;
  double width;   ///< without mirrors
  double height;  ///< of the roof
  double clearance;
  double belt;         ///< height of the lower edge of the windows
  double nose;         ///< height of the bonnet's front edge
  double deck;         ///< height of the body at the tail
  double wheel;        ///< radius
  double front_axle;   ///< x
  double rear_axle;    ///< x
  double screen_foot;  ///< x of the windscreen's lower edge, at the belt
  double screen_top;   ///< x of its upper edge
  double roof_rear;    ///< x of the rear window's upper edge
  double rear_foot;    ///< x of its lower edge, at the belt
  double tumblehome;   ///< how far each side leans in from the belt to the roof
};

/// What is painted, before wheels and windows are cut or laid on.
struct CarBody {
  SdfPtr tub;    ///< everything below the belt, with wheel arches
  SdfPtr cabin;  ///< above it; reaches down into the tub
};
CarBody carBody(const CarSize& size);

/// Where a ray from outside meets a shape.
Eigen::Vector3d surfacePoint(const Sdf& sdf, Eigen::Vector3d p, const Eigen::Vector3d& direction);

/// Panes of the sides between pillars, all along the cabin.
/// @param pillars  x of the middle of each upright between two panes, from the front
/// @param last_pane_to  x where glass ends towards the rear; the rear window's slope if lower
void addSidePanes(const CarSize& size, const CarBody& body, const std::vector<double>& pillars,
                  double last_pane_to, InstanceBuilder& builder);
/// Windscreen, and the rear window if there is one.
void addScreens(const CarSize& size, const CarBody& body, bool rear, InstanceBuilder& builder);
/// Tyres on rims with `spokes` spokes, axles into the body.
void addWheels(const CarSize& size, int spokes, const Material& rim, InstanceBuilder& builder);
/// Head and tail lights, grille, sills, wheel housings, number plates.
enum class TailLights { kWide, kTall, kSlim };  ///< beside a boot lid, a tailgate, an open bed
void addTrim(const CarSize& size, const CarBody& body, TailLights tail_lights,
             InstanceBuilder& builder);
/// Mirrors and a handle behind every pane.
void addMirrorsAndHandles(const CarSize& size, const CarBody& body, const Material& paint,
                          const std::vector<double>& handles, InstanceBuilder& builder);

}  // namespace hydrabench
