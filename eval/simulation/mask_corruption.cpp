// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/mask_corruption.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/simulation/noise_field.h"

namespace hydrabench {
namespace {

constexpr std::size_t kRowsPerTask = 16;
// Streams of random numbers within a frame.
constexpr std::uint64_t kWarpU = 1;
constexpr std::uint64_t kWarpV = 2;
constexpr std::uint64_t kShuffle = 3;
constexpr std::uint64_t kMerge = 4;
constexpr std::uint64_t kObject = 16;

/// One object in the true image.
struct Extent {
  std::int64_t pixels = 0;
  double sum_u = 0;
  double sum_v = 0;
};

/// What becomes of an object's pixels. Piece 2 i is the whole mask of object i or one half of it, 2
/// i + 1 the other half.
struct Fate {
  bool missed = false;
  bool split = false;
  double line_u = 0;  ///< pixels with line_u u + line_v v > line_c go to the second piece
  double line_v = 0;
  double line_c = 0;
  Label label = kUnknownLabel;
};

std::vector<Extent> measure(const Image<std::int32_t>& objects, std::size_t num_objects) {
  std::vector<Extent> extents(num_objects);
  for (int v = 0; v < objects.height(); ++v) {
    for (int u = 0; u < objects.width(); ++u) {
      const std::int32_t object = objects(u, v);
      if (object < 0) continue;
      Extent& extent = extents[static_cast<std::size_t>(object)];
      ++extent.pixels;
      extent.sum_u += u;
      extent.sum_v += v;
    }
  }
  return extents;
}

Label otherLabel(Label label, const std::set<Label>& labels, Random& random) {
  if (labels.size() < 2) return label;
  auto choice =
      std::next(labels.begin(), random.index(static_cast<std::uint32_t>(labels.size() - 1)));
  // Skips the true label without favouring its neighbour.
  if (*choice >= label) ++choice;
  return *choice;
}

/// Pairs of objects of one class whose pixels touch, ascending.
std::set<std::pair<std::int32_t, std::int32_t>> touchingPairs(const Image<std::int32_t>& objects,
                                                              const std::vector<Label>& labels) {
  std::set<std::pair<std::int32_t, std::int32_t>> pairs;
  const auto consider = [&](std::int32_t a, std::int32_t b) {
    if (a == b || a < 0 || b < 0) return;
    if (labels[static_cast<std::size_t>(a)] == labels[static_cast<std::size_t>(b)]) {
      pairs.insert(std::minmax(a, b));
    }
  };
  for (int v = 0; v < objects.height(); ++v) {
    for (int u = 0; u < objects.width(); ++u) {
      if (u + 1 < objects.width()) consider(objects(u, v), objects(u + 1, v));
      if (v + 1 < objects.height()) consider(objects(u, v), objects(u, v + 1));
    }
  }
  return pairs;
}

std::vector<Fate> drawFates(const std::vector<Extent>& extents,
                            const std::vector<Label>& object_labels,
                            const MaskCorruptionConfig& config, std::uint64_t seed) {
  const std::set<Label> all_labels(object_labels.begin(), object_labels.end());
  std::vector<Fate> fates(extents.size());
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const Extent& extent = extents[i];
    if (extent.pixels == 0) continue;
    Random random(hashSeed(seed, kObject), i);
    Fate& fate = fates[i];
    fate.label = object_labels[i];
    fate.missed = random.chance(config.miss_probability) || extent.pixels < config.min_pixels;
    if (random.chance(config.confusion_probability)) {
      fate.label = otherLabel(fate.label, all_labels, random);
    }
    fate.split = random.chance(config.split_probability);
    const double angle = random.uniform(0, std::numbers::pi);
    fate.line_u = std::cos(angle);
    fate.line_v = std::sin(angle);
    const auto count = static_cast<double>(extent.pixels);
    fate.line_c = (fate.line_u * extent.sum_u + fate.line_v * extent.sum_v) / count;
  }
  return fates;
}

/// For every piece the piece it is merged into (itself, mostly).
std::vector<std::size_t> drawMerges(const Image<std::int32_t>& objects,
                                    const std::vector<Label>& labels,
                                    const std::vector<Extent>& extents, double probability,
                                    std::uint64_t seed) {
  std::vector<std::size_t> target(2 * labels.size());
  std::iota(target.begin(), target.end(), 0);
  if (probability <= 0) return target;
  for (const auto& [a, b] : touchingPairs(objects, labels)) {
    const auto first = static_cast<std::size_t>(a);
    const auto second = static_cast<std::size_t>(b);
    Random random(hashSeed(seed, kMerge), first * labels.size() + second);
    if (!random.chance(probability)) continue;
    const bool keep_first = extents[first].pixels >= extents[second].pixels;
    const std::size_t kept = target[2 * (keep_first ? first : second)];
    const std::size_t gone = target[2 * (keep_first ? second : first)];
    // Chains of merges end in one piece: everything that pointed at the loser follows.
    std::replace(target.begin(), target.end(), gone, kept);
  }
  return target;
}

}  // namespace

