// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "eval/datasets/dataset.h"
#include "eval/evaluation/self_test_check.h"

namespace hydrabench {

/// Scores must not depend on the order of objects, on node ids or on the order of nodes in a file.
///
/// The prediction is one where order could matter: every third object is missing, every object is
/// off by a little of its own, every second one is there twice in the same place and once more
/// beside it. So that thousands of shuffles take minutes, objects are their boxes there, with 50
/// samples, no shifted grids and 20 resamples, and a box is prepared once; everything else is as in
/// `config`. Each shuffle draws another order and other ids for prediction and ground truth, writes
/// scene_graph.json, reads it back and scores it; not a byte of scores.csv may differ from what the
/// objects give unshuffled and prepared afresh. Deterministic for config.seed.
/// @param shuffles  at least 1
void checkShuffles(const std::string& dataset_name, const std::string& seed,
                   const LabelSpace& label_space, const GroundTruth& truth,
                   const EvaluationConfig& config, std::size_t shuffles, const AddCheck& add);

/// The objects in a random order, under new ids that are no longer consecutive.
void shuffle(Prediction& prediction, std::uint64_t seed, std::uint64_t stream);

}  // namespace hydrabench
