// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {chart} from "../chart.js";
import {distinct, records} from "../data.js";
import {checkbox, choice, fill, h, select} from "../dom.js";
import {fixed, matchingText} from "../format.js";
import {isBound, methodColor, methodDash, methodLabel, swatch} from "../palette.js";

const kScores = [["precision", "Precision"], ["recall", "Recall"], ["f1", "F1"]];

/** P, R and F1 over kappa: exact steps with their 95 % intervals, and a read-out at one kappa. */
export function kappaView(page, data) {
  const steps = records(data.steps);
  const intervals = records(data.intervals);
  const datasets = distinct(steps.map((row) => row.dataset));
  const matchings = distinct(steps.map((row) => row.matching));
  const chosen = {dataset: datasets[0], matching: matchings.includes("one_to_one") ? "one_to_one" : matchings[0], bands: true, kappa: 0.5,
    hidden: new Set()};
  const body = h("div", {});
  page.append(body);
  let charts = [];
  draw();

  function draw() {
    for (const old of charts) old.destroy();
    const here = (row) => row.dataset === chosen.dataset && row.matching === chosen.matching;
    const rows = steps.filter(here);
    const bands = intervals.filter(here);
    const methods = distinct(rows.map((row) => row.method));
    // The curves go on to the last estimate; means and intervals end at the largest kappa of the evaluation.
    const end = bands.length > 0 ? Math.max(...bands.map((row) => row.kappa)) : Math.min(1, Math.max(...rows.map((row) => row.kappa)));
    const of = new Map(methods.map((method) => [method, rows.filter((row) => row.method === method && row.kappa <= end)]));
    const readout = h("tbody", {});
    const slider = h("input", {type: "range", min: 0, max: end, step: end / 200, value: chosen.kappa, id: "kappa", "data-name": "kappa", oninput: (event) => read(Number(event.target.value))});
    const at = h("output", {for: "kappa"});

    charts = kScores.map(([score, title]) => chart({
      title, xLabel: "κ (share of half the object's diagonal)", xRange: [0, end], sync: "kappa", oncursor: (kappa) => read(kappa),
      curves: methods.filter((method) => !chosen.hidden.has(method)).map((method) => ({
        label: methodLabel(method), color: () => methodColor(method), dash: methodDash(method), steps: true,
        points: [...of.get(method).map((row) => [row.kappa, row[score]]), [end, of.get(method).at(-1)[score]]],
        band: chosen.bands ? bands.filter((row) => row.method === method && row[score + "_ci95_low"] !== null).map((row) => [row.kappa, row[score + "_ci95_low"], row[score + "_ci95_high"]]) : [],
      })),
    }));

    function read(kappa) {
      chosen.kappa = Math.min(Math.max(kappa, 0), end);
      slider.value = chosen.kappa;
      at.textContent = "κ = " + chosen.kappa.toFixed(3);
      fill(readout, methods.map((method) => {
        const list = of.get(method);
        // A step still has the value before it at its own kappa: the gate is strict.
        const row = list.findLast((step) => step.kappa < chosen.kappa) ?? list[0];
        return h("tr", {class: chosen.hidden.has(method) ? "faint" : ""},
          h("th", {scope: "row"}, checkbox(methodLabel(method), !chosen.hidden.has(method), (on) => { on ? chosen.hidden.delete(method) : chosen.hidden.add(method); draw(); }, swatch(method))),
          kScores.map(([score]) => h("td", {class: "num"}, fixed(row[score]))),
          kScores.map(([score]) => h("td", {class: "num"}, fixed(mean(list, score, end)))),
          h("td", {class: "num"}, row.matched_estimates + " of " + row.estimates), h("td", {class: "num"}, row.found_truths + " of " + row.truths));
      }));
    }

    read(chosen.kappa);
    const pick = (key) => (value) => { chosen[key] = value; draw(); };
    fill(body,
      h("div", {class: "controls"},
        datasets.length > 1 && select("dataset", datasets.map((d) => [d, d]), chosen.dataset, pick("dataset")),
        choice("matching", matchings.map((m) => [m, matchingText(m), m]), chosen.matching, pick("matching")),
        checkbox("95 % intervals", chosen.bands, pick("bands"))),
      h("div", {class: "charts"}, charts.map((c) => c.element)),
      h("div", {class: "controls"}, h("label", {class: "field wide"}, h("span", {}, "read at"), slider), at),
      h("div", {class: "scroll"}, h("table", {class: "data"},
        h("thead", {}, h("tr", {}, h("th", {}, "method"), kScores.map(([, title]) => h("th", {class: "num"}, title)),
          kScores.map(([, title]) => h("th", {class: "num"}, "mean " + title)), h("th", {class: "num"}, "estimates inside"), h("th", {class: "num"}, "objects found"))), readout)),
      h("p", {class: "hint"}, "Means are areas under the exact step functions over the largest κ. " + (methods.some(isBound) ? "Dashed: bounds, told the ground truth." : "")));
  }
}

/** Area under a step function over [0, end], over end; null where the score is undefined, as in kappa.md. */
function mean(list, score, end) {
  if (list.some((row) => row[score] === null)) return null;
  let area = 0;
  list.forEach((row, i) => { area += row[score] * ((list[i + 1]?.kappa ?? end) - row.kappa); });
  return area / end;
}
