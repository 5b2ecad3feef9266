// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_operators.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "eval/simulation/sdf_primitives.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

class Union final : public Sdf {
 public:
  explicit Union(std::vector<SdfPtr> children) : children_(std::move(children)) {
    assert(!children_.empty());
    for (const SdfPtr& child : children_) {
      boxes_.push_back(child->bounds());
      box_.extend(boxes_.back());
    }
  }
  double value(const Vector3d& p) const override {
    // Outside its box a child counts with the larger of its value and the distance to the box, both
    // lower bounds of the true distance: so skipping by the box changes nothing, even where a
    // child's own value is a loose bound.
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < children_.size(); ++i) {
      const double squared_to_box = boxes_[i].squaredExteriorDistance(p);
      if (squared_to_box <= 0) {
        best = std::min(best, children_[i]->value(p));
      } else if (best > 0 && squared_to_box < best * best) {
        best = std::min(best, std::max(std::sqrt(squared_to_box), children_[i]->value(p)));
      }
    }
    return best;
  }
  Aabb bounds() const override { return box_; }
  void collectMembers(std::vector<const Sdf*>& members) const override {
    for (const SdfPtr& child : children_) child->collectMembers(members);
  }

 private:
  std::vector<SdfPtr> children_;
  std::vector<Aabb> boxes_;
  Aabb box_;
};

class SmoothUnion final : public Sdf {
 public:
  SmoothUnion(SdfPtr a, SdfPtr b, double blend)
      : a_(std::move(a)), b_(std::move(b)), blend_(blend) {}
  double value(const Vector3d& p) const override {
    const double a = a_->value(p);
    const double b = b_->value(p);
    const double overlap = std::max(blend_ - std::abs(a - b), 0.0);
    return std::min(a, b) - overlap * overlap / (4 * blend_);
  }
  Aabb bounds() const override {
    const Aabb box = a_->bounds().merged(b_->bounds());
    const Vector3d margin = Vector3d::Constant(0.25 * blend_);
    return {box.min() - margin, box.max() + margin};
  }

 private:
  SdfPtr a_;
  SdfPtr b_;
  double blend_;
};

class Intersection final : public Sdf {
 public:
  Intersection(SdfPtr a, SdfPtr b) : a_(std::move(a)), b_(std::move(b)) {}
  double value(const Vector3d& p) const override { return std::max(a_->value(p), b_->value(p)); }
  Aabb bounds() const override { return a_->bounds().intersection(b_->bounds()); }

 private:
  SdfPtr a_;
  SdfPtr b_;
};

class SmoothIntersection final : public Sdf {
 public:
  SmoothIntersection(SdfPtr a, SdfPtr b, double blend)
      : a_(std::move(a)), b_(std::move(b)), blend_(blend) {}
  double value(const Vector3d& p) const override {
    const double a = a_->value(p);
    const double b = b_->value(p);
    const double overlap = std::max(blend_ - std::abs(a - b), 0.0);
    return std::max(a, b) + overlap * overlap / (4 * blend_);
  }
  Aabb bounds() const override { return a_->bounds().intersection(b_->bounds()); }

 private:
  SdfPtr a_;
  SdfPtr b_;
  double blend_;
};

class Difference final : public Sdf {
 public:
  Difference(SdfPtr from, SdfPtr what) : from_(std::move(from)), what_(std::move(what)) {}
  double value(const Vector3d& p) const override {
    return std::max(from_->value(p), -what_->value(p));
  }
  Aabb bounds() const override { return from_->bounds(); }

 private:
  SdfPtr from_;
  SdfPtr what_;
};

class Shell final : public Sdf {
 public:
  Shell(SdfPtr shape, double thickness)
      : shape_(std::move(shape)), half_thickness_(0.5 * thickness) {}
  double value(const Vector3d& p) const override {
    return std::abs(shape_->value(p) + half_thickness_) - half_thickness_;
  }
  Aabb bounds() const override { return shape_->bounds(); }

