// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {chart} from "../chart.js";
import {distinct} from "../data.js";
import {choice, copyButton, fill, h, select} from "../dom.js";
import {matchingText} from "../format.js";
import {cssColor} from "../palette.js";
import {sortableTable} from "../table.js";
import {comparison} from "./table.js";

/** A sweep: its plots over the first axis and its table, or the exact steps of tau_O. */
export function sweepView(page, sweep) {
  if (sweep.table) grid(page, sweep);
  for (const picture of sweep.pictures ?? []) {
    page.append(h("figure", {class: "picture"}, h("figcaption", {}, picture.name), h("img", {src: "data:image/svg+xml;base64," + picture.svg, alt: "plot " + picture.name})));
  }
  for (const {name, table} of sweep.tables ?? []) {
    const columns = table.columns.map((title, i) => ({key: title, title, numeric: table.rows.every((row) => row[i] === null || typeof row[i] === "number"), value: (row) => row[i],
      show: (row) => (typeof row[i] === "number" ? String(Number(row[i].toPrecision(4))) : row[i] ?? "n/a")}));
    page.append(h("h2", {}, name), sortableTable({columns, rows: table.rows, sort: null, limit: 100}));
  }
}

function grid(page, sweep) {
  const datasets = distinct(sweep.plots.map((plot) => plot.dataset));
  const chosen = {dataset: datasets[0], matching: "one_to_one", threshold: String(sweep.table.blocks[0]?.threshold)};
  const body = h("div", {});
  page.append(body);
  let charts = [];
  draw();

  function draw() {
    for (const old of charts) old.destroy();
    const pick = (key) => (value) => { chosen[key] = value; draw(); };
    const plot = sweep.plots.find((p) => p.dataset === chosen.dataset && p.matching === chosen.matching);
    const block = sweep.table.blocks.find((b) => b.dataset === chosen.dataset && String(b.threshold) === chosen.threshold && b.matching === chosen.matching);
    const labels = distinct(plot.panels.flatMap((panel) => panel.curves.map((curve) => curve.label)));
    const color = (label) => cssColor("--m" + (labels.indexOf(label) % 8));
    charts = plot.panels.map((panel) => chart({title: panel.title, xLabel: panel.x_label, xRange: panel.x_range,
      curves: panel.curves.map((curve) => ({...curve, color: () => color(curve.label), steps: false}))}));
    fill(body,
      h("div", {class: "controls"},
        datasets.length > 1 && select("dataset", datasets.map((d) => [d, d]), chosen.dataset, pick("dataset")),
        choice("matching", distinct(sweep.plots.map((p) => p.matching)).map((m) => [m, matchingText(m), m]), chosen.matching, pick("matching"))),
      h("p", {class: "legend"}, labels.map((label) => h("span", {class: "method"}, h("span", {class: "swatch", style: "--c:var(--m" + (labels.indexOf(label) % 8) + ")"}), label))),
      h("div", {class: "charts"}, charts.map((c) => c.element)),
      h("div", {class: "controls"},
        choice("centre within", distinct(sweep.table.blocks.map((b) => String(b.threshold))).map((t) => [t, t + " m"]), chosen.threshold, pick("threshold")),
        h("div", {class: "spring"}), copyButton(() => sweep.table.csv, "Copy CSV"), copyButton(() => sweep.table.tex, "Copy TeX")),
      block && comparison(sweep.table, block));
  }
}
