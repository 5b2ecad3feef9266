// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/error_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "core/geometry/raycaster.h"
#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"
#include "eval/simulation/label_text.h"
#include "eval/simulation/preview_renderer.h"
#include "metrics/matching.h"

namespace hydrabench {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;
constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kInk{30, 33, 38};
constexpr Rgb kFaintInk{125, 130, 138};
constexpr Rgb kEstimate{120, 196, 128};
constexpr int kGap = 10;         // [px]
constexpr int kText = 2;         // scale of the font
constexpr int kNameWidth = 150;  // [px], left of a row
constexpr int kHeadline = 34;
constexpr int kFootline = 64;
constexpr int kSamplesPerSide = 2;  // of a pixel
constexpr std::uint64_t kPointSeed = 20266;

void paste(const Image<Rgb>& part, int left, int top, Image<Rgb>& whole) {
  for (int v = 0; v < part.height(); ++v) {
    for (int u = 0; u < part.width(); ++u) {
      if (whole.contains(left + u, top + v)) whole(left + u, top + v) = part(u, v);
    }
  }
}

void drawCentered(Image<Rgb>& image, int center, int top, const std::string& text, Rgb color,
                  int scale = kText) {
  drawText(image, center - textWidth(text, scale) / 2, top, text, color, scale);
}

/// Small octahedra: points that a renderer of surfaces draws.
Mesh pointsMesh(const std::vector<Eigen::Vector3d>& points, double radius) {
  static const Eigen::Vector3i kFaces[] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Mesh mesh;
  for (const Eigen::Vector3d& point : points) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int i = 0; i < 6; ++i) {
      Eigen::Vector3d tip = Eigen::Vector3d::Zero();
      tip[i / 2] = i % 2 == 0 ? radius : -radius;
      mesh.vertices.push_back(point + tip);
    }
    for (const Eigen::Vector3i& face : kFaces) {
      mesh.faces.push_back(face + Eigen::Vector3i::Constant(first));
    }
  }
  return mesh;
}

/// The place from which all pictures of an object are taken, in its own frame.
struct Viewpoint {
  Camera camera;
  Transform T_object_camera;
};

Viewpoint viewpointOf(const GroundTruthObject& truth, int tile_px) {
  Viewpoint view;
  view.camera = previewCamera(tile_px, tile_px, 25 * kDegrees);
  view.T_object_camera =
      previewPose(bounds(*truth.mesh), view.camera, 35 * kDegrees, 22 * kDegrees, 1.25);
  return view;
}

Image<Rgb> overlayTile(const ObjectComparison& object, const Mesh& estimate, const Viewpoint& view,
                       const ErrorPictureStyle& style) {
  const Mesh& truth = *object.truth->mesh;
  PreviewObject shape;
  shape.mesh = transformed(object.truth->T_world_object.inverse(), estimate);
  shape.mesh.colors.clear();
  shape.color = kEstimate;
  PreviewObject points;
  points.mesh = pointsMesh(sampleSurface(truth, style.points, kPointSeed).points,
                           0.004 * bounds(truth).diagonal().norm());
  points.color = {16, 16, 16};
  PreviewStyle paper;
  paper.floor = false;
  paper.background = kPaper;
  return renderPreview({shape, points}, view.camera, view.T_object_camera, paper);
}

