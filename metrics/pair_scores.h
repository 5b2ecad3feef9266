// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "metrics/object_model.h"

namespace hydrabench {

/// Every geometric score of one estimate against one truth. pairScoreColumns() says what each is.
///
/// A truth without a surface has nothing to compare with: all undefined. An estimate without one
/// scores 0 in every IoU and F-score, and its distances are undefined. v_iou is also undefined
/// where no cell is solid in either mesh (two open sheets) or where a mesh is too large for the
/// grid.
struct PairScores {
  std::optional<double> chamfer_sq;
  std::optional<double> chamfer_sq_floor;
  std::optional<double> chamfer_l1;
  std::optional<double> accuracy;
  std::optional<double> completeness;
  std::optional<double> f_score_1cm;
  std::optional<double> f_score_2cm;
  std::optional<double> f_score_5cm;
  std::optional<double> f_score_1pct;  ///< of the truth's whole diagonal, 2 d_diag
  std::optional<double> f_score_2pct;
  std::optional<double> f_score_5pct;
  std::optional<double> b_iou;
  std::optional<double> obb_iou;
  std::optional<double> v_iou_solid;  ///< on the grid of the config
  std::optional<double> v_iou_solid_jitter_mean;
  std::optional<double> v_iou_solid_jitter_std;
  std::optional<double> v_iou_surface;
  std::optional<double> v_iou_surface_jitter_mean;
  std::optional<double> v_iou_surface_jitter_std;

  friend bool operator==(const PairScores&, const PairScores&) = default;
};

enum class ScoreDirection {
  kHigherIsBetter,
  kLowerIsBetter,
  kReference,  ///< says how to read another score; has no best, no worst, and no mean over all
               ///< ground truth
};

/// One score, declared once: tables, CSV columns, means and intervals iterate over the list.
struct PairScoreColumn {
  std::string_view name;  ///< as in scores.csv
  std::string_view unit;  ///< "m", "m^2" or "1"
  ScoreDirection direction = ScoreDirection::kReference;
  std::optional<double> PairScores::*value = nullptr;

  /// What a missed truth of this half diagonal [m] scores, and the cap for found ones: 0 where
  /// higher is better; a distance of 2 d_diag, that is 2 d_diag for means of distances and 2 (2
  /// d_diag)^2 for chamfer_sq, which adds two mean squares. nullopt for references.
  std::optional<double> worst(double half_diagonal) const;
};
std::span<const PairScoreColumn> pairScoreColumns();
const PairScoreColumn* findPairScoreColumn(std::string_view name);  ///< nullptr: no such score

/// Both models must be prepared with the same config. Pure; safe to call from several threads on
/// the same models.
PairScores scorePair(const ObjectModel& estimate, const ObjectModel& truth);

}  // namespace hydrabench
