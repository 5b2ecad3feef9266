// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstring>
#include <open3d/camera/PinholeCameraIntrinsic.h>
#include <open3d/geometry/RGBDImage.h>
#include <open3d/pipelines/integration/ScalableTSDFVolume.h>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/geometry/median.h"
#include "eval/bench/office_frames.h"

namespace hydrabench {
namespace {

/// The frame as Open3D wants it, depths beyond the limit left out; made before the clock runs.
open3d::geometry::RGBDImage open3dImage(const Frame& frame, float max_depth_m) {
  open3d::geometry::Image color;
  color.Prepare(frame.color.width(), frame.color.height(), 3, 1);
  static_assert(sizeof(Rgb) == 3);
  std::memcpy(color.data_.data(), frame.color.data(), 3 * frame.color.size());
  open3d::geometry::Image depth;
  depth.Prepare(frame.depth.width(), frame.depth.height(), 1, 4);
  for (int v = 0; v < frame.depth.height(); ++v) {
    for (int u = 0; u < frame.depth.width(); ++u) {
      const float z = frame.depth(u, v);
      *depth.PointerAt<float>(u, v) = z <= max_depth_m ? z : 0.0f;
    }
  }
  return {color, depth};
}

/// The peer of integrateOfficeFrame: the same frames, voxels, blocks and truncation, with Open3D's
/// own threads. It does less: blocks near the surface only, so no free space is carved, and no
/// labels.
void integrateOfficeFrameOpen3d(benchmark::State& state) {
  namespace integration = open3d::pipelines::integration;
  const std::vector<Frame>& frames = officeFrames();
  std::vector<open3d::geometry::RGBDImage> images;
  for (const Frame& frame : frames) images.push_back(open3dImage(frame, 5));
  const Camera& c = frames.front().camera;
  const open3d::camera::PinholeCameraIntrinsic camera(c.width, c.height, c.fx, c.fy, c.cx, c.cy);
  integration::ScalableTSDFVolume volume(0.1, 0.3, integration::TSDFVolumeColorType::RGB8, 16, 4);
  std::vector<double> times_ms;
  std::size_t next = 0;
  for (auto _ : state) {
    const std::size_t i = next++ % frames.size();
    const Transform T_camera_world = frames[i].T_world_camera.inverse();
    const auto start = std::chrono::steady_clock::now();
    volume.Integrate(images[i], camera, T_camera_world.matrix());
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  state.counters["p50_ms"] = median(times_ms);
}
BENCHMARK(integrateOfficeFrameOpen3d)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);

}  // namespace
}  // namespace hydrabench
