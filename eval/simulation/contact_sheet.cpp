// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/contact_sheet.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/label_text.h"
#include "eval/simulation/preview_renderer.h"

namespace hydrabench {
namespace {

constexpr Rgb kInk{52, 58, 66};
constexpr Rgb kFaintInk{140, 146, 154};
constexpr int kMargin = 12;    // [px]
constexpr int kHeadline = 22;  // [px] above each row, for the names
constexpr double kFieldOfView = 0.35;
constexpr double kAzimuth = 0.6;
constexpr double kElevation = 0.35;

void paste(const Image<Rgb>& part, int u0, int v0, Image<Rgb>& whole) {
  for (int v = 0; v < part.height(); ++v) {
    for (int u = 0; u < part.width(); ++u) {
      if (whole.contains(u0 + u, v0 + v)) whole(u0 + u, v0 + v) = part(u, v);
    }
  }
}

struct MeshedInstance {
  ShapeInstance instance;
  SurfaceMesh surface;
};

Image<Rgb> renderRow(const ShapeFamily& family, std::uint64_t row, std::uint64_t seed, int count,
                     int cell_px) {
  std::vector<MeshedInstance> meshed(static_cast<std::size_t>(count));
  parallelFor(meshed.size(), [&](std::size_t i) {
    const std::uint64_t index = instanceIndex(hashSeed(seed, row), i);
    meshed[i].instance = i == 0
                             ? family.nominal()
                             : family.draw(Random(instanceSeed(InstanceSplit::kEvaluation, index)));
    meshed[i].surface = meshInstance(meshed[i].instance);
  });
  Aabb box;
  for (const MeshedInstance& item : meshed) box.extend(bounds(item.surface.mesh));
  const Camera camera = previewCamera(cell_px, cell_px, kFieldOfView);
  const Transform T_world_camera = previewPose(box, camera, kAzimuth, kElevation, 1.03);
  Image<Rgb> strip(count * cell_px, cell_px);
  for (std::size_t i = 0; i < meshed.size(); ++i) {
    const PreviewObject object =
        previewObject(meshed[i].instance, meshed[i].surface, Transform::Identity());
    paste(renderPreview({object}, camera, T_world_camera), static_cast<int>(i) * cell_px, 0, strip);
  }
  return strip;
}

}  // namespace

Image<Rgb> tiled(const std::vector<Image<Rgb>>& pictures, const std::vector<std::string>& labels,
                 int columns, Rgb background) {
  assert(!pictures.empty() && columns > 0 && (labels.empty() || labels.size() == pictures.size()));
  const int width = pictures.front().width();
  const int height = pictures.front().height() + (labels.empty() ? 0 : kHeadline);
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  Image<Rgb> whole(columns * (width + kMargin) + kMargin, rows * (height + kMargin) + kMargin,
                   background);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int u = kMargin + static_cast<int>(i) % columns * (width + kMargin);
    const int v = kMargin + static_cast<int>(i) / columns * (height + kMargin);
    paste(pictures[i], u, v, whole);
    if (!labels.empty()) {
      const int text_u = u + (width - textWidth(labels[i], 2)) / 2;
      drawText(whole, text_u, v + pictures[i].height() + 5, labels[i], kInk, 2);
    }
  }
  return whole;
}

Image<Rgb> renderContactSheet(std::span<const ShapeFamily> families, std::uint64_t seed,
                              int instances_per_family, const ContactSheetStyle& style) {
  assert(!families.empty() && instances_per_family > 0 && style.blocks > 0);
  const int rows = (static_cast<int>(families.size()) + style.blocks - 1) / style.blocks;
  const int block_width = instances_per_family * style.cell_px + kMargin;
  const int row_height = style.cell_px + kHeadline;
  const Rgb background = PreviewStyle{}.background;
  Image<Rgb> sheet(style.blocks * block_width + kMargin, rows * row_height + kMargin, background);
  for (std::size_t i = 0; i < families.size(); ++i) {
    const int u = kMargin + static_cast<int>(i) / rows * block_width;
    const int v = kMargin + static_cast<int>(i) % rows * row_height;
    paste(renderRow(families[i], i, seed, instances_per_family, style.cell_px), u, v + kHeadline,
          sheet);
    drawText(sheet, u + 4, v + 4, families[i].name, kInk, 2);
    if (families[i].class_name == families[i].name) continue;
    drawText(sheet, u + 4 + textWidth(families[i].name, 2) + 14, v + 11, families[i].class_name,
             kFaintInk, 1);
  }
  return sheet;
}

}  // namespace hydrabench
