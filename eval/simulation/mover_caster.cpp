// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/mover_caster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Between two poses a part that turns is a little off the straight line.
constexpr double kSphereMargin_m = 0.03;

/// In floats, from the world to a part.
struct IntoPart {
  explicit IntoPart(const Transform& T_world_part)
      : R_part_world(T_world_part.linear().transpose().cast<float>()),
        origin(T_world_part.translation().cast<float>()) {}
  Vector3f point(const Vector3f& p) const { return R_part_world * (p - origin); }
  Vector3f direction(const Vector3f& d) const { return R_part_world * d; }
  Vector3f toWorld(const Vector3f& d) const { return R_part_world.transpose() * d; }

  Eigen::Matrix3f R_part_world;
  Vector3f origin;
};

/// A cone around many rays, from anywhere in a sphere around their origins.
class RayBundle {
 public:
  explicit RayBundle(std::span<const Raycaster::Ray> rays) {
    Vector3f sum = Vector3f::Zero();
    for (const Raycaster::Ray& ray : rays) {
      origin_ += ray.origin / static_cast<float>(rays.size());
      sum += ray.direction.normalized();
    }
    if (sum.norm() < 1e-3f) return;  // to all sides
    axis_ = sum.normalized();
    float cosine = 1;
    for (const Raycaster::Ray& ray : rays) {
      spread_ = std::max(spread_, (ray.origin - origin_).norm());
      cosine = std::min(cosine, axis_.dot(ray.direction.normalized()));
    }
    half_angle_ = std::acos(cosine) + kAngleMargin;
  }
  bool mayMeet(const Vector3f& center, float radius) const {
    const Vector3f to_center = center - origin_;
    const float distance = to_center.norm();
    const float reach = radius + spread_;
    if (half_angle_ >= kAllAround || distance <= reach) return true;
    const float angle = std::acos(std::clamp(axis_.dot(to_center) / distance, -1.0f, 1.0f));
    return angle <= half_angle_ + std::asin(reach / distance);
  }

 private:
  static constexpr float kAllAround = std::numbers::pi_v<float>;
  static constexpr float kAngleMargin = 1e-3f;  // rounding of the arc cosine of almost 1

  Vector3f origin_ = Vector3f::Zero();
  float spread_ = 0;
  Vector3f axis_ = Vector3f::UnitX();
  float half_angle_ = kAllAround;
};

/// As the translation of poseAt().
std::optional<Vector3f> originAt(std::span<const TimedPose> poses, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(
      poses.begin(), poses.end(), stamp_ns,
      [](const TimedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.end() || (after == poses.begin() && after->stamp_ns > stamp_ns)) return {};
  const Vector3d to = after->T_world_body.translation();
  if (after->stamp_ns == stamp_ns) return to.cast<float>();
  const auto before = after - 1;
  const double share = static_cast<double>(stamp_ns - before->stamp_ns) /
                       static_cast<double>(after->stamp_ns - before->stamp_ns);
  const Vector3d from = before->T_world_body.translation();
  return Vector3d(from + share * (to - from)).cast<float>();
}

bool meets(const Raycaster::Ray& ray, const Vector3f& center, float radius) {
  const Vector3f to_center = center - ray.origin;
  const float along = to_center.dot(ray.direction) / ray.direction.squaredNorm();
  const float nearest = std::max(along, 0.0f);
  return (to_center - nearest * ray.direction).squaredNorm() <= radius * radius;
}

/// How far the parts reach from the origin of the first one, at any time.
double reachOf(const Mover& mover) {
  double reach = 0;
  for (const Mover::Part& part : mover.parts) {
    const Aabb box = bounds(part.surface->mesh);
    const double radius = 0.5 * box.diagonal().norm();
    for (const TimedPose& pose : part.poses) {
      const std::optional<Transform> first = poseAt(mover.parts.front().poses, pose.stamp_ns);
      if (!first) continue;
      const Vector3d center = pose.T_world_body * box.center();
      reach = std::max(reach, (center - first->translation()).norm() + radius);
    }
  }
  return reach;
}

}  // namespace

