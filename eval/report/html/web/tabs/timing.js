// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct, json, records} from "../data.js";
import {fill, h, select} from "../dom.js";
import {milliseconds} from "../format.js";
import {methodTag, methodVariable} from "../palette.js";
import {sortableTable} from "../table.js";

/** Time per frame and per stage. */
export function timingTab(page) {
  const rows = records(json("timing"));
  if (rows.length === 0) {
    fill(page, h("p", {class: "empty"}, "No times here: they are taken by 'run' and 'map'."));
    return {};
  }
  const worldOf = (row) => row.dataset + "/" + row.seed;
  const worlds = distinct(rows.map(worldOf));
  let chosen = worlds[0];
  draw();

  function draw() {
    const here = rows.filter((row) => worldOf(row) === chosen);
    const frames = here.filter((row) => row.stage === "frame");
    const longest = Math.max(...frames.map((row) => row.p99_ms));
    const period = json("scene").frame_period_s?.[here[0].dataset];
    const share = (ms) => (100 * ms / longest).toFixed(2) + "%";
    const realTime = (frame) => {
      const finish = here.find((row) => row.method === frame.method && row.stage === "finish");
      return period ? frame.n * period / ((frame.n * frame.mean_ms + (finish?.mean_ms ?? 0)) / 1e3) : null;
    };
    fill(page,
      worlds.length > 1 && h("div", {class: "controls"}, select("world", worlds.map((w) => [w, w]), chosen, (w) => { chosen = w; draw(); })),
      h("section", {class: "block"},
        h("h2", {}, "Time per frame"),
        h("div", {class: "scroll"}, h("table", {class: "data timing"},
          h("thead", {}, h("tr", {}, h("th", {}, "method"), h("th", {class: "grow"}, h("span", {class: "key solid"}, "median"), h("span", {class: "key half"}, "90 %"), h("span", {class: "key light"}, "99 % of the frames")),
            ["p50", "p90", "p99", "max"].map((p) => h("th", {class: "num"}, p + " [ms]")), period && h("th", {class: "num", title: "at " + (1 / period).toFixed(0) + " frames a second, the end of the run included"}, "× real time"))),
          h("tbody", {}, frames.map((row) => h("tr", {}, h("th", {scope: "row"}, methodTag(row.method)),
            h("td", {class: "grow"}, h("span", {class: "spread", style: "--c:" + methodVariable(row.method), "aria-hidden": "true"},
              h("i", {class: "light", style: "width:" + share(row.p99_ms)}), h("i", {class: "half", style: "width:" + share(row.p90_ms)}), h("i", {class: "solid", style: "width:" + share(row.p50_ms)}))),
            [row.p50_ms, row.p90_ms, row.p99_ms, row.max_ms].map((ms) => h("td", {class: "num"}, milliseconds(ms))),
            period && h("td", {class: "num"}, realTime(row).toFixed(1))))))),
        h("p", {class: "hint"}, "Wall clock; frames are made or read outside the clock, the first ten are left out."
          + (period ? " Real time: " + (1 / period).toFixed(0) + " frames a second, what a method does after the last frame included." : ""))),
      h("section", {class: "block"},
        h("h2", {}, "Stages"),
        sortableTable({sort: "share", descending: true, rows: here, columns: [
          {key: "method", title: "method", value: (row) => row.method, show: (row) => methodTag(row.method)},
          {key: "stage", title: "stage", value: (row) => row.stage},
          {key: "n", title: "calls", numeric: true, value: (row) => row.n, descendingFirst: true},
          ...["mean_ms", "p50_ms", "p90_ms", "p99_ms", "max_ms"].map((key) => ({key, title: key.replace("_ms", " [ms]"), numeric: true, descendingFirst: true, value: (row) => row[key], show: (row) => milliseconds(row[key])})),
          {key: "share", title: "sum [s]", numeric: true, descendingFirst: true, value: (row) => row.n * row.mean_ms / 1e3, show: (row) => (row.n * row.mean_ms / 1e3).toFixed(1)},
          {key: "cpu_s", title: "CPU [s]", numeric: true, descendingFirst: true, value: (row) => row.cpu_s, show: (row) => row.cpu_s.toFixed(1)},
        ]}),
        h("p", {class: "hint"}, "Peak memory of the whole process, world and all methods: " + (Math.max(...here.map((row) => row.peak_rss_mib)) / 1024).toFixed(1) + " GiB.")));
  }
  return {};
}
