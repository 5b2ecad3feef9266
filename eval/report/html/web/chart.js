// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import uPlot from "uplot";
import {h} from "./dom.js";
import {cssColor} from "./palette.js";
import {onTheme} from "./theme.js";

/**
 * A line chart. Curves: {label, color() -> css colour, dash, points: [[x, y]], band: [[x, low, high]], steps}. With steps a value holds
 * until the next point. Colours are asked for again when the theme changes. Call destroy() before another takes its place: until then the
 * theme, the other charts of `sync` and the browser know it.
 */
export function chart({title, xLabel, yLabel = "", xRange, yRange = [0, 1], curves, height = 270, sync, oncursor}) {
  const box = h("figure", {class: "chart"}, h("figcaption", {}, title));
  const holder = h("div", {class: "plot"});
  box.append(holder);
  let plot = null;
  const aligned = align(curves);

  function options(width) {
    const axis = {stroke: cssColor("--muted"), grid: {stroke: cssColor("--line"), width: 1}, ticks: {stroke: cssColor("--line"), width: 1, size: 4},
      font: "12px " + cssColor("--sans"), labelFont: "12px " + cssColor("--sans")};
    const series = [{}];
    const bands = [];
    curves.forEach((curve) => {
      const color = curve.color();
      series.push({label: curve.label, stroke: color, width: 2, dash: curve.dash, spanGaps: true, show: curve.shown ?? true,
        points: {show: !curve.steps && curve.points.length < 30, size: 6, fill: color}, paths: curve.steps ? uPlot.paths.stepped({align: 1}) : undefined});
      if (curve.band.length > 0) {
        const edge = {stroke: "transparent", width: 0, spanGaps: true, points: {show: false}, show: curve.shown ?? true};
        series.push({...edge}, {...edge});
        bands.push({series: [series.length - 1, series.length - 2], fill: withAlpha(color, 0.14)});
      }
    });
    return {width, height, padding: [8, 12, 0, 0], legend: {show: false}, series, bands,
      cursor: {sync: sync ? {key: sync} : undefined, points: {show: false}, drag: {x: false, y: false}, y: false},
      hooks: oncursor ? {setCursor: [(u) => u.cursor.left >= 0 && oncursor(u.posToVal(u.cursor.left, "x"))]} : {},
      scales: {x: {time: false, range: () => xRange}, y: {range: () => yRange}},
      axes: [{...axis, label: xLabel, labelSize: 22, size: 34}, {...axis, label: yLabel || undefined, labelSize: yLabel ? 20 : 0, size: 42}]};
  }

  function draw() {
    const width = holder.clientWidth;
    if (width === 0) return;
    plot?.destroy();
    plot = new uPlot(options(width), aligned, holder);
  }

  const observer = new ResizeObserver(draw);
  observer.observe(holder);
  const forget = onTheme(draw);
  const destroy = () => {
    observer.disconnect();
    forget();
    plot?.destroy();
  };
  return {element: box, destroy};
}

function withAlpha(color, alpha) {
  const [r, g, b] = [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16));
  return "rgba(" + r + "," + g + "," + b + "," + alpha + ")";
}

/** All curves over one list of x; where a curve has no point: undefined, which the drawing spans. */
function align(curves) {
  const tables = [];
  for (const curve of curves) {
    tables.push([curve.points.map(([x]) => x), curve.points.map(([, y]) => y)]);
    if (curve.band.length > 0) tables.push([curve.band.map(([x]) => x), curve.band.map(([, low]) => low), curve.band.map(([, , high]) => high)]);
  }
  return tables.length > 0 ? uPlot.join(tables) : [[]];
}
