// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/rgbd_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/lighting.h"
#include "eval/simulation/mover_caster.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

constexpr int kTile = 16;  // pixels; a tile's rays travel together
constexpr int kBlock = 4;  // within it they are ordered by blocks: one packet each
constexpr std::size_t kTilePixels = kTile * kTile;
constexpr float kShadowBias_m = 0.004f;  // farther than the rounding of a hit, nearer than any gap
const Rgb kSky = {203, 219, 236};

/// The pixels of one tile on their way through the stages.
struct Tile {
  std::size_t count = 0;
  std::array<Eigen::Vector2i, kTilePixels> pixels;
  std::array<Raycaster::Ray, kTilePixels> rays;
  std::array<Raycaster::Hit, kTilePixels> hits;
  // Shading: final = lit + blocked ? 0 : key.
  std::array<Vector3f, kTilePixels> lit;
  std::array<Vector3f, kTilePixels> key;
  std::size_t num_shadows = 0;
  std::array<std::size_t, kTilePixels> shadow_pixel;
  std::array<Raycaster::Ray, kTilePixels> shadow_rays;
  std::array<std::uint8_t, kTilePixels> blocked;
};

}  // namespace

struct RgbdRenderer::Impl {
  Impl(std::shared_ptr<const Scene> world, const Config& settings)
      : scene(std::move(world)), config(settings), lighting(*scene), movers(scene->movers) {
    for (const SceneObject& object : scene->objects) {
      raycaster.add(transformed(object.T_world_object, object.surface->mesh));
      meshes.emplace_back(*object.surface, object.T_world_object, object.label, false);
    }
    for (const StructurePart& part : scene->structure) {
      if (part.overhead && !config.with_overhead) continue;
      raycaster.add(part.surface.mesh);
      meshes.emplace_back(part.surface, Transform::Identity(), part.label, part.emissive);
    }
    raycaster.commit();
  }

  void aim(const Camera& camera, const Transform& T_world_camera, int tile_u, int tile_v,
           Tile& tile) const;
  void trace(std::int64_t stamp_ns, Tile& tile) const;
  void shade(std::int64_t stamp_ns, Tile& tile) const;
  void store(std::int64_t stamp_ns, const Tile& tile, RenderedView& view) const;

  bool isMover(const Raycaster::Hit& hit) const { return hit.mesh >= meshes.size(); }
  std::size_t moverPart(const Raycaster::Hit& hit) const { return hit.mesh - meshes.size(); }
  DrawnMesh::SurfaceSample sample(std::int64_t stamp_ns, const Raycaster::Ray& ray,
                                  const Raycaster::Hit& hit) const {
    const Vector3f point = ray.origin + hit.distance * ray.direction;
    return isMover(hit) ? movers.sample(stamp_ns, moverPart(hit), hit, point, ray.direction)
                        : meshes[hit.mesh].sample(hit, point, ray.direction);
  }
  Vector3f faceNormal(std::int64_t stamp_ns, const Raycaster::Hit& hit) const {
    return isMover(hit) ? movers.faceNormal(stamp_ns, moverPart(hit), hit.face)
                        : meshes[hit.mesh].faceNormal(hit.face);
  }
  Label labelOf(const Raycaster::Hit& hit) const {
    return isMover(hit) ? movers.labelOf(moverPart(hit)) : meshes[hit.mesh].label();
  }
  /// As RenderedView::objects has it.
  std::int32_t objectOf(const Raycaster::Hit& hit) const {
    const std::size_t num_objects = scene->objects.size();
    if (isMover(hit))
      return static_cast<std::int32_t>(num_objects + movers.moverOf(moverPart(hit)));
    return hit.mesh < num_objects ? static_cast<std::int32_t>(hit.mesh) : -1;
  }

  std::shared_ptr<const Scene> scene;
  Config config;
  Lighting lighting;
  Raycaster raycaster;
  std::vector<DrawnMesh> meshes;
  MoverCaster movers;
};

void RgbdRenderer::Impl::aim(const Camera& camera, const Transform& T_world_camera, int tile_u,
                             int tile_v, Tile& tile) const {
  tile.count = 0;
  const Vector3f origin = T_world_camera.translation().cast<float>();
  for (int block = 0; block < static_cast<int>(kTilePixels) / (kBlock * kBlock); ++block) {
    const int block_u = tile_u + kBlock * (block % (kTile / kBlock));
    const int block_v = tile_v + kBlock * (block / (kTile / kBlock));
    for (int i = 0; i < kBlock * kBlock; ++i) {
      const int u = block_u + i % kBlock;
      const int v = block_v + i / kBlock;
      if (u >= camera.width || v >= camera.height) continue;
      // The direction has camera z = 1, so that a hit's distance is its z-depth.
      const Eigen::Vector3d direction = T_world_camera.linear() * camera.backproject(u, v, 1);
      tile.pixels[tile.count] = {u, v};
      tile.rays[tile.count] = {origin, direction.cast<float>()};
      ++tile.count;
    }
  }
}

void RgbdRenderer::Impl::trace(std::int64_t stamp_ns, Tile& tile) const {
  const std::span<const Raycaster::Ray> rays(tile.rays.data(), tile.count);
  const std::span<Raycaster::Hit> hits(tile.hits.data(), tile.count);
  raycaster.intersect(rays, hits);
  if (movers.empty()) return;
  movers.intersect(stamp_ns, rays, static_cast<std::uint32_t>(meshes.size()), hits);
}

