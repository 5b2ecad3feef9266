// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

struct PictureSize {
  int width = 1600;  ///< [px]
  int height = 1000;
};

/// The whole world from above at a slant. Generated worlds are drawn with their materials and
/// without ceilings; others from their ground-truth meshes, objects in the colour of their class.
Image<Rgb> worldPicture(const Dataset& dataset, const PictureSize& size = {});

/// A prediction from the same side: scene mesh in grey, objects in the colour of their class; one
/// without a mesh as its box.
Image<Rgb> predictionPicture(const SceneGraph& graph, const PictureSize& size = {});

/// The scene mesh alone in its own colours, from the same side.
Image<Rgb> sceneMeshPicture(const SceneGraph& graph, const PictureSize& size = {});

/// The first `count` objects of a prediction that have a mesh, each by itself in its own colours.
Image<Rgb> objectSheet(const SceneGraph& graph, std::size_t count = 40);

/// The first `count` scored objects of a dataset, each by itself with its name.
Image<Rgb> objectSheet(const Dataset& dataset, std::size_t count = 40);

}  // namespace hydrabench
