// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_primitives.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "eval/simulation/sdf_operators.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Aabb boxAround(const Vector3d& a, const Vector3d& b, double margin) {
  return {a.cwiseMin(b) - Vector3d::Constant(margin), a.cwiseMax(b) + Vector3d::Constant(margin)};
}

/// Distance to the corner region of two half-planes at distances (a, b) along orthogonal
/// directions.
double cornerDistance(double a, double b) {
  return std::min(std::max(a, b), 0.0) + std::hypot(std::max(a, 0.0), std::max(b, 0.0));
}

class Ellipsoid final : public Sdf {
 public:
  Ellipsoid(const Vector3d& center, const Vector3d& radii)
      : center_(center), radii_(radii), smallest_(radii.minCoeff()) {
    assert(smallest_ > 0);
  }

  double value(const Vector3d& world) const override {
    // Symmetric: the first octant is enough. A tiny positive floor keeps the equation below regular
    // on the symmetry planes.
    const Vector3d p = (world - center_).cwiseAbs().cwiseMax(1e-12 * smallest_);
    const Vector3d rp = radii_.cwiseProduct(p);
    const Vector3d gap =
        radii_.cwiseAbs2() - Vector3d::Constant(smallest_ * smallest_);  // of the squared radii
    // The nearest point is x_i = r_i^2 p_i / (s + gap_i) with sum (r_i p_i / (s + gap_i))^2 = 1.
    // The sum falls and is convex in s > 0; at the start one of its terms is 1, so Newton's steps
    // climb to the root and never pass it.
    double s = (rp - gap).maxCoeff();
    for (int iteration = 0; iteration < 40; ++iteration) {
      double excess = -1;
      double slope = 0;
      for (int i = 0; i < 3; ++i) {
        const double inverse = 1 / (s + gap[i]);
        const double term = rp[i] * inverse;
        excess += term * term;
        slope -= 2 * term * term * inverse;
      }
      const double step = -excess / slope;
      s += step;
      if (std::abs(step) <= 1e-13 * s) break;
    }
    double squared = 0;
    double level = -1;
    for (int i = 0; i < 3; ++i) {
      const double x = radii_[i] * rp[i] / (s + gap[i]);
      squared += (p[i] - x) * (p[i] - x);
      level += (p[i] / radii_[i]) * (p[i] / radii_[i]);
    }
    return level < 0 ? -std::sqrt(squared) : std::sqrt(squared);
  }
  Aabb bounds() const override { return {center_ - radii_, center_ + radii_}; }

 private:
  Vector3d center_;
  Vector3d radii_;
  double smallest_;
};

class RoundedBox final : public Sdf {
 public:
  RoundedBox(const Vector3d& center, const Vector3d& half, double rounding)
      : center_(center), half_(half), rounding_(rounding) {}
  double value(const Vector3d& p) const override {
    const Vector3d q = (p - center_).cwiseAbs() - half_ + Vector3d::Constant(rounding_);
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - rounding_;
  }
  Aabb bounds() const override { return {center_ - half_, center_ + half_}; }

 private:
  Vector3d center_;
  Vector3d half_;
  double rounding_;
};

class Capsule final : public Sdf {
 public:
  Capsule(const Vector3d& a, const Vector3d& b, double radius)
      : a_(a), ab_(b - a), squared_length_(ab_.squaredNorm()), radius_(radius) {}
  double value(const Vector3d& p) const override {
    const Vector3d ap = p - a_;
    const double t =
        squared_length_ > 0 ? std::clamp(ap.dot(ab_) / squared_length_, 0.0, 1.0) : 0.0;
    return (ap - t * ab_).norm() - radius_;
  }
  Aabb bounds() const override { return boxAround(a_, a_ + ab_, radius_); }

 private:
  Vector3d a_;
  Vector3d ab_;
  double squared_length_;
  double radius_;
};