void RgbdRenderer::Impl::shade(std::int64_t stamp_ns, Tile& tile) const {
  tile.num_shadows = 0;
  for (std::size_t i = 0; i < tile.count; ++i) {
    const Raycaster::Hit& hit = tile.hits[i];
    if (!hit) continue;
    const Raycaster::Ray& ray = tile.rays[i];
    const Vector3f point = ray.origin + hit.distance * ray.direction;
    const DrawnMesh::SurfaceSample surface = sample(stamp_ns, ray, hit);
    tile.key[i].setZero();
    if (!isMover(hit) && meshes[hit.mesh].emissive()) {
      tile.lit[i] = surface.reflectance;
      continue;
    }
    const Lighting::Sample light = lighting.at(point, surface.normal);
    tile.lit[i] = light.ambient * surface.reflectance;
    if (light.key <= 0.01f) continue;
    tile.key[i] = light.key * surface.reflectance;
    const Vector3f to_lamp = light.key_position - point;
    if (surface.gloss > 0) {
      const Vector3f half = (to_lamp.normalized() - ray.direction.normalized()).normalized();
      float shine = std::max(0.0f, surface.normal.dot(half));
      for (int k = 0; k < 5; ++k) shine *= shine;
      tile.key[i] += Vector3f::Constant(0.4f * surface.gloss * shine * std::min(1.0f, light.key));
    }
    // The surface normal may be interpolated; the ray must start outside of the flat face.
    const float side = surface.face_normal.dot(to_lamp) > 0 ? kShadowBias_m : 0;
    if (side == 0) {  // the face itself turns away from the lamp
      tile.key[i].setZero();
      continue;
    }
    tile.shadow_pixel[tile.num_shadows] = i;
    tile.shadow_rays[tile.num_shadows] = {point + side * surface.face_normal, to_lamp, 0, 0.98f};
    ++tile.num_shadows;
  }
  const std::span<const Raycaster::Ray> shadow_rays(tile.shadow_rays.data(), tile.num_shadows);
  const std::span<std::uint8_t> blocked(tile.blocked.data(), tile.num_shadows);
  raycaster.occluded(shadow_rays, blocked);
  if (!movers.empty()) movers.occluded(stamp_ns, shadow_rays, blocked);
  for (std::size_t k = 0; k < tile.num_shadows; ++k) {
    if (tile.blocked[k]) tile.key[tile.shadow_pixel[k]].setZero();
  }
}

void RgbdRenderer::Impl::store(std::int64_t stamp_ns, const Tile& tile, RenderedView& view) const {
  for (std::size_t i = 0; i < tile.count; ++i) {
    const int u = tile.pixels[i].x();
    const int v = tile.pixels[i].y();
    const Raycaster::Hit& hit = tile.hits[i];
    if (!hit) {
      if (config.with_color) view.color(u, v) = kSky;
      continue;
    }
    view.depth(u, v) = hit.distance;
    view.labels(u, v) = labelOf(hit);
    view.objects(u, v) = objectOf(hit);
    const Vector3f& direction = tile.rays[i].direction;
    const float cosine = std::abs(faceNormal(stamp_ns, hit).dot(direction)) / direction.norm();
    view.incidence(u, v) = static_cast<std::uint8_t>(255 * std::min(1.0f, cosine) + 0.5f);
    if (config.with_color) view.color(u, v) = srgbFromLinear(tile.lit[i] + tile.key[i]);
  }
}

RgbdRenderer::RgbdRenderer(std::shared_ptr<const Scene> scene, const Config& config)
    : impl_(std::make_unique<Impl>(std::move(scene), config)) {}
RgbdRenderer::~RgbdRenderer() = default;
RgbdRenderer::RgbdRenderer(RgbdRenderer&&) noexcept = default;
RgbdRenderer& RgbdRenderer::operator=(RgbdRenderer&&) noexcept = default;

RenderedView RgbdRenderer::render(const Camera& camera, const Transform& T_world_camera,
                                  std::int64_t stamp_ns) const {
  RenderedView view;
  if (impl_->config.with_color) view.color = Image<Rgb>(camera.width, camera.height);
  view.depth = Image<float>(camera.width, camera.height);
  view.labels = Image<Label>(camera.width, camera.height, kUnknownLabel);
  view.objects = Image<std::int32_t>(camera.width, camera.height, -1);
  view.incidence = Image<std::uint8_t>(camera.width, camera.height);
  const int columns = (camera.width + kTile - 1) / kTile;
  const int rows = (camera.height + kTile - 1) / kTile;
  parallelForRanges(static_cast<std::size_t>(columns * rows), 8,
                    [&](std::size_t begin, std::size_t end) {
                      auto tile = std::make_unique<Tile>();
                      for (std::size_t i = begin; i < end; ++i) {
                        const int index = static_cast<int>(i);
                        impl_->aim(camera, T_world_camera, kTile * (index % columns),
                                   kTile * (index / columns), *tile);
                        impl_->trace(stamp_ns, *tile);
                        if (impl_->config.with_color) impl_->shade(stamp_ns, *tile);
                        impl_->store(stamp_ns, *tile, view);
                      }
                    });
  return view;
}

const Raycaster& RgbdRenderer::raycaster() const { return impl_->raycaster; }

bool RgbdRenderer::hasMovers() const { return !impl_->movers.empty(); }

void RgbdRenderer::intersectMovers(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                                   std::span<Raycaster::Hit> hits) const {
  const auto first_mesh = static_cast<std::uint32_t>(impl_->meshes.size());
  impl_->movers.intersect(stamp_ns, rays, first_mesh, hits);
}

DrawnMesh::SurfaceSample RgbdRenderer::sample(std::int64_t stamp_ns, const Raycaster::Ray& ray,
                                              const Raycaster::Hit& hit) const {
  return impl_->sample(stamp_ns, ray, hit);
}

Label RgbdRenderer::labelOf(const Raycaster::Hit& hit) const { return impl_->labelOf(hit); }

}  // namespace hydrabench
