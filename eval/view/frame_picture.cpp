// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/frame_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/types/random.h"

namespace hydrabench {
namespace {

std::uint8_t toByte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

/// Polynomial fit to the turbo colour map; x in [0, 1], 0 blue, 1 red.
Rgb turbo(double x) {
  const auto polynomial = [x](const std::array<double, 6>& c) {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
  };
  return {toByte(polynomial(
              {0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943})),
          toByte(polynomial(
              {0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604})),
          toByte(polynomial(
              {0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973}))};
}

Rgb hueColor(double hue, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue * 6, 6.0);
    return toByte(value * (1 - 0.75 * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
  };
  return {channel(5), channel(3), channel(1)};
}

template <typename Pixel, typename Function>
Image<Rgb> mapped(const Image<Pixel>& image, const Function& function) {
  Image<Rgb> picture(image.width(), image.height());
  std::transform(image.begin(), image.end(), picture.begin(), function);
  return picture;
}

void paste(const Image<Rgb>& part, int left, int top, Image<Rgb>& whole) {
  for (int v = 0; v < part.height(); ++v) {
    for (int u = 0; u < part.width(); ++u) whole(left + u, top + v) = part(u, v);
  }
}

constexpr Rgb kGap = {255, 255, 255};

}  // namespace

Image<Rgb> depthPicture(const Image<float>& depth, float max_depth_m) {
  return mapped(depth, [&](float d) {
    return d > 0 ? turbo(1 - std::clamp(static_cast<double>(d / max_depth_m), 0.0, 1.0)) : Rgb{};
  });
}

Image<Rgb> instancePicture(const Image<InstanceId>& instances) {
  return mapped(instances, [](InstanceId id) {
    if (id == kNoInstance) return Rgb{};
    // Steps of the golden ratio spread any run of ids over the hues.
    const double hue = std::fmod(0.618033988749895 * static_cast<double>(id), 1.0);
    const double value = 0.7 + 0.3 * Random(static_cast<std::uint64_t>(id)).uniform();
    return hueColor(hue, value);
  });
}

Image<Rgb> labelPicture(const Image<Label>& labels, const LabelSpace& label_space) {
  return mapped(labels, [&](Label label) {
    const LabelSpace::Entry* entry = label_space.find(label);
    return entry ? entry->color : Rgb{};
  });
}

Image<Rgb> sideBySide(const std::vector<Image<Rgb>>& pictures, int gap_px) {
  int width = -gap_px;
  int height = 0;
  for (const Image<Rgb>& picture : pictures) {
    width += picture.width() + gap_px;
    height = std::max(height, picture.height());
  }
  Image<Rgb> whole(std::max(width, 0), height, kGap);
  int left = 0;
  for (const Image<Rgb>& picture : pictures) {
    paste(picture, left, 0, whole);
    left += picture.width() + gap_px;
  }
  return whole;
}

Image<Rgb> reduced(const Image<Rgb>& picture, int factor) {
  assert(factor > 0);
  Image<Rgb> small(picture.width() / factor, picture.height() / factor);
  for (int v = 0; v < small.height(); ++v) {
    for (int u = 0; u < small.width(); ++u) {
      int sum[3] = {0, 0, 0};
      for (int dv = 0; dv < factor; ++dv) {
        for (int du = 0; du < factor; ++du) {
          const Rgb& pixel = picture(u * factor + du, v * factor + dv);
          sum[0] += pixel.r;
          sum[1] += pixel.g;
          sum[2] += pixel.b;
        }
      }
      const int count = factor * factor;
      const auto mean = [&](int c) {
        return static_cast<std::uint8_t>((sum[c] + count / 2) / count);
      };
      small(u, v) = {mean(0), mean(1), mean(2)};
    }
  }
  return small;
}

Image<Rgb> framePicture(const Frame& frame, float max_depth_m) {
  std::vector<Image<Rgb>> pictures;
  if (!frame.color.empty()) pictures.push_back(frame.color);
  if (!frame.depth.empty()) pictures.push_back(depthPicture(frame.depth, max_depth_m));
  if (!frame.instances.empty()) pictures.push_back(instancePicture(frame.instances));
  return sideBySide(pictures);
}

}  // namespace hydrabench
