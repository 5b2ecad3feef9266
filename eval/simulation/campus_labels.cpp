// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_labels.h"

namespace hydrabench {

LabelSpace campusLabelSpace() {
  namespace id = campus_label;
  return {{
      {kUnknownLabel, "unknown", {32, 32, 32}, false, false},
      {id::kRoad, "road", {128, 64, 128}, false, false, true},
      {id::kSidewalk, "sidewalk", {244, 35, 232}, false, false, true},
      {id::kGrass, "grass", {152, 221, 120}, false, false, true},
      {id::kStairs, "stairs", {196, 160, 120}, false, false, true},
      {id::kWall, "wall", {102, 102, 156}, false, false},
      {id::kBuilding, "building", {70, 70, 70}, false, false},
      {id::kTree, "tree", {107, 142, 35}, false, false},
      {id::kLampPole, "lamp_pole", {153, 153, 153}, false, false},
      {id::kBollard, "bollard", {90, 120, 150}, false, false},
      {id::kSign, "sign", {220, 220, 0}, false, false},
      {id::kFireHydrant, "fire_hydrant", {255, 60, 0}, true, true},
      {id::kCar, "car", {0, 60, 200}, true, true},
      {id::kBench, "bench", {250, 170, 30}, true, true},
  }};
}

}  // namespace hydrabench
