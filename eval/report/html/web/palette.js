// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "./data.js";
import {h} from "./dom.js";

/** One colour per method everywhere, those of style.css: apart for the colour-blind, in light and dark. */
const kColors = 8;

const place = (name) => Math.max(0, json("methods").findIndex((method) => method.name === name));
export const methodVariable = (name) => "var(--m" + (place(name) % kColors) + ")";
export const methodColor = (name) => cssColor("--m" + (place(name) % kColors));
/** Past eight methods colours repeat; dashes then tell them apart. */
export const methodDash = (name) => (place(name) >= kColors || isBound(name) ? [6, 4] : []);
export const methodLabel = (name) => json("methods").find((method) => method.name === name)?.label ?? name;
export const isBound = (name) => json("methods").find((method) => method.name === name)?.bound ?? false;
export const cssColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const swatch = (name) => h("span", {class: "swatch" + (isBound(name) ? " bound" : ""), style: "--c:" + methodVariable(name)});
const isKnown = (name) => json("methods").some((method) => method.name === name);
/** Rows of a sweep are no methods of their own: they have no colour. */
export const methodTag = (name) => h("span", {class: "method"}, isKnown(name) && swatch(name), methodLabel(name));

/** Classes have colours of their own, from the other end of the list. */
export function classColor(name, classes) {
  return cssColor("--m" + ((2 * kColors - 1 - classes.indexOf(name)) % kColors));
}

/** viridis at x in [0, 1], [r, g, b] in 0..255: the scale of the harness's other error pictures. */
const kViridis = [[68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140], [40, 174, 128], [94, 201, 98], [173, 220, 48], [253, 231, 37]];
export function scaleColor(x) {
  const at = Math.min(Math.max(x, 0), 1) * (kViridis.length - 1);
  const i = Math.min(Math.floor(at), kViridis.length - 2);
  return kViridis[i].map((from, c) => Math.round(from + (at - i) * (kViridis[i + 1][c] - from)));
}
export const scaleGradient = () => "linear-gradient(to right," + kViridis.map((c) => "rgb(" + c + ")").join(",") + ")";
