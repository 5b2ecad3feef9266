// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {fill, h} from "../dom.js";
import {centimetres, fixed} from "../format.js";

const kParts = {observed: 1, projected: 2, observedLine: 4, projectedLine: 8};
// As in the harness's pictures of rejections.
const kObserved = [40, 120, 230];
const kProjected = [240, 130, 20];
const kBoth = [50, 190, 90];

/** The view that a shape was estimated from: its picture with the observed mask, the projected one and their overlap. */
export function viewCard(shapes, candidate) {
  const scores = h("dl", {class: "scores"},
    [["overlap O", fixed(candidate.overlap)], ["coverage", fixed(candidate.coverage)], ["depth off", candidate.depth_residual_m === undefined || candidate.depth_residual_m === null ? "n/a" : centimetres(candidate.depth_residual_m) + " cm"], ["views", candidate.observations]]
      .map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value))));
  const verdict = h("p", {class: "verdict " + (candidate.accepted ? "yes" : "no")}, candidate.accepted ? "accepted by the consistency check" : "rejected: " + candidate.reason);
  if (!candidate.color) return h("div", {class: "view"}, verdict, scores);
  const shown = {observed: true, projected: true};
  const canvas = h("canvas", {role: "img", "aria-label": "best view with masks"});
  let images = null;
  const toggle = (key, text) => h("button", {type: "button", class: "key-" + key, "data-name": key, "aria-pressed": "true", onclick: (event) => {
    shown[key] = !shown[key];
    event.currentTarget.setAttribute("aria-pressed", String(shown[key]));
    draw();
  }}, text);

  Promise.all([shapes.picture(candidate.color, "image/jpeg"), shapes.picture(candidate.parts, "image/png")].map(async (blob) => pixels(await createImageBitmap(await blob))))
    .then((loaded) => { images = loaded; draw(); });

  function draw() {
    if (!images) return;
    const [color, parts] = images;
    canvas.width = color.width;
    canvas.height = color.height;
    const out = new ImageData(new Uint8ClampedArray(color.data), color.width, color.height);
    for (let i = 0; i < out.data.length; i += 4) {
      const bits = Math.round(parts.data[i] / 16);
      const seen = shown.observed && bits & kParts.observed;
      const hit = shown.projected && bits & kParts.projected;
      if (seen || hit) blend(out.data, i, seen && hit ? kBoth : seen ? kObserved : kProjected, 0.42);
      if (shown.projected && bits & kParts.projectedLine) blend(out.data, i, kProjected, 0.9);
      if (shown.observed && bits & kParts.observedLine) blend(out.data, i, kObserved, 0.9);
    }
    canvas.getContext("2d").putImageData(out, 0, 0);
  }

  return h("div", {class: "view"}, canvas,
    h("div", {class: "side"}, h("div", {class: "masks", role: "group", "aria-label": "masks shown"}, toggle("observed", "observed"), toggle("projected", "projected"), h("span", {class: "key-both"}, "both")), scores),
    verdict);
}

function pixels(bitmap) {
  const canvas = h("canvas", {width: bitmap.width, height: bitmap.height});
  const context = canvas.getContext("2d");
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

function blend(data, at, color, weight) {
  for (let c = 0; c < 3; ++c) data[at + c] = (1 - weight) * data[at + c] + weight * color[c];
}

/** All views of an object, one at a time: those that became it first, then those that were turned down nearby. */
export function viewPager(shapes, candidates) {
  let at = 0;
  const box = h("div", {});
  const draw = () => fill(box,
    candidates.length > 1 && h("p", {class: "pager"},
      h("button", {type: "button", "data-name": "previous view", "aria-label": "previous view", onclick: () => step(-1)}, "‹"), "view " + (at + 1) + " of " + candidates.length + ", track " + candidates[at].track,
      h("button", {type: "button", "data-name": "next view", "aria-label": "next view", onclick: () => step(1)}, "›")),
    viewCard(shapes, candidates[at]));
  const step = (by) => { at = (at + by + candidates.length) % candidates.length; draw(); };
  draw();
  return box;
}
