// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "../data.js";
import {fill, h} from "../dom.js";
import {kappaView} from "./kappa.js";
import {sweepView} from "./sweep.js";

/** Scores over the size-relative threshold, or over the settings of a sweep. */
export function thresholdsTab(page) {
  if (json("sweep")) sweepView(page, json("sweep"));
  else if (json("kappa")) kappaView(page, json("kappa"));
  else fill(page, h("p", {class: "empty"}, "No curves here: nothing was scored."));
  return {};
}
