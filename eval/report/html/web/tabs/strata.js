// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct} from "../data.js";
import {h} from "../dom.js";
import {fixed} from "../format.js";
import {methodTag, methodVariable} from "../palette.js";

/** Recall by how much of an object's surface was ever in view. */
export function strataView(rows, dataset, threshold) {
  const here = rows.filter((row) => row.dataset === dataset && row.threshold_m === threshold);
  if (here.length === 0) return null;
  const bins = distinct(here.map((row) => row.visible_from));
  const range = (from) => Math.round(100 * from) + "–" + Math.round(100 * here.find((row) => row.visible_from === from).visible_to) + " %";
  return h("section", {class: "block"},
    h("h2", {}, "Recall by visible share of the surface"),
    h("div", {class: "scroll"}, h("table", {class: "data strata"},
      h("thead", {}, h("tr", {}, h("th", {}, "method"), bins.map((from) => {
        const truths = here.find((row) => row.visible_from === from).truths;
        return h("th", {class: "num"}, range(from) + " in view", h("small", {}, truths + " objects"));
      }))),
      h("tbody", {}, distinct(here.map((row) => row.method)).map((method) => h("tr", {}, h("th", {scope: "row"}, methodTag(method)), bins.map((from) => {
        const row = here.find((r) => r.method === method && r.visible_from === from);
        if (!row || row.recall === null) return h("td", {class: "num"}, "n/a");
        return h("td", {class: "num", title: "interval " + fixed(row.recall_ci95_low, 2) + "–" + fixed(row.recall_ci95_high, 2) + ", B-IoU " + fixed(row.b_iou, 2) + ", V-IoU " + fixed(row.v_iou_solid, 2)},
          h("span", {class: "bar", style: "--w:" + 100 * row.recall + "%;--c:" + methodVariable(method)}), h("span", {class: "value"}, fixed(row.recall, 2)),
          h("small", {}, row.found_truths + " of " + row.truths));
      })))))),
    h("p", {class: "hint"}, "One to one; the mean IoUs of what was found stand in each cell's tooltip."));
}
