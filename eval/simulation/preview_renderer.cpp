// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/preview_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/geometry/raycaster.h"
#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/simulation/smooth_normals.h"

namespace hydrabench {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kOffset = 2e-4f;  ///< [m], start of secondary rays off the surface
constexpr float kSunStrength = 0.80f;
constexpr float kSkyStrength = 0.62f;
constexpr float kBounce = 0.30f;  ///< light that comes from nearby surfaces instead of the sky

/// Where a camera ray ends.
struct Sample {
  Vector3f point = Vector3f::Zero();
  Vector3f normal = Vector3f::UnitZ();
  Vector3f to_viewer = Vector3f::UnitZ();
  Vector3f reflectance = Vector3f::Zero();
  float gloss = 0;
  bool floor = false;
  bool nothing = true;
};

struct Drawn {
  const PreviewObject* object;
  std::vector<Vector3f> normals;  ///< three per face, mesh frame
};

/// Points of a low-discrepancy sequence on the unit square (Roberts' R2), shifted for every sample
/// of the picture.
Vector2f squarePoint(std::uint64_t shift, int i) {
  const double u = 0.7548776662466927 * i + static_cast<double>(shift & 0xffffff) * 0x1.0p-24;
  const double v =
      0.5698402909980532 * i + static_cast<double>((shift >> 24) & 0xffffff) * 0x1.0p-24;
  return Vector2f(static_cast<float>(u - std::floor(u)), static_cast<float>(v - std::floor(v)));
}

/// Two unit vectors that complete n to a right-handed frame (Duff et al., JCGT 2017).
void completeFrame(const Vector3f& n, Vector3f& t, Vector3f& b) {
  const float sign = std::copysign(1.0f, n.z());
  const float a = -1 / (sign + n.z());
  const float c = n.x() * n.y() * a;
  t = {1 + sign * n.x() * n.x() * a, sign * c, -sign * n.x()};
  b = {c, sign + n.y() * n.y() * a, -n.y()};
}

/// Bright overhead, darker towards the horizon.
float skyLight(const Vector3f& direction) { return 0.72f + 0.28f * direction.z(); }

class Painter {
 public:
  Painter(const std::vector<PreviewObject>& objects, const Camera& camera,
          const Transform& T_world_camera, const PreviewStyle& style)
      : camera_(camera),
        T_world_camera_(T_world_camera),
        style_(style),
        background_(linearFromSrgb(style.background)),
        to_light_(style.to_light.normalized().cast<float>()) {
    for (const PreviewObject& object : objects) {
      if (object.mesh.empty()) continue;
      raycaster_.add(transformed(object.T_world_mesh, object.mesh));
      drawn_.push_back({&object, cornerNormals(object.mesh)});
    }
    raycaster_.commit();
  }

  Image<Rgb> paint() const {
    Image<Rgb> image(camera_.width, camera_.height);
    constexpr std::size_t kRows = 4;  // rays of neighbouring rows are traced together
    parallelForRanges(static_cast<std::size_t>(camera_.height), kRows,
                      [&](std::size_t begin, std::size_t end) {
                        paintRows(static_cast<int>(begin), static_cast<int>(end), image);
                      });
    return image;
  }

 private:
  void paintRows(int begin, int end, Image<Rgb>& image) const {
    const int n = style_.supersampling;
    const std::vector<Sample> samples = castCameraRays(begin, end);
    const std::vector<Vector3f> radiance = shade(samples, static_cast<std::uint64_t>(begin));
    std::size_t i = 0;
    for (int v = begin; v < end; ++v) {
      for (int u = 0; u < camera_.width; ++u) {
        Vector3f sum = Vector3f::Zero();
        for (int s = 0; s < n * n; ++s) sum += radiance[i++].cwiseMin(1.0f);
        image(u, v) = srgbFromLinear(sum / static_cast<float>(n * n));
      }
    }
  }

  std::vector<Sample> castCameraRays(int begin, int end) const {
    const int n = style_.supersampling;
    std::vector<Raycaster::Ray> rays;
    const Vector3f origin = T_world_camera_.translation().cast<float>();
    for (int v = begin; v < end; ++v) {
      for (int u = 0; u < camera_.width; ++u) {
        for (int s = 0; s < n * n; ++s) {
          const double du = (s % n + 0.5) / n - 0.5;
          const double dv = (s / n + 0.5) / n - 0.5;
          const Vector3d direction =
              T_world_camera_.linear() * camera_.backproject(u + du, v + dv, 1).normalized();
          rays.push_back({origin, direction.cast<float>()});
        }
      }
    }
    std::vector<Raycaster::Hit> hits(rays.size());
    raycaster_.intersect(rays, hits);
    std::vector<Sample> samples(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) samples[i] = sampleAt(rays[i], hits[i]);
    return samples;
  }