MoverCaster::MoverCaster(std::span<const Mover> movers) {
  for (const Mover& mover : movers) {
    Extent extent;
    extent.first_part = parts_.size();
    extent.radius = static_cast<float>(reachOf(mover) + kSphereMargin_m);
    for (const Mover::Part& part : mover.parts) {
      Raycaster caster;
      caster.add(part.surface->mesh);
      caster.commit();
      parts_.push_back({movers_.size(), part.poses, std::move(caster),
                        DrawnMesh(*part.surface, Transform::Identity(), mover.label, false)});
    }
    extent.end_part = parts_.size();
    movers_.push_back(extent);
  }
}

template <typename Body>
void MoverCaster::forPartsNear(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                               const Body& body) const {
  const RayBundle bundle(rays);
  std::vector<std::size_t> chosen;
  std::vector<Raycaster::Ray> carried;
  for (const Extent& mover : movers_) {
    const std::optional<Vector3f> center = originAt(parts_[mover.first_part].poses, stamp_ns);
    if (!center || !bundle.mayMeet(*center, mover.radius)) continue;
    chosen.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (meets(rays[i], *center, mover.radius)) chosen.push_back(i);
    }
    if (chosen.empty()) continue;
    for (std::size_t index = mover.first_part; index < mover.end_part; ++index) {
      const std::optional<Transform> pose = poseAt(parts_[index].poses, stamp_ns);
      if (!pose) continue;
      const IntoPart into(*pose);
      carried.clear();
      for (const std::size_t i : chosen) {
        carried.push_back({into.point(rays[i].origin), into.direction(rays[i].direction),
                           rays[i].min_distance, rays[i].max_distance});
      }
      body(index, std::span<const std::size_t>(chosen), std::span<const Raycaster::Ray>(carried));
    }
  }
}

void MoverCaster::intersect(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                            std::uint32_t first_mesh, std::span<Raycaster::Hit> hits) const {
  assert(hits.size() == rays.size());
  std::vector<Raycaster::Hit> found;
  forPartsNear(stamp_ns, rays, [&](std::size_t part, const auto& chosen, const auto& carried) {
    found.resize(carried.size());
    parts_[part].caster.intersect(carried, found);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      Raycaster::Hit& hit = hits[chosen[k]];
      if (!found[k] || !(found[k].distance < hit.distance)) continue;
      hit = found[k];
      hit.mesh = first_mesh + static_cast<std::uint32_t>(part);
    }
  });
}

void MoverCaster::occluded(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                           std::span<std::uint8_t> blocked) const {
  assert(blocked.size() == rays.size());
  std::vector<std::uint8_t> found;
  forPartsNear(stamp_ns, rays, [&](std::size_t part, const auto& chosen, const auto& carried) {
    found.resize(carried.size());
    parts_[part].caster.occluded(carried, found);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (found[k]) blocked[chosen[k]] = 1;
    }
  });
}

DrawnMesh::SurfaceSample MoverCaster::sample(std::int64_t stamp_ns, std::size_t part,
                                             const Raycaster::Hit& hit, const Vector3f& point,
                                             const Vector3f& direction) const {
  const IntoPart into(*poseAt(parts_[part].poses, stamp_ns));
  DrawnMesh::SurfaceSample sample =
      parts_[part].drawn.sample(hit, into.point(point), into.direction(direction));
  sample.normal = into.toWorld(sample.normal);
  sample.face_normal = into.toWorld(sample.face_normal);
  return sample;
}

Vector3f MoverCaster::faceNormal(std::int64_t stamp_ns, std::size_t part,
                                 std::uint32_t face) const {
  return IntoPart(*poseAt(parts_[part].poses, stamp_ns))
      .toWorld(parts_[part].drawn.faceNormal(face));
}

}  // namespace hydrabench
