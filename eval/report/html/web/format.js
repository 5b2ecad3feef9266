// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT

/** Numbers as text; what is undefined is n/a, never 0. */
export const fixed = (value, decimals = 3) => value === null || value === undefined ? "n/a" : value.toFixed(decimals);
export const percent = (value) => value === null || value === undefined ? "n/a" : Math.round(100 * value) + " %";
export const centimetres = (metres) => metres === null || metres === undefined ? "n/a" : (100 * metres).toFixed(1);
export const milliseconds = (value) => value === null || value === undefined ? "n/a" : value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
export const interval = (low, high, decimals) => low === null || high === null ? "" : low.toFixed(decimals) + "–" + high.toFixed(decimals);

const kMatchings = {exists: "many to one", one_to_one: "one to one"};
export const matchingText = (matching) => kMatchings[matching] ?? matching;
export const thresholdText = (kind, value) => kind === "kappa" ? "κ " + value : value + " m";
const kClasses = {all_micro: "all objects", all_macro: "mean over classes"};
export const classText = (name) => kClasses[name] ?? name;
