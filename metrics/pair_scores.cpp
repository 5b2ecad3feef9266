// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/pair_scores.h"

#include <array>
#include <cassert>
#include <vector>

#include "metrics/surface_distance.h"

namespace hydrabench {
namespace {

using enum ScoreDirection;

constexpr std::array kColumns = {
    PairScoreColumn{"chamfer_sq", "m^2", kLowerIsBetter, &PairScores::chamfer_sq},
    PairScoreColumn{"chamfer_sq_floor", "m^2", kReference, &PairScores::chamfer_sq_floor},
    PairScoreColumn{"chamfer_l1", "m", kLowerIsBetter, &PairScores::chamfer_l1},
    PairScoreColumn{"accuracy", "m", kLowerIsBetter, &PairScores::accuracy},
    PairScoreColumn{"completeness", "m", kLowerIsBetter, &PairScores::completeness},
    PairScoreColumn{"f_score_1cm", "1", kHigherIsBetter, &PairScores::f_score_1cm},
    PairScoreColumn{"f_score_2cm", "1", kHigherIsBetter, &PairScores::f_score_2cm},
    PairScoreColumn{"f_score_5cm", "1", kHigherIsBetter, &PairScores::f_score_5cm},
    PairScoreColumn{"f_score_1pct", "1", kHigherIsBetter, &PairScores::f_score_1pct},
    PairScoreColumn{"f_score_2pct", "1", kHigherIsBetter, &PairScores::f_score_2pct},
    PairScoreColumn{"f_score_5pct", "1", kHigherIsBetter, &PairScores::f_score_5pct},
    PairScoreColumn{"b_iou", "1", kHigherIsBetter, &PairScores::b_iou},
    PairScoreColumn{"obb_iou", "1", kHigherIsBetter, &PairScores::obb_iou},
    PairScoreColumn{"v_iou_solid", "1", kHigherIsBetter, &PairScores::v_iou_solid},
    PairScoreColumn{"v_iou_solid_jitter_mean", "1", kReference,
                    &PairScores::v_iou_solid_jitter_mean},
    PairScoreColumn{"v_iou_solid_jitter_std", "1", kReference, &PairScores::v_iou_solid_jitter_std},
    PairScoreColumn{"v_iou_surface", "1", kHigherIsBetter, &PairScores::v_iou_surface},
    PairScoreColumn{"v_iou_surface_jitter_mean", "1", kReference,
                    &PairScores::v_iou_surface_jitter_mean},
    PairScoreColumn{"v_iou_surface_jitter_std", "1", kReference,
                    &PairScores::v_iou_surface_jitter_std},
};

void scoreDistances(const ObjectModel& estimate, const ObjectModel& truth, PairScores& scores) {
  const SurfaceDistances distances = surfaceDistances(estimate, truth);
  scores.chamfer_sq = chamferSq(estimate, truth);
  scores.chamfer_sq_floor = truth.samplingFloor();
  scores.chamfer_l1 = chamferL1(distances);
  scores.accuracy = accuracy(distances);
  scores.completeness = completeness(distances);

  const double percent_m = 0.01 * 2 * truth.halfDiagonal();
  scores.f_score_1cm = fScore(countWithin(distances, 0.01));
  scores.f_score_2cm = fScore(countWithin(distances, 0.02));
  scores.f_score_5cm = fScore(countWithin(distances, 0.05));
  scores.f_score_1pct = fScore(countWithin(distances, 1 * percent_m));
  scores.f_score_2pct = fScore(countWithin(distances, 2 * percent_m));
  scores.f_score_5pct = fScore(countWithin(distances, 5 * percent_m));
}

void scoreWithoutEstimate(const ObjectModel& truth, PairScores& scores) {
  scores.chamfer_sq_floor = truth.samplingFloor();
  for (const PairScoreColumn& column : kColumns) {
    if (column.direction == kHigherIsBetter) scores.*column.value = 0.0;
  }
}

/// The value on the common grid, and mean and deviation over it and the jittered ones.
void scoreVoxels(std::span<const std::optional<VoxelSet>> estimate,
                 std::span<const std::optional<VoxelSet>> truth, std::optional<double>& value,
                 std::optional<double>& jitter_mean, std::optional<double>& jitter_std) {
  assert(estimate.size() == truth.size() && !truth.empty());
  std::vector<std::optional<double>> values(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (estimate[i] && truth[i]) values[i] = voxelIou(*estimate[i], *truth[i]);
  }
  value = values.front();
  if (const std::optional<OriginSpread> spread = originSpread(values)) {
    jitter_mean = spread->mean;
    jitter_std = spread->deviation;
  }
}

}  // namespace

std::optional<double> PairScoreColumn::worst(double half_diagonal) const {
  if (direction == kReference) return std::nullopt;
  if (direction == kHigherIsBetter) return 0.0;
  const double farthest = 2 * half_diagonal;
  return unit == "m^2" ? 2 * farthest * farthest : farthest;
}

std::span<const PairScoreColumn> pairScoreColumns() { return kColumns; }

const PairScoreColumn* findPairScoreColumn(std::string_view name) {
  for (const PairScoreColumn& column : kColumns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

PairScores scorePair(const ObjectModel& estimate, const ObjectModel& truth) {
  PairScores scores;
  if (!truth.hasSurface()) return scores;
  if (!estimate.hasSurface()) {
    scoreWithoutEstimate(truth, scores);
    return scores;
  }
  scoreDistances(estimate, truth, scores);
  scores.b_iou = boxIou(estimate.box(), truth.box());
  scores.obb_iou = orientedBoxIou(estimate.orientedBox(), truth.orientedBox());
  scoreVoxels(estimate.solidVoxels(), truth.solidVoxels(), scores.v_iou_solid,
              scores.v_iou_solid_jitter_mean, scores.v_iou_solid_jitter_std);
  scoreVoxels(estimate.surfaceVoxels(), truth.surfaceVoxels(), scores.v_iou_surface,
              scores.v_iou_surface_jitter_mean, scores.v_iou_surface_jitter_std);
  return scores;
}

}  // namespace hydrabench