/// Mean distance of the true surface to an estimate [m].
double meanError(const Mesh& truth_world, const Raycaster& estimate, std::size_t samples) {
  const auto points = sampleSurface(truth_world, samples, kPointSeed).points;
  const double sum = parallelReduce(
      points.size(), 0.0, [&](std::size_t i) { return estimate.nearest(points[i]).distance; },
      [](double& total, double distance) { total += distance; });
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

/// The true surface, every pixel in the colour of its point's distance to the estimate.
Image<Rgb> errorTile(const Raycaster& truth, const Raycaster& estimate, const Mesh& truth_world,
                     const Viewpoint& view, const Transform& T_world_object, double max_error_m) {
  const Transform T_world_camera = T_world_object * view.T_object_camera;
  Image<Rgb> image(view.camera.width, view.camera.height, kPaper);
  parallelFor(static_cast<std::size_t>(image.height()), [&](std::size_t row) {
    const int v = static_cast<int>(row);
    for (int u = 0; u < image.width(); ++u) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int s = 0; s < kSamplesPerSide * kSamplesPerSide; ++s) {
        const double du = (s % kSamplesPerSide + 0.5) / kSamplesPerSide - 0.5;
        const double dv = (s / kSamplesPerSide + 0.5) / kSamplesPerSide - 0.5;
        const Eigen::Vector3d direction =
            T_world_camera.linear() * view.camera.backproject(u + du, v + dv, 1).normalized();
        const Raycaster::Ray ray{T_world_camera.translation().cast<float>(),
                                 direction.cast<float>()};
        const Raycaster::Hit hit = truth.intersect(ray);
        if (!hit) {
          sum += Eigen::Vector3d(kPaper.r, kPaper.g, kPaper.b);
          continue;
        }
        const Eigen::Vector3d point =
            T_world_camera.translation() + static_cast<double>(hit.distance) * direction;
        const Rgb color = scaleColor(estimate.nearest(point).distance / max_error_m);
        const Eigen::Vector3i& face = truth_world.faces[hit.face];
        const auto corner = [&](int k) -> const Eigen::Vector3d& {
          return truth_world.vertices[static_cast<std::size_t>(face[k])];
        };
        const Eigen::Vector3d normal =
            (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        // Enough shade to see the shape, too little to change what a colour means.
        const double shade = 0.82 + 0.18 * std::abs(normal.dot(direction));
        sum += shade * Eigen::Vector3d(color.r, color.g, color.b);
      }
      const Eigen::Vector3d mean = sum / (kSamplesPerSide * kSamplesPerSide);
      image(u, v) = {static_cast<std::uint8_t>(std::lround(mean[0])),
                     static_cast<std::uint8_t>(std::lround(mean[1])),
                     static_cast<std::uint8_t>(std::lround(mean[2]))};
    }
  });
  return image;
}

void drawScale(Image<Rgb>& image, int top, double max_error_m) {
  const int width = std::min(420, image.width() - 2 * kNameWidth);
  const int left = (image.width() - width) / 2;
  constexpr int kHeight = 16;
  for (int i = 0; i < width; ++i) {
    for (int v = 0; v < kHeight; ++v) {
      image(left + i, top + v) = scaleColor((i + 0.5) / width);
    }
  }
  constexpr int kTicks = 4;
  for (int t = 0; t <= kTicks; ++t) {
    const int u = left + t * (width - 1) / kTicks;
    for (int v = kHeight; v < kHeight + 4; ++v) image(u, top + v) = kInk;
    const std::string text =
        fmt::format("{:g}{}", 100 * max_error_m * t / kTicks, t == kTicks ? "+ cm" : "");
    const int shift = t == kTicks ? textWidth("+ cm", kText) / 2 : 0;
    drawCentered(image, u + shift, top + kHeight + 8, text, kInk);
  }
}

/// Names are as wide as they are; what does not fit is cut.
std::string fitted(std::string text, int width) {
  while (text.size() > 4 && textWidth(text, kText) > width) text.resize(text.size() - 1);
  return text;
}

}  // namespace