  Sample sampleAt(const Raycaster::Ray& ray, const Raycaster::Hit& hit) const {
    Sample sample;
    sample.to_viewer = -ray.direction;
    const float floor_z = static_cast<float>(style_.floor_z_m);
    if (hit) {
      sample.nothing = false;
      sample.point = ray.origin + hit.distance * ray.direction;
      if (!style_.floor || sample.point.z() > floor_z - 1e-4f) {
        describeSurface(hit, sample);
        return sample;
      }
    }
    if (style_.floor && ray.direction.z() < -1e-4f && ray.origin.z() > floor_z) {
      sample.nothing = false;
      sample.floor = true;
      sample.point = ray.origin + (floor_z - ray.origin.z()) / ray.direction.z() * ray.direction;
      sample.reflectance = background_;
    }
    return sample;
  }

  void describeSurface(const Raycaster::Hit& hit, Sample& sample) const {
    const Drawn& drawn = drawn_[hit.mesh];
    const PreviewObject& object = *drawn.object;
    const float weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    Vector3f normal = Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) normal += weights[k] * drawn.normals[3 * hit.face + k];
    normal.normalize();
    if (!object.face_material.empty()) {
      const Material& material = object.materials[object.face_material[hit.face]];
      const Vector3f p =
          (object.T_world_mesh.inverse() * sample.point.cast<double>()).cast<float>();
      sample.reflectance = evaluate(material, p, normal);
      sample.gloss = static_cast<float>(material.gloss);
    } else if (!object.mesh.colors.empty()) {
      for (int k = 0; k < 3; ++k) {
        const auto id = static_cast<std::size_t>(object.mesh.faces[hit.face][k]);
        sample.reflectance += weights[k] * linearFromSrgb(object.mesh.colors[id]);
      }
    } else {
      sample.reflectance = linearFromSrgb(object.color);
    }
    sample.normal = object.T_world_mesh.linear().cast<float>() * normal;
    if (sample.normal.dot(sample.to_viewer) < 0 && isBackFace(hit, sample)) {
      sample.normal = -sample.normal;
    }
  }