 private:
  SdfPtr shape_;
  double half_thickness_;
};

class Inflated final : public Sdf {
 public:
  Inflated(SdfPtr shape, double distance) : shape_(std::move(shape)), distance_(distance) {}
  double value(const Vector3d& p) const override { return shape_->value(p) - distance_; }
  Aabb bounds() const override {
    const Aabb box = shape_->bounds();
    const Vector3d margin = Vector3d::Constant(distance_);
    return {box.min() - margin, box.max() + margin};
  }

 private:
  SdfPtr shape_;
  double distance_;
};

class Placed final : public Sdf {
 public:
  Placed(const Transform& T_parent_child, SdfPtr child)
      : T_child_parent_(T_parent_child.inverse()), child_(std::move(child)) {
    const Aabb box = child_->bounds();
    for (int corner = 0; corner < 8; ++corner) {
      box_.extend(T_parent_child * box.corner(static_cast<Aabb::CornerType>(corner)));
    }
  }
  double value(const Vector3d& p) const override { return child_->value(T_child_parent_ * p); }
  Aabb bounds() const override { return box_; }

 private:
  Transform T_child_parent_;
  SdfPtr child_;
  Aabb box_;
};

}  // namespace

Vector3d sdfNormal(const Sdf& sdf, const Vector3d& p) {
  constexpr double kStep =
      1e-5;  // [m], small against every rounding, large against double's rounding
  Vector3d gradient;
  for (int i = 0; i < 3; ++i) {
    const Vector3d step = kStep * Vector3d::Unit(i);
    gradient[i] = sdf.value(p + step) - sdf.value(p - step);
  }
  const double length = gradient.norm();
  return length > 0 ? Vector3d(gradient / length) : Vector3d::UnitZ();
}

SdfPtr unite(std::vector<SdfPtr> children) { return std::make_shared<Union>(std::move(children)); }

SdfPtr smoothUnion(SdfPtr a, SdfPtr b, double blend) {
  assert(blend > 0);
  return std::make_shared<SmoothUnion>(std::move(a), std::move(b), blend);
}

SdfPtr intersect(SdfPtr a, SdfPtr b) {
  return std::make_shared<Intersection>(std::move(a), std::move(b));
}

SdfPtr smoothIntersection(SdfPtr a, SdfPtr b, double blend) {
  assert(blend > 0);
  return std::make_shared<SmoothIntersection>(std::move(a), std::move(b), blend);
}

SdfPtr subtract(SdfPtr from, SdfPtr what) {
  return std::make_shared<Difference>(std::move(from), std::move(what));
}

SdfPtr shell(SdfPtr shape, double thickness) {
  return std::make_shared<Shell>(std::move(shape), thickness);
}

SdfPtr inflated(SdfPtr shape, double distance) {
  return std::make_shared<Inflated>(std::move(shape), distance);
}

SdfPtr placed(const Transform& T_parent_child, SdfPtr child) {
  return std::make_shared<Placed>(T_parent_child, std::move(child));
}

SdfPtr moved(SdfPtr child, const Vector3d& translation) {
  return placed(Transform(Eigen::Translation3d(translation)), std::move(child));
}

SdfPtr turned(SdfPtr child, const Vector3d& axis, double angle_rad, const Vector3d& translation) {
  return placed(Transform(Eigen::Translation3d(translation) *
                          Eigen::AngleAxisd(angle_rad, axis.normalized())),
                std::move(child));
}

SdfPtr tube(const std::vector<Vector3d>& points, const std::vector<double>& radii) {
  assert(points.size() > 1 && points.size() == radii.size());
  std::vector<SdfPtr> pieces;
  for (std::size_t i = 1; i < points.size(); ++i) {
    pieces.push_back(taperedCapsule(points[i - 1], points[i], radii[i - 1], radii[i]));
  }
  return unite(std::move(pieces));
}

}  // namespace hydrabench