class TaperedCapsule final : public Sdf {
 public:
  TaperedCapsule(const Vector3d& a, const Vector3d& b, double radius_a, double radius_b)
      : a_(a), b_(b), radius_a_(radius_a), radius_b_(radius_b) {
    const double length = (b - a).norm();
    assert(length > std::abs(radius_a - radius_b));
    axis_ = (b - a) / length;
    length_ = length;
    // The mantle is a cone that touches both spheres; sine of its half angle.
    sine_ = (radius_a - radius_b) / length;
    cosine_ = std::sqrt(1 - sine_ * sine_);
  }
  double value(const Vector3d& p) const override {
    const Vector3d ap = p - a_;
    const double along = ap.dot(axis_);
    const double across = (ap - along * axis_).norm();
    // Where the mantle's normal through the point meets the axis.
    const double foot = along - across * sine_ / cosine_;
    if (foot <= 0) return ap.norm() - radius_a_;
    if (foot >= length_) return (p - b_).norm() - radius_b_;
    return across * cosine_ + along * sine_ - radius_a_;
  }
  Aabb bounds() const override {
    Aabb box = boxAround(a_, a_, radius_a_);
    return box.extend(boxAround(b_, b_, radius_b_));
  }

 private:
  Vector3d a_;
  Vector3d b_;
  Vector3d axis_;
  double length_ = 0;
  double radius_a_;
  double radius_b_;
  double sine_ = 0;
  double cosine_ = 1;
};

class Cylinder final : public Sdf {
 public:
  Cylinder(const Vector3d& a, const Vector3d& b, double radius, double rounding)
      : center_(0.5 * (a + b)),
        axis_((b - a).normalized()),
        half_length_(0.5 * (b - a).norm()),
        radius_(radius),
        rounding_(rounding) {}
  double value(const Vector3d& p) const override {
    const Vector3d cp = p - center_;
    const double along = cp.dot(axis_);
    const double across = (cp - along * axis_).norm();
    return cornerDistance(across - radius_ + rounding_,
                          std::abs(along) - half_length_ + rounding_) -
           rounding_;
  }
  Aabb bounds() const override {
    const Vector3d disc =
        radius_ * (Vector3d::Ones() - axis_.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
    const Vector3d reach = half_length_ * axis_.cwiseAbs() + disc;
    return {center_ - reach, center_ + reach};
  }

 private:
  Vector3d center_;
  Vector3d axis_;
  double half_length_;
  double radius_;
  double rounding_;
};

class Torus final : public Sdf {
 public:
  Torus(const Vector3d& center, double ring_radius, double tube_radius)
      : center_(center), ring_radius_(ring_radius), tube_radius_(tube_radius) {}
  double value(const Vector3d& p) const override {
    const Vector3d q = p - center_;
    return std::hypot(std::hypot(q.x(), q.y()) - ring_radius_, q.z()) - tube_radius_;
  }
  Aabb bounds() const override {
    const double reach = ring_radius_ + tube_radius_;
    const Vector3d half(reach, reach, tube_radius_);
    return {center_ - half, center_ + half};
  }

 private:
  Vector3d center_;
  double ring_radius_;
  double tube_radius_;
};

class Extrusion final : public Sdf {
 public:
  Extrusion(SdfProfilePtr profile, Axis axis, double length, double rounding)
      : profile_(std::move(profile)),
        w_(static_cast<int>(axis)),
        u_(axis == Axis::kX ? 1 : 0),
        v_(axis == Axis::kZ ? 1 : 2),
        half_length_(0.5 * length),
        rounding_(rounding) {}
  double value(const Vector3d& p) const override {
    return cornerDistance(profile_->value({p[u_], p[v_]}) + rounding_,
                          std::abs(p[w_]) - half_length_ + rounding_) -
           rounding_;
  }
  Aabb bounds() const override {
    const Eigen::AlignedBox2d flat = profile_->bounds();
    Vector3d low;
    Vector3d high;
    low[u_] = flat.min().x();
    low[v_] = flat.min().y();
    low[w_] = -half_length_;
    high[u_] = flat.max().x();
    high[v_] = flat.max().y();
    high[w_] = half_length_;
    return {low, high};
  }