MaskCorruptionConfig MaskCorruptionConfig::off() {
  MaskCorruptionConfig config;
  config.boundary_jitter_px = config.miss_probability = config.split_probability = 0;
  config.merge_probability = config.confusion_probability = 0;
  config.min_pixels = 0;
  return config;
}

void read(ConfigReader& reader, MaskCorruptionConfig& config) {
  reader.field("boundary_jitter_px", config.boundary_jitter_px, {0, 50});
  reader.field("boundary_correlation_px", config.boundary_correlation_px, {1, 1000});
  reader.field("miss_probability", config.miss_probability, {0, 1});
  reader.field("split_probability", config.split_probability, {0, 1});
  reader.field("merge_probability", config.merge_probability, {0, 1});
  reader.field("confusion_probability", config.confusion_probability, {0, 1});
  reader.field("min_pixels", config.min_pixels, {0, 1e6});
}

Segmentation corruptMasks(const Image<std::int32_t>& objects, const Image<Label>& labels,
                          const std::vector<Label>& object_labels,
                          const MaskCorruptionConfig& config, std::uint64_t seed) {
  const int width = objects.width();
  const int height = objects.height();
  const std::vector<Extent> extents = measure(objects, object_labels.size());
  const std::vector<Fate> fates = drawFates(extents, object_labels, config, seed);
  const std::vector<std::size_t> target =
      drawMerges(objects, object_labels, extents, config.merge_probability, seed);

  // Outlines move because every pixel is looked up at a displaced place.
  std::optional<NoiseField> warp_u;
  std::optional<NoiseField> warp_v;
  const auto jitter = static_cast<float>(config.boundary_jitter_px);
  if (jitter > 0) {
    warp_u.emplace(width, height, config.boundary_correlation_px, hashSeed(seed, kWarpU));
    warp_v.emplace(width, height, config.boundary_correlation_px, hashSeed(seed, kWarpV));
  }
  Segmentation result;
  result.labels = Image<Label>(width, height, kUnknownLabel);
  result.instances = Image<InstanceId>(width, height, kNoInstance);
  parallelForRanges(
      static_cast<std::size_t>(height), kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v) {
          for (int u = 0; u < width; ++u) {
            int from_u = u;
            int from_v = v;
            if (jitter > 0) {
              from_u = std::clamp(u + nearestInt(jitter * warp_u->at(u, v)), 0, width - 1);
              from_v = std::clamp(v + nearestInt(jitter * warp_v->at(u, v)), 0, height - 1);
            }
            const std::int32_t object = objects(from_u, from_v);
            if (object < 0) {
              result.labels(u, v) = labels(from_u, from_v);
              continue;
            }
            const auto index = static_cast<std::size_t>(object);
            const Fate& fate = fates[index];
            if (fate.missed) continue;
            const bool second = fate.split && fate.line_u * u + fate.line_v * v > fate.line_c;
            const std::size_t piece = target[2 * index + (second ? 1 : 0)];
            result.instances(u, v) = static_cast<InstanceId>(piece + 1);
            result.labels(u, v) = fates[piece / 2].label;
          }
        }
      });

  // Pieces that still have pixels get the ids 1 .. n in random order.
  std::vector<InstanceId> id_of_piece(2 * object_labels.size() + 1, 0);
  for (const InstanceId piece : result.instances) id_of_piece[static_cast<std::size_t>(piece)] = 1;
  std::vector<std::size_t> pieces;
  for (std::size_t piece = 1; piece < id_of_piece.size(); ++piece) {
    if (id_of_piece[piece] != 0) pieces.push_back(piece);
  }
  Random random(seed, kShuffle);
  for (std::size_t i = pieces.size(); i > 1; --i) {
    std::swap(pieces[i - 1], pieces[random.index(static_cast<std::uint32_t>(i))]);
  }
  id_of_piece[0] = kNoInstance;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto id = static_cast<InstanceId>(i + 1);
    id_of_piece[pieces[i]] = id;
    result.instance_labels[id] = fates[(pieces[i] - 1) / 2].label;
  }
  for (InstanceId& piece : result.instances) piece = id_of_piece[static_cast<std::size_t>(piece)];
  return result;
}

}  // namespace hydrabench
