// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {Mesh, Scene} from "three";
import {kOutcomes} from "../model.js";
import {methodLabel} from "../palette.js";
import {paint, surface} from "./layers.js";
import {addLamp} from "./viewer.js";

/**
 * An object by itself: the true surface in the colours of its distance to an estimate, and the estimate in those of its distance to the
 * true surface; or the true surface once per method. Cells for Viewer.setCells, with captions.
 */
export function heatmapCells(shapes, world, truth, methodName, {every, maxError}) {
  const cells = [];
  for (const method of world.methods) {
    if (!every && method.name !== methodName) continue;
    const found = method.ofTruth.get(truth);
    const match = found?.kind === "matched" ? method.matches.find((candidate) => candidate.truth === truth && candidate.object === found.object) : null;
    if (!match) {
      if (every) cells.push(cell(null, methodLabel(method.name), kOutcomes[found?.kind] ?? "not scored"));
      continue;
    }
    const true_mesh = world.truths[truth].mesh;
    const on_truth = shapes.distances(match.on_truth, true_mesh);
    const label = methodLabel(method.name);
    cells.push(cell(paint(shapes.paintable(true_mesh), on_truth, maxError), every ? label : "true surface: distance to " + label, summary(on_truth)));
    if (every) continue;
    const mesh = method.objects[match.object].mesh;
    const on_estimate = shapes.distances(match.on_estimate, mesh);
    cells.push(cell(paint(shapes.paintable(mesh), on_estimate, maxError), label + ": distance to the true surface", summary(on_estimate)));
  }
  return cells;
}

function cell(geometry, caption, detail) {
  const scene = new Scene();
  addLamp(scene);
  if (geometry) scene.add(new Mesh(geometry, surface(0xffffff, {vertexColors: true})));
  return {scene, caption, detail};
}

/** Of the vertices that are drawn; the scores are those of the table. */
function summary(millimetres) {
  const sorted = [...millimetres].sort((a, b) => a - b);
  const at = (share) => {
    const mm = sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
    return (mm >= 255 ? "≥ " : "") + (mm / 10).toFixed(1);
  };
  return "half within " + at(0.5) + " cm, 90\u00a0% within " + at(0.9) + "\u00a0cm";
}
