// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "eval/evaluation/score_rows.h"
#include "metrics/scene_tally.h"

namespace hydrabench {

inline constexpr const char* kSceneClass = "scene";

/// Rows of scores.csv for the map as a whole, class "scene": intervals are drawn over the squares.
/// None without tallies.
std::vector<ScoreRow> sceneRows(const ScoreContext& context,
                                const std::vector<SceneTally>& tallies);

}  // namespace hydrabench