  bool isBackFace(const Raycaster::Hit& hit, const Sample& sample) const {
    const PreviewObject& object = *drawn_[hit.mesh].object;
    const Eigen::Vector3i& face = object.mesh.faces[hit.face];
    const auto vertex = [&](int k) -> const Vector3d& {
      return object.mesh.vertices[static_cast<std::size_t>(face[k])];
    };
    const Vector3d n = (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0));
    return (object.T_world_mesh.linear() * n).dot(sample.to_viewer.cast<double>()) < 0;
  }

  /// The squared samples of a pixel share one low-discrepancy sequence: sample s takes its points s
  /// n ... s n + n - 1.
  int firstPoint(std::size_t sample) const {
    const auto per_pixel = static_cast<std::size_t>(style_.supersampling * style_.supersampling);
    return static_cast<int>(sample % per_pixel) * style_.rays_per_sample;
  }
  std::uint64_t pixelShift(std::uint64_t stream, std::size_t sample) const {
    const auto per_pixel = static_cast<std::size_t>(style_.supersampling * style_.supersampling);
    return hashSeed(stream, sample / per_pixel);
  }

  /// Rays towards the sun's disc, then rays of the ambient hemisphere, for every sample that needs
  /// them.
  std::vector<Vector3f> shade(const std::vector<Sample>& samples, std::uint64_t stream) const {
    const int n = style_.rays_per_sample;
    std::vector<Raycaster::Ray> rays;
    rays.reserve(2 * samples.size() * static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].nothing) continue;
      addLightRays(samples[i], pixelShift(stream, i), firstPoint(i), rays);
    }
    std::vector<std::uint8_t> blocked(rays.size());
    raycaster_.occluded(rays, blocked);
    std::vector<Vector3f> radiance(samples.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Sample& sample = samples[i];
      if (sample.nothing) {
        radiance[i] = background_;
        continue;
      }
      float sun = 0;
      float sky = 0;
      float clear_sky = 0;  // what the sky would give without anything in the way
      for (int k = 0; k < n; ++k) sun += blocked[next++] != 0 ? 0.0f : 1.0f;
      for (int k = 0; k < n; ++k, ++next) {
        const Vector3f& direction = rays[next].direction;
        const bool below = style_.floor && direction.z() < 0;
        const float open = below ? 0.75f * kBounce + 0.2f : skyLight(direction);
        sky += blocked[next] != 0 ? kBounce * 0.8f : open;
        clear_sky += open;
      }
      sun /= static_cast<float>(n);
      sky /= static_cast<float>(n);
      clear_sky /= static_cast<float>(n);
      radiance[i] = sample.floor ? floorRadiance(sample, sun, sky / clear_sky)
                                 : surfaceRadiance(sample, sun, sky);
    }
    return radiance;
  }

  void addLightRays(const Sample& sample, std::uint64_t shift, int first_point,
                    std::vector<Raycaster::Ray>& rays) const {
    const int n = style_.rays_per_sample;
    const Vector3f start = sample.point + kOffset * sample.normal + kOffset * sample.to_viewer;
    Vector3f t;
    Vector3f b;
    completeFrame(to_light_, t, b);
    for (int k = 0; k < n; ++k) {
      const Vector2f q = squarePoint(shift, first_point + k);
      const float radius = static_cast<float>(style_.light_radius) * std::sqrt(q.x());
      const float angle = 2 * std::numbers::pi_v<float> * q.y();
      rays.push_back({start, (to_light_ + radius * (std::cos(angle) * t + std::sin(angle) * b))});
    }
    completeFrame(sample.normal, t, b);
    for (int k = 0; k < n; ++k) {
      const Vector2f q = squarePoint(mixBits(shift), first_point + k);
      const float radius = std::sqrt(q.x());
      const float angle = 2 * std::numbers::pi_v<float> * q.y();
      const Vector3f direction = radius * std::cos(angle) * t + radius * std::sin(angle) * b +
                                 std::sqrt(1 - q.x()) * sample.normal;
      rays.push_back({start, direction, 0, static_cast<float>(style_.ambient_range_m)});
    }
  }

  /// The plane keeps the background's colour where nothing shades it.
  Vector3f floorRadiance(const Sample& sample, float sun, float openness) const {
    const float lit = 0.42f * sun + 0.58f * openness * openness;
    return sample.reflectance * (0.25f + 0.75f * lit);
  }

  Vector3f surfaceRadiance(const Sample& sample, float sun, float sky) const {
    const float facing = std::max(0.0f, sample.normal.dot(to_light_)) * sun;
    const Vector3f warm(1.03f, 1.0f, 0.95f);
    const Vector3f cool(0.97f, 1.0f, 1.05f);
    Vector3f light = kSunStrength * facing * warm + kSkyStrength * sky * cool;
    Vector3f radiance = sample.reflectance.cwiseProduct(light);
    if (sample.gloss > 0) {
      const Vector3f half = (to_light_ + sample.to_viewer).normalized();
      const float shine = std::pow(std::max(0.0f, sample.normal.dot(half)), 20 + 60 * sample.gloss);
      const float grazing = std::pow(1 - std::max(0.0f, sample.normal.dot(sample.to_viewer)), 4.0f);
      radiance += Vector3f::Constant(sample.gloss *
                                     (0.35f * shine * sun + (0.04f + 0.25f * grazing) * sky));
    }
    return radiance;
  }

  Camera camera_;
  Transform T_world_camera_;
  PreviewStyle style_;
  Vector3f background_;
  Vector3f to_light_;
  Raycaster raycaster_;
  std::vector<Drawn> drawn_;
};

}  // namespace

PreviewObject previewObject(const ShapeInstance& instance, const SurfaceMesh& surface,
                            const Transform& T_world_object) {
  PreviewObject object;
  object.mesh = surface.mesh;
  object.T_world_mesh = T_world_object;
  object.face_material = surface.face_part;
  for (const ShapePart& part : instance.parts) object.materials.push_back(part.material);
  return object;
}

Image<Rgb> renderPreview(const std::vector<PreviewObject>& objects, const Camera& camera,
                         const Transform& T_world_camera, const PreviewStyle& style) {
  return Painter(objects, camera, T_world_camera, style).paint();
}

Camera previewCamera(int width, int height, double vertical_fov_rad) {
  const double f = 0.5 * height / std::tan(0.5 * vertical_fov_rad);
  return {width, height, f, f, 0.5 * (width - 1), 0.5 * (height - 1)};
}

Transform previewPose(const Aabb& box, const Camera& camera, double azimuth_rad,
                      double elevation_rad, double margin) {
  const Vector3d toward(std::cos(elevation_rad) * std::cos(azimuth_rad),
                        std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
  // Step back until every corner of the box is in the picture.
  Transform pose = lookAt(box.center() + toward, box.center());
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    const Vector3d q =
        pose.linear().transpose() * (box.corner(static_cast<Aabb::CornerType>(i)) - box.center());
    distance = std::max({distance, margin * std::abs(q.x()) * 2 * camera.fx / camera.width - q.z(),
                         margin * std::abs(q.y()) * 2 * camera.fy / camera.height - q.z()});
  }
  pose.translation() = box.center() + distance * toward;
  return pose;
}

}  // namespace hydrabench
