// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {h} from "./dom.js";
import * as state from "./state.js";

/** Light or dark: as the system says, or as the reader chose. */
const listeners = new Set();
const system = matchMedia("(prefers-color-scheme: dark)");

export const isDark = () => (state.get("theme") || (system.matches ? "dark" : "light")) === "dark";
/** Calls back when it changes, until what is returned is called. */
export function onTheme(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

function apply() {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  for (const listener of listeners) listener();
}

export function startTheme() {
  apply();
  system.addEventListener("change", apply);
  state.onChange((changed) => changed.has("theme") && apply());
}

export function themeButton() {
  return h("button", {type: "button", class: "quiet", id: "theme", title: "Switch between light and dark",
    onclick: () => state.set({theme: isDark() ? "light" : "dark"})}, "Light / dark");
}
