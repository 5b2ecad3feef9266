// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/rgbd_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/geometry/raycaster.h"
#include "core/parallel/parallel_for.h"
#include "eval/simulation/drawn_mesh.h"
#include "eval/simulation/lighting.h"

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
      : scene(std::move(world)), config(settings), lighting(*scene) {
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
  void shade(Tile& tile) const;
  void store(const Tile& tile, RenderedView& view) const;

  std::shared_ptr<const Scene> scene;
  Config config;
  Lighting lighting;
  Raycaster raycaster;
  std::vector<DrawnMesh> meshes;
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

void RgbdRenderer::Impl::shade(Tile& tile) const {
  tile.num_shadows = 0;
  for (std::size_t i = 0; i < tile.count; ++i) {
    const Raycaster::Hit& hit = tile.hits[i];
    if (!hit) continue;
    const Raycaster::Ray& ray = tile.rays[i];
    const DrawnMesh& mesh = meshes[hit.mesh];
    const Vector3f point = ray.origin + hit.distance * ray.direction;
    const DrawnMesh::SurfaceSample surface = mesh.sample(hit, point, ray.direction);
    tile.key[i].setZero();
    if (mesh.emissive()) {
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
  raycaster.occluded(std::span(tile.shadow_rays.data(), tile.num_shadows),
                     std::span(tile.blocked.data(), tile.num_shadows));
  for (std::size_t k = 0; k < tile.num_shadows; ++k) {
    if (tile.blocked[k]) tile.key[tile.shadow_pixel[k]].setZero();
  }
}

void RgbdRenderer::Impl::store(const Tile& tile, RenderedView& view) const {
  for (std::size_t i = 0; i < tile.count; ++i) {
    const int u = tile.pixels[i].x();
    const int v = tile.pixels[i].y();
    const Raycaster::Hit& hit = tile.hits[i];
    if (!hit) {
      if (config.with_color) view.color(u, v) = kSky;
      continue;
    }
    const DrawnMesh& mesh = meshes[hit.mesh];
    view.depth(u, v) = hit.distance;
    view.labels(u, v) = mesh.label();
    if (hit.mesh < scene->objects.size()) view.objects(u, v) = static_cast<std::int32_t>(hit.mesh);
    const Vector3f& direction = tile.rays[i].direction;
    const float cosine = std::abs(mesh.faceNormal(hit.face).dot(direction)) / direction.norm();
    view.incidence(u, v) = static_cast<std::uint8_t>(255 * std::min(1.0f, cosine) + 0.5f);
    if (config.with_color) view.color(u, v) = srgbFromLinear(tile.lit[i] + tile.key[i]);
  }
}

RgbdRenderer::RgbdRenderer(std::shared_ptr<const Scene> scene, const Config& config)
    : impl_(std::make_unique<Impl>(std::move(scene), config)) {}
RgbdRenderer::~RgbdRenderer() = default;
RgbdRenderer::RgbdRenderer(RgbdRenderer&&) noexcept = default;
RgbdRenderer& RgbdRenderer::operator=(RgbdRenderer&&) noexcept = default;

RenderedView RgbdRenderer::render(const Camera& camera, const Transform& T_world_camera) const {
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
                        impl_->raycaster.intersect(
                            std::span<const Raycaster::Ray>(tile->rays.data(), tile->count),
                            std::span(tile->hits.data(), tile->count));
                        if (impl_->config.with_color) impl_->shade(*tile);
                        impl_->store(*tile, view);
                      }
                    });
  return view;
}

const Raycaster& RgbdRenderer::raycaster() const { return impl_->raycaster; }

const DrawnMesh& RgbdRenderer::mesh(std::size_t index) const { return impl_->meshes[index]; }

}  // namespace hydrabench
