// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/office_labels.h"

namespace hydrabench {

LabelSpace officeLabelSpace(bool score_computers) {
  namespace id = office_label;
  return {{
      {kUnknownLabel, "unknown", {32, 32, 32}, false, false},
      {id::kBooks, "books", {250, 50, 50}, false, false},
      {id::kFloor, "floor", {124, 133, 141}, false, false},
      {id::kCeiling, "ceiling", {102, 0, 204}, false, false},
      {id::kChair, "chair", {102, 255, 0}, true, true},
      {id::kCouch, "couch", {39, 144, 65}, true, true},
      {id::kCabinet, "cabinet", {154, 229, 206}, false, false},
      {id::kComputer, "computer", {255, 23, 23}, true, score_computers},
      {id::kLamp, "lamp", {62, 146, 211}, false, false},
      {id::kPlant, "plant", {38, 112, 233}, true, true},
      {id::kSign, "sign", {175, 32, 45}, false, false},
      {id::kDesk, "desk", {54, 176, 239}, false, false},
      {id::kCubicle, "cubicle", {244, 228, 69}, false, false},
      {id::kBin, "bin", {154, 38, 91}, true, true},
      {id::kWall, "wall", {2, 103, 71}, false, false},
  }};
}

}  // namespace hydrabench