Rgb scaleColor(double x) {
  static constexpr double kColors[][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                          {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                          {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
  constexpr auto kLast = std::size(kColors) - 1;
  const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(kLast);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kLast - 1);
  const double share = place - static_cast<double>(below);
  const auto channel = [&](int c) {
    return static_cast<std::uint8_t>(
        std::lround((1 - share) * kColors[below][c] + share * kColors[below + 1][c]));
  };
  return {channel(0), channel(1), channel(2)};
}

std::vector<ObjectComparison> compareObjects(const GroundTruth& truth,
                                             const std::vector<Prediction>& predictions,
                                             std::size_t count, double gate_m) {
  std::vector<const GroundTruthObject*> scored;
  std::vector<DetectionObject> truths;
  for (const GroundTruthObject& object : truth.objects) {
    if (!object.scored || object.mesh->empty()) continue;
    scored.push_back(&object);
    truths.push_back(
        detectionObject(object.id, object.label, transformed(object.T_world_object, *object.mesh)));
  }
  std::vector<ObjectComparison> all(scored.size());
  for (std::size_t g = 0; g < scored.size(); ++g) all[g].truth = scored[g];
  for (const Prediction& prediction : predictions) {
    std::vector<const Mesh*> meshes;
    std::vector<DetectionObject> estimates;
    for (const ObjectNode& node : prediction.graph.objects) {
      if (node.mesh.empty()) continue;
      meshes.push_back(&node.mesh);
      estimates.push_back(detectionObject(node.id, node.label, node.mesh));
    }
    const DetectionMatches matches = matchOneToOne(estimates, truths, Threshold::tau(gate_m));
    for (std::size_t g = 0; g < scored.size(); ++g) {
      const auto estimate = matches.estimate_of_truth[g];
      all[g].estimates.push_back(estimate ? meshes[*estimate] : nullptr);
    }
  }
  // How many of its variant come before each object.
  std::map<std::pair<Label, std::string>, std::size_t> met;
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t g = 0; g < all.size(); ++g) {
    order.emplace_back(met[{all[g].truth->label, all[g].truth->subtype}]++, g);
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(order.size(), count));
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    const auto key = [&](std::size_t g) {
      return std::tuple(all[g].truth->label, all[g].truth->subtype, g);
    };
    return key(a.second) < key(b.second);
  });
  std::vector<ObjectComparison> chosen;
  for (const auto& [nth, g] : order) chosen.push_back(all[g]);
  return chosen;
}

Image<Rgb> errorPicture(const std::vector<ObjectComparison>& objects,
                        const std::vector<std::string>& methods, const ErrorPictureStyle& style) {
  const int tile = style.tile_px;
  const int pair = 2 * tile + kGap;
  const auto columns = static_cast<int>(methods.size());
  const int row_height = tile + kGap;
  const int body = kHeadline + static_cast<int>(objects.size()) * row_height;
  Image<Rgb> image(kNameWidth + columns * (pair + kGap), body + kFootline, kPaper);
  const auto left = [&](int column) { return kNameWidth + column * (pair + kGap); };
  for (int c = 0; c < columns; ++c) {
    drawCentered(image, left(c) + pair / 2, 8, fitted(methods[static_cast<std::size_t>(c)], pair),
                 kInk);
  }
  for (std::size_t r = 0; r < objects.size(); ++r) {
    const ObjectComparison& object = objects[r];
    const int top = kHeadline + static_cast<int>(r) * row_height;
    const Mesh truth_world = transformed(object.truth->T_world_object, *object.truth->mesh);
    Raycaster truth;
    truth.add(truth_world);
    truth.commit();
    const Viewpoint view = viewpointOf(*object.truth, tile);
    drawText(image, 6, top + tile / 2 - 18, fitted(object.truth->name, kNameWidth - 12), kInk,
             kText);
    drawText(image, 6, top + tile / 2 + 4, object.truth->subtype, kFaintInk, 1);
    for (int c = 0; c < columns; ++c) {
      const Mesh* estimate = object.estimates[static_cast<std::size_t>(c)];
      if (!estimate) {
        drawCentered(image, left(c) + pair / 2, top + tile / 2 - 6, "not found", kFaintInk);
        continue;
      }
      Raycaster surface;
      surface.add(*estimate);
      surface.commit();
      paste(overlayTile(object, *estimate, view, style), left(c), top, image);
      const int right = left(c) + tile + kGap;
      paste(errorTile(truth, surface, truth_world, view, object.truth->T_world_object,
                      style.max_error_m),
            right, top, image);
      drawCentered(image, right + tile / 2, top + tile - 12,
                   fmt::format("{:.1f} cm", 100 * meanError(truth_world, surface, style.points)),
                   kInk);
    }
  }
  drawScale(image, body + 10, style.max_error_m);
  return image;
}

}  // namespace hydrabench
