// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/config/config_reader.h"
#include "eval/simulation/rgbd_renderer.h"

namespace hydrabench {

/// Errors of an RGB-D camera. Every key at 0 switches its part off; the defaults resemble an active
/// stereo camera.
struct DepthNoiseConfig {
  double axial_constant_m =
      0.001;  ///< sigma(z) = constant + quadratic z^2 (Khoshelham and Elberink, Sensors 2012)
  double axial_quadratic = 0.0015;  ///< [1/m]
  double correlated_share = 0.5;  ///< share of the variance that neighbouring pixels have in common
  double correlation_px = 6;      ///< over this distance
  double lateral_px =
      0.5;  ///< sigma of the pixel that is measured instead (Nguyen et al., 3DIMPVT 2012)
  double disparity_step_px = 0.03125;  ///< depth comes in steps of z^2 / (f b) times this
  double baseline_m = 0.075;           ///< b
  double quantum_m = 0.001;            ///< depth is stored in multiples of this
  double edge_dropout = 0.5;           ///< probability that a pixel beside a depth edge is lost
  int edge_radius_px = 1;              ///< how far "beside" reaches
  double grazing_start_deg =
      78;  ///< surfaces seen flatter than this are lost more and more, all of them at 90
  double random_dropout = 0.002;  ///< probability that any pixel is lost

  static DepthNoiseConfig off();
};
void read(ConfigReader& reader, DepthNoiseConfig& config);

/// sigma(z) [m].
double axialSigma(const DepthNoiseConfig& config, double depth_m);

/// The depth image a camera with these errors would give for an ideal view. No range limit yet.
/// @param seed  of this frame: pixels are a pure function of (seed, view)
Image<float> noisyDepth(const RenderedView& view, const Camera& camera,
                        const DepthNoiseConfig& config, std::uint64_t seed);

/// Adds normal noise of `sigma` 8-bit levels to every channel.
void addColorNoise(double sigma, std::uint64_t seed, Image<Rgb>& color);

}  // namespace hydrabench
