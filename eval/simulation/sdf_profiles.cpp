// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_profiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hydrabench {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

double squaredDistanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const Vector2d ap = p - a;
  const double t = std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (ap - t * ab).squaredNorm();
}

AlignedBox2d boxAround(const Polyline& points, double margin) {
  AlignedBox2d box;
  for (const Vector2d& point : points) box.extend(point);
  return {box.min() - Vector2d::Constant(margin), box.max() + Vector2d::Constant(margin)};
}

class Circle final : public SdfProfile {
 public:
  Circle(const Vector2d& center, double radius) : center_(center), radius_(radius) {}
  double value(const Vector2d& p) const override { return (p - center_).norm() - radius_; }
  AlignedBox2d bounds() const override { return boxAround({center_}, radius_); }

 private:
  Vector2d center_;
  double radius_;
};

class Rectangle final : public SdfProfile {
 public:
  Rectangle(const Vector2d& center, const Vector2d& dimensions, double rounding)
      : center_(center), half_(0.5 * dimensions), rounding_(rounding) {}
  double value(const Vector2d& p) const override {
    const Vector2d q = (p - center_).cwiseAbs() - half_ + Vector2d::Constant(rounding_);
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - rounding_;
  }
  AlignedBox2d bounds() const override { return {center_ - half_, center_ + half_}; }

 private:
  Vector2d center_;
  Vector2d half_;
  double rounding_;
};

class Polygon final : public SdfProfile {
 public:
  explicit Polygon(Polyline corners) : corners_(std::move(corners)) { assert(corners_.size() > 2); }
  double value(const Vector2d& p) const override {
    double squared = std::numeric_limits<double>::infinity();
    bool inside = false;  // even-odd rule
    for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
      const Vector2d& a = corners_[i];
      const Vector2d& b = corners_[j];
      squared = std::min(squared, squaredDistanceToSegment(p, a, b));
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
        inside = !inside;
      }
    }
    return inside ? -std::sqrt(squared) : std::sqrt(squared);
  }
  AlignedBox2d bounds() const override { return boxAround(corners_, 0); }

 private:
  Polyline corners_;
};

class Convex final : public SdfProfile {
 public:
  explicit Convex(const Polyline& corners) : bounds_(boxAround(corners, 0)) {
    assert(corners.size() > 2);
    const Vector2d center = std::accumulate(corners.begin(), corners.end(), Vector2d(0, 0)) /
                            static_cast<double>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2d& a = corners[i];
      const Vector2d along = (corners[(i + 1) % corners.size()] - a).normalized();
      Vector2d normal(along.y(), -along.x());
      if (normal.dot(center - a) > 0) normal = -normal;
      assert(normal.dot(corners[(i + 2) % corners.size()] - a) < 1e-12);
      sides_.push_back({normal, normal.dot(a)});
    }
  }
  double value(const Vector2d& p) const override {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Side& side : sides_) {
      largest = std::max(largest, side.normal.dot(p) - side.offset);
    }
    return largest;
  }
  AlignedBox2d bounds() const override { return bounds_; }

 private:
  struct Side {
    Vector2d normal;  ///< outward
    double offset;
  };
  std::vector<Side> sides_;
  AlignedBox2d bounds_;
};

class Stroke final : public SdfProfile {
 public:
  Stroke(Polyline points, double half_width) : points_(std::move(points)), half_width_(half_width) {
    assert(points_.size() > 1);
  }
  double value(const Vector2d& p) const override {
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points_.size(); ++i) {
      squared = std::min(squared, squaredDistanceToSegment(p, points_[i - 1], points_[i]));
    }
    return std::sqrt(squared) - half_width_;
  }
  AlignedBox2d bounds() const override { return boxAround(points_, half_width_); }

 private:
  Polyline points_;
  double half_width_;
};

}  // namespace

SdfProfilePtr circleProfile(const Vector2d& center, double radius) {
  return std::make_shared<Circle>(center, radius);
}

SdfProfilePtr rectangleProfile(const Vector2d& center, const Vector2d& dimensions,
                               double rounding) {
  assert(2 * rounding <= dimensions.minCoeff());
  return std::make_shared<Rectangle>(center, dimensions, rounding);
}

SdfProfilePtr polygonProfile(Polyline corners) {
  return std::make_shared<Polygon>(std::move(corners));
}

SdfProfilePtr convexProfile(const Polyline& corners) { return std::make_shared<Convex>(corners); }

SdfProfilePtr strokeProfile(Polyline points, double half_width) {
  return std::make_shared<Stroke>(std::move(points), half_width);
}

Polyline smoothCurve(const Polyline& points, int steps) {
  assert(points.size() > 1 && steps > 0);
  Polyline curve;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector2d& p1 = points[i];
    const Vector2d& p2 = points[i + 1];
    const Vector2d p0 = i > 0 ? points[i - 1] : Vector2d(2 * p1 - p2);
    const Vector2d p3 = i + 2 < points.size() ? points[i + 2] : Vector2d(2 * p2 - p1);
    for (int s = 0; s < steps; ++s) {
      const double t = static_cast<double>(s) / steps;
      curve.push_back(0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                             t * t * t * (3 * p1 - p0 - 3 * p2 + p3)));
    }
  }
  curve.push_back(points.back());
  return curve;
}

}  // namespace hydrabench
