// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "eval/simulation/sdf.h"
#include "eval/simulation/sdf_profiles.h"

namespace hydrabench {

/// Primitives. All distances are exact, inside and outside. Rounding is the radius of the edges
/// [m]; it lies within the dimensions.

SdfPtr sphere(const Eigen::Vector3d& center, double radius);
/// By Newton's method on the Lagrange multiplier of the nearest point (Eberly, "Distance from a
/// point to an ellipse or ellipsoid").
SdfPtr ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii);
SdfPtr roundedBox(const Eigen::Vector3d& center, const Eigen::Vector3d& dimensions,
                  double rounding);
/// Box that stands on z: `center` is the centre of its lower face.
SdfPtr standingBox(const Eigen::Vector3d& bottom_center, const Eigen::Vector3d& dimensions,
                   double rounding);
SdfPtr capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius);
/// Convex hull of two spheres; neither may contain the other.
SdfPtr taperedCapsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_a,
                      double radius_b);
SdfPtr cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, double rounding);
/// Ring around the z direction.
SdfPtr torus(const Eigen::Vector3d& center, double ring_radius, double tube_radius);

/// A profile drawn along an axis, centred on 0. Profile coordinates are the other two axes in
/// order: (y, z), (x, z) or (x, y).
enum class Axis { kX, kY, kZ };
SdfPtr extrusion(SdfProfilePtr profile, Axis axis, double length, double rounding);
/// A profile (distance from the z axis, z) turned around the z axis.
SdfPtr revolution(SdfProfilePtr profile, double rounding = 0);

/// Frustum around z with flat ends.
SdfPtr frustum(const Eigen::Vector3d& bottom_center, double bottom_radius, double top_radius,
               double height, double rounding);

}  // namespace hydrabench
