// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct, json, records} from "../data.js";
import {choice, copyButton, fill, h, select} from "../dom.js";
import {classText, fixed, interval, matchingText} from "../format.js";
import {methodTag} from "../palette.js";
import {sortableTable} from "../table.js";
import {significanceView} from "./significance.js";
import {strataView} from "./strata.js";

/** The comparison table: one block at a time, by dataset, threshold, matching and class. */
export function tableTab(page) {
  const tables = json("tables");
  const sweep = json("sweep");
  if (tables.length === 0) {
    fill(page, h("p", {class: "empty"}, sweep ? "The table of this sweep stands with its plots, under Sweep." : "Nothing was scored here: the datasets of this result have no ground truth."));
    return {};
  }
  const blocks = tables[0].blocks;
  const chosen = {
    dataset: blocks[0].dataset,
    threshold: String(blocks[0].threshold),
    matching: blocks.some((block) => block.matching === "one_to_one") ? "one_to_one" : blocks[0].matching,
    class: "all_micro",
  };
  draw();

  function draw() {
    const table = tables.find((candidate) => candidate.class === chosen.class);
    const block = table.blocks.find((b) => b.dataset === chosen.dataset && String(b.threshold) === chosen.threshold && b.matching === chosen.matching);
    const pick = (key) => (value) => { chosen[key] = value; draw(); };
    const datasets = distinct(blocks.map((b) => b.dataset));
    fill(page,
      h("div", {class: "controls"},
        datasets.length > 1 && select("dataset", datasets.map((d) => [d, d]), chosen.dataset, pick("dataset")),
        choice("centre within", distinct(blocks.map((b) => String(b.threshold))).map((t) => [t, t + " m"]), chosen.threshold, pick("threshold")),
        choice("matching", distinct(blocks.map((b) => b.matching)).map((m) => [m, matchingText(m), m]), chosen.matching, pick("matching")),
        select("class", tables.map((t) => [t.class, classText(t.class)]), chosen.class, pick("class")),
        h("div", {class: "spring"}),
        copyButton(() => table.csv, "Copy CSV"), copyButton(() => table.tex, "Copy TeX")),
      block ? comparison(table, block) : h("p", {class: "empty"}, "No scores for this choice."),
      h("details", {open: true}, h("summary", {}, "Notes"), h("ul", {class: "notes"}, table.notes.map((note) => h("li", {}, note)))),
      significanceView(records(json("significance")), chosen.dataset, Number(chosen.threshold)),
      strataView(records(json("strata")), chosen.dataset, Number(chosen.threshold)));
  }
  return {};
}

/** A block as a table; the best three of a column are marked, intervals drawn below each number. */
export function comparison(table, block) {
  const columns = [{key: "method", title: "method", width: "11rem", value: (row) => row.label, show: (row) => methodTag(row.method)}];
  table.columns.forEach((column, i) => {
    const counts = column.decimals === 0;
    const high = Math.max(1e-12, ...block.rows.map((row) => Math.max(row.cells[i][0] ?? 0, row.cells[i][2] ?? 0)));
    const scale = column.higher_is_better && column.decimals === 3 ? 1 : high;
    columns.push({
      key: column.metric, title: column.title, numeric: true, descendingFirst: column.higher_is_better, hint: column.metric,
      value: (row) => row.cells[i][0],
      cellClass: (row) => row.cells[i][3] ? "rank" + row.cells[i][3] : "",
      show: (row) => {
        const [value, low, up] = row.cells[i];
        const at = (x) => (100 * Math.min(1, Math.max(0, x / scale))).toFixed(1) + "%";
        return [h("span", {class: "value"}, fixed(value, column.decimals)),
          column.ranked && !counts && low !== null && [h("span", {class: "interval"}, interval(low, up, Math.max(2, column.decimals - 1))),
            h("span", {class: "whisker", "aria-hidden": "true"}, h("i", {style: "left:" + at(low) + ";right:calc(100% - " + at(up) + ")"}), h("b", {style: "left:" + at(value)}))]];
      },
    });
  });
  return sortableTable({columns, rows: block.rows, className: "comparison"});
}
