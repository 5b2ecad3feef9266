// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/simulation/campus_terrain.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// Adds the ground as one structure part per class, with lines painted on the road. Faces run along
/// every crease (kerbs, walls, steps, cheeks); between them the mesh keeps to the exact height
/// within 4 mm.
void buildCampusGround(const CampusTerrain& terrain, Scene& scene);

}  // namespace hydrabench
