// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/rgbd_sensor.h"

namespace hydrabench {
namespace {

constexpr std::uint64_t kDepthStream = 1;
constexpr std::uint64_t kColorStream = 2;
constexpr std::uint64_t kMaskStream = 3;

}  // namespace

RgbdSensorConfig RgbdSensorConfig::clean() {
  RgbdSensorConfig config;
  config.color_noise_levels = 0;
  config.depth_noise = DepthNoiseConfig::off();
  config.masks = MaskCorruptionConfig::off();
  return config;
}

RgbdSensorConfig RgbdSensorConfig::hard() {
  RgbdSensorConfig config;
  config.color_noise_levels = 5;
  config.depth_noise.axial_constant_m = 0.003;
  config.depth_noise.axial_quadratic = 0.004;
  config.depth_noise.lateral_px = 0.9;
  config.depth_noise.disparity_step_px = 0.0625;
  config.depth_noise.edge_dropout = 0.8;
  config.depth_noise.edge_radius_px = 2;
  config.depth_noise.grazing_start_deg = 68;
  config.depth_noise.random_dropout = 0.02;
  config.masks.boundary_jitter_px = 2.5;
  config.masks.miss_probability = 0.12;
  config.masks.split_probability = 0.10;
  config.masks.merge_probability = 0.20;
  config.masks.confusion_probability = 0.08;
  config.masks.min_pixels = 100;
  return config;
}

void useOutdoorCamera(RgbdSensorConfig& config) {
  // sigma(z) = z^2 / (f b) * sigma(disparity): 0.08 px in good light is 0.0023 / m.
  constexpr double kQuadraticToIndoors = 1.5;
  config.camera = {640, 480, 372.46, 372.46, 320, 240};
  config.min_depth_m = 0.4;
  config.max_depth_m = 6.0;
  config.depth_noise.axial_quadratic *= kQuadraticToIndoors;
  config.depth_noise.baseline_m = 0.095;
}

void read(ConfigReader& reader, RgbdSensorConfig& config) {
  ConfigReader camera = reader.section("camera");
  camera.field("width_px", config.camera.width, {8, 8192});
  camera.field("height_px", config.camera.height, {8, 8192});
  camera.field("fx_px", config.camera.fx, {1, 1e5});
  camera.field("fy_px", config.camera.fy, {1, 1e5});
  camera.field("cx_px", config.camera.cx, {-1e5, 1e5});
  camera.field("cy_px", config.camera.cy, {-1e5, 1e5});
  const Camera& lens = config.camera;
  if (!lens.sees({lens.cx, lens.cy})) {
    // Most likely the size was changed alone.
    camera.fault("cx_px",
                 "the principal point lies outside the image; fx, fy, cx and cy belong to "
                 "the size");
  }
  camera.field("min_depth_m", config.min_depth_m, {0, 100});
  camera.field("max_depth_m", config.max_depth_m, {0.1, 1000});
  camera.field("color_noise_levels", config.color_noise_levels, {0, 100});
  if (config.min_depth_m >= config.max_depth_m) {
    camera.fault("max_depth_m", "must be larger than min_depth_m");
  }
  ConfigReader depth_noise = reader.section("depth_noise");
  read(depth_noise, config.depth_noise);
  ConfigReader masks = reader.section("masks");
  read(masks, config.masks);
}

Frame observe(const Scene& scene, const RgbdRenderer& renderer, const Transform& T_world_camera,
              const RgbdSensorConfig& config, std::uint64_t seed, std::size_t index,
              std::int64_t stamp_ns) {
  const Random frame_random(seed, index);
  const auto streamSeed = [&](std::uint64_t stream) { return frame_random.fork(stream).bits(); };
  RenderedView view = renderer.render(config.camera, T_world_camera, stamp_ns);

  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.camera = config.camera;
  frame.T_world_camera = T_world_camera;
  frame.depth = noisyDepth(view, config.camera, config.depth_noise, streamSeed(kDepthStream));
  for (float& depth : frame.depth) {
    if (depth < static_cast<float>(config.min_depth_m) ||
        depth > static_cast<float>(config.max_depth_m)) {
      depth = 0;
    }
  }
  frame.color = std::move(view.color);
  addColorNoise(config.color_noise_levels, streamSeed(kColorStream), frame.color);

  std::vector<Label> object_labels;
  object_labels.reserve(scene.objects.size() + scene.movers.size());
  for (const SceneObject& object : scene.objects) object_labels.push_back(object.label);
  for (const Mover& mover : scene.movers) object_labels.push_back(mover.label);
  Segmentation segmentation =
      corruptMasks(view.objects, view.labels, object_labels, config.masks, streamSeed(kMaskStream));
  frame.labels = std::move(segmentation.labels);
  frame.instances = std::move(segmentation.instances);
  frame.instance_labels = std::move(segmentation.instance_labels);
  return frame;
}

}  // namespace hydrabench
