// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "./data.js";
import {fill, h} from "./dom.js";
import * as state from "./state.js";
import {startTheme, themeButton} from "./theme.js";
import {claimsTab} from "./tabs/claims.js";
import {objectsTab} from "./tabs/objects.js";
import {sceneTab} from "./tabs/scene.js";
import {setupTab} from "./tabs/setup.js";
import {tableTab} from "./tabs/table.js";
import {thresholdsTab} from "./tabs/thresholds.js";
import {timingTab} from "./tabs/timing.js";

const kTabs = [
  ["table", "Table", tableTab],
  ["thresholds", json("sweep") ? "Sweep" : "Thresholds", thresholdsTab],
  ...(json("claims") ? [["claims", "Claims", claimsTab]] : []),
  ["objects", "Objects", objectsTab],
  ["scene", "Scene", sceneTab],
  ["timing", "Timing", timingTab],
  ["setup", "Setup", setupTab],
];

/** A tab is made when it is first looked at, and kept. */
function start() {
  startTheme();
  const setup = json("setup");
  const pages = new Map();
  const main = h("main", {});
  const buttons = kTabs.map(([key, title]) => h("button", {
    type: "button", role: "tab", id: "tab-" + key, "aria-controls": "page-" + key, onclick: () => state.set({tab: key})}, title));
  const bar = h("div", {role: "tablist", "aria-label": "Parts of the report", onkeydown: (event) => {
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!step) return;
    const at = kTabs.findIndex(([key]) => key === shown());
    const next = kTabs[(at + step + kTabs.length) % kTabs.length][0];
    state.set({tab: next});
    document.getElementById("tab-" + next).focus();
  }}, buttons);
  fill(document.getElementById("app"),
    h("header", {}, h("h1", {}, setup.name), bar, themeButton()), main);

  function shown() {
    const wanted = state.get("tab", json("sweep") ? "thresholds" : "table");
    return kTabs.some(([key]) => key === wanted) ? wanted : "table";
  }

  function draw() {
    const key = shown();
    kTabs.forEach(([name], i) => {
      buttons[i].setAttribute("aria-selected", String(name === key));
      buttons[i].tabIndex = name === key ? 0 : -1;
    });
    if (!pages.has(key)) {
      const page = h("section", {role: "tabpanel", id: "page-" + key, "aria-labelledby": "tab-" + key, class: "page page-" + key});
      main.append(page);
      pages.set(key, {page, tab: kTabs.find(([name]) => name === key)[2](page)});
    }
    const focus = main.contains(document.activeElement);
    for (const [name, {page}] of pages) page.hidden = name !== key;
    // A link of a page that is hidden now had it.
    if (focus && !pages.get(key).page.contains(document.activeElement)) document.getElementById("tab-" + key).focus();
    pages.get(key).tab?.onshow?.();
  }

  state.onChange((changed) => changed.has("tab") && draw());
  draw();
}

start();