 private:
  SdfProfilePtr profile_;
  int w_;
  int u_;
  int v_;
  double half_length_;
  double rounding_;
};

class Revolution final : public Sdf {
 public:
  Revolution(SdfProfilePtr profile, double rounding)
      : profile_(std::move(profile)), rounding_(rounding) {}
  double value(const Vector3d& p) const override {
    return profile_->value({std::hypot(p.x(), p.y()), p.z()}) - rounding_;
  }
  Aabb bounds() const override {
    const Eigen::AlignedBox2d flat = profile_->bounds();
    const double reach = flat.max().x() + rounding_;
    return {Vector3d(-reach, -reach, flat.min().y() - rounding_),
            Vector3d(reach, reach, flat.max().y() + rounding_)};
  }

 private:
  SdfProfilePtr profile_;
  double rounding_;
};

}  // namespace

SdfPtr sphere(const Vector3d& center, double radius) {
  return std::make_shared<Capsule>(center, center, radius);
}

SdfPtr ellipsoid(const Vector3d& center, const Vector3d& radii) {
  return std::make_shared<Ellipsoid>(center, radii);
}

SdfPtr roundedBox(const Vector3d& center, const Vector3d& dimensions, double rounding) {
  assert(2 * rounding <= dimensions.minCoeff() + 1e-12);
  return std::make_shared<RoundedBox>(center, 0.5 * dimensions, rounding);
}

SdfPtr standingBox(const Vector3d& bottom_center, const Vector3d& dimensions, double rounding) {
  return roundedBox(bottom_center + Vector3d(0, 0, 0.5 * dimensions.z()), dimensions, rounding);
}

SdfPtr capsule(const Vector3d& a, const Vector3d& b, double radius) {
  return std::make_shared<Capsule>(a, b, radius);
}

SdfPtr taperedCapsule(const Vector3d& a, const Vector3d& b, double radius_a, double radius_b) {
  return std::make_shared<TaperedCapsule>(a, b, radius_a, radius_b);
}

SdfPtr cylinder(const Vector3d& a, const Vector3d& b, double radius, double rounding) {
  assert(rounding <= radius && 2 * rounding <= (b - a).norm() + 1e-12);
  return std::make_shared<Cylinder>(a, b, radius, rounding);
}

SdfPtr torus(const Vector3d& center, double ring_radius, double tube_radius) {
  return std::make_shared<Torus>(center, ring_radius, tube_radius);
}

SdfPtr extrusion(SdfProfilePtr profile, Axis axis, double length, double rounding) {
  assert(2 * rounding <= length);
  return std::make_shared<Extrusion>(std::move(profile), axis, length, rounding);
}

SdfPtr revolution(SdfProfilePtr profile, double rounding) {
  return std::make_shared<Revolution>(std::move(profile), rounding);
}

SdfPtr frustum(const Vector3d& bottom_center, double bottom_radius, double top_radius,
               double height, double rounding) {
  // The polygon reaches across the axis, so that the axis itself is no edge; its sides are moved in
  // by the rounding.
  const double slope = (top_radius - bottom_radius) / height;
  const double inset = rounding * std::sqrt(1 + slope * slope);
  const auto radiusAt = [&](double z) { return bottom_radius + slope * z - inset; };
  const double low = rounding;
  const double high = height - rounding;
  assert(radiusAt(low) > 0 && radiusAt(high) > 0 && high > low);
  return moved(revolution(polygonProfile({{-radiusAt(low), low},
                                          {radiusAt(low), low},
                                          {radiusAt(high), high},
                                          {-radiusAt(high), high}}),
                          rounding),
               bottom_center);
}

}  // namespace hydrabench
