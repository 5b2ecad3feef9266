// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct} from "../data.js";
import {choice, fill, h} from "../dom.js";
import {fixed} from "../format.js";
import {methodTag} from "../palette.js";

const kMetrics = {f1: ["F1", 1], b_iou_all_gt: ["B-IoU all", 1], v_iou_solid_all_gt: ["V-IoU all", 1], chamfer_l1_all_gt: ["Chamfer L1 all", -1],
  b_iou: ["B-IoU", 1], v_iou_solid: ["V-IoU", 1], chamfer_l1: ["Chamfer L1", -1]};
const kLevel = 0.05;

/** Every pair of methods: is the row better than the column? Paired bootstrap, Holm's correction over the table. */
export function significanceView(rows, dataset, threshold) {
  const here = rows.filter((row) => row.dataset === dataset && row.threshold_m === threshold);
  if (here.length === 0) return null;
  const metrics = distinct(here.map((row) => row.metric));
  const chosen = {metric: metrics[0], show: "difference"};
  const box = h("section", {class: "block"});
  draw();
  return box;

  function draw() {
    const [, sign] = kMetrics[chosen.metric] ?? [chosen.metric, 1];
    const pairs = here.filter((row) => row.metric === chosen.metric);
    const scores = new Map();
    for (const row of pairs) scores.set(row.method_a, row.value_a).set(row.method_b, row.value_b);
    const methods = [...scores.keys()].sort((a, b) => sign * (scores.get(b) - scores.get(a)));
    const find = (a, b) => {
      const forth = pairs.find((row) => row.method_a === a && row.method_b === b);
      if (forth) return {...forth, d: forth.difference, low: forth.difference_ci95_low, high: forth.difference_ci95_high, above: forth.probability_a_above_b};
      const back = pairs.find((row) => row.method_a === b && row.method_b === a);
      return back && {...back, d: -back.difference, low: -back.difference_ci95_high, high: -back.difference_ci95_low,
        above: back.probability_a_above_b === null ? null : 1 - back.probability_a_above_b};
    };
    const cell = (a, b) => {
      const pair = a === b ? null : find(a, b);
      if (!pair) return h("td", {class: "same"});
      const sure = pair.p_holm < kLevel;
      const better = sign * pair.d > 0;
      const signed = (x) => (x > 0 ? "+" : x < 0 ? "−" : "") + Math.abs(x).toFixed(3);
      const text = chosen.show === "difference" ? signed(pair.d) : chosen.show === "p" ? (pair.p_holm < 0.001 ? "<0.001" : pair.p_holm.toFixed(3)) : fixed(pair.above, 2);
      return h("td", {class: "num " + (sure ? (better ? "better" : "worse") : "unsure"),
        title: "difference " + signed(pair.d) + " [" + signed(pair.low) + ", " + signed(pair.high) + "], p " + pair.p.toFixed(4) + ", Holm " + pair.p_holm.toFixed(4)}, text);
    };
    fill(box,
      h("h2", {}, "Is the row better than the column?"),
      h("div", {class: "controls"},
        choice("score", metrics.map((m) => [m, (kMetrics[m] ?? [m])[0], m]), chosen.metric, (m) => { chosen.metric = m; draw(); }),
        choice("cells", [["difference", "difference"], ["p", "p (Holm)"], ...(pairs.some((row) => row.probability_a_above_b !== null) ? [["above", "P(row ranks above)"]] : [])], chosen.show,
          (show) => { chosen.show = show; draw(); })),
      h("div", {class: "scroll"}, h("table", {class: "data matrix"},
        h("thead", {}, h("tr", {}, h("th", {}), h("th", {class: "num"}, "score"), methods.map((m) => h("th", {class: "num"}, methodTag(m))))),
        h("tbody", {}, methods.map((a) => h("tr", {}, h("th", {scope: "row"}, methodTag(a)), h("td", {class: "num"}, fixed(scores.get(a))), methods.map((b) => cell(a, b))))))),
      h("p", {class: "hint"}, "One to one, all objects. ", h("span", {class: "key better"}, "better"), " and ", h("span", {class: "key worse"}, "worse"),
        " where p < " + kLevel + " after Holm's correction over all pairs; else undecided. Intervals and p in each cell's tooltip."));
  }
}
