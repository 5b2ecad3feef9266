// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct, json} from "../data.js";
import {fill, h, select} from "../dom.js";
import {centimetres, fixed, percent} from "../format.js";
import {chosenSetting, chosenWorld, estimateKey, kOutcomes, objects, outcomesOf, scoredWorld, scoresOf, settingControls, shownNames, truthKey, worldControl, worldKey} from "../model.js";
import {methodLabel, methodTag} from "../palette.js";
import * as state from "../state.js";
import {sortableTable} from "../table.js";

/** A row for every true object and method, and for every estimate that stands for none. */
export function objectsTab(page) {
  if (objects().worlds.length === 0) {
    fill(page, h("p", {class: "empty"}, "No objects here: nothing was scored."));
    return {};
  }
  const filter = {method: "", class: "", outcome: "", text: ""};
  const table = h("div", {});
  const count = h("output", {class: "hint"});
  const controls = h("div", {class: "controls"});
  fill(page, controls, table);
  let rows = [];
  gather();
  state.onChange((changed) => ["world", "threshold", "matching"].some((key) => changed.has(key)) && gather());

  function gather() {
    const world = scoredWorld(chosenWorld());
    rows = world ? rowsOf(world, chosenSetting()) : [];
    drawControls();
    draw();
  }

  function drawControls() {
    const pick = (key) => (value) => { filter[key] = value; draw(); };
    fill(controls, worldControl(), settingControls(),
      select("method", [["", "all"], ...distinct(rows.map((row) => row.method)).map((m) => [m, methodLabel(m)])], filter.method, pick("method")),
      select("class", [["", "all"], ...distinct(rows.map((row) => row.class)).sort().map((c) => [c, c])], filter.class, pick("class")),
      select("outcome", [["", "all"], ...Object.entries(kOutcomes)], filter.outcome, pick("outcome")),
      h("label", {class: "field"}, h("span", {}, "name, variant or room"), h("input", {type: "search", id: "object-filter", "data-name": "filter", value: filter.text, oninput: (event) => pick("text")(event.target.value)})),
      h("div", {class: "spring"}), count);
  }

  function draw() {
    const words = filter.text.toLowerCase().split(/\s+/).filter(Boolean);
    const kept = rows.filter((row) => (!filter.method || row.method === filter.method) && (!filter.class || row.class === filter.class)
      && (!filter.outcome || row.outcome === filter.outcome) && words.every((word) => row.words.includes(word)));
    count.textContent = kept.length + " of " + rows.length + " rows";
    const hasScene = json("scene").worlds.some((world) => worldKey(world) === chosenWorld());
    const score = (key, title, show, hint) => ({key, title, hint, numeric: true, descendingFirst: key.includes("iou") || key.startsWith("f_"), value: (row) => row.scores?.[key], show: (row) => show(row.scores?.[key])});
    const blank = (show) => (value) => (value === null || value === undefined ? "" : show(value));
    fill(table, sortableTable({rows: kept, sort: null, className: "objects", columns: [
      {key: "name", title: "object", value: (row) => row.name, show: (row) => (hasScene ? h("a", {href: state.linkTo({tab: "scene", world: chosenWorld(), object: row.key, method: row.method,
        ...(state.get("threshold") ? {threshold: state.get("threshold")} : {}), ...(state.get("matching") ? {matching: state.get("matching")} : {})})}, row.name) : row.name)},
      {key: "class", title: "class", value: (row) => row.class},
      {key: "subtype", title: "variant", value: (row) => row.subtype},
      {key: "room", title: "room", value: (row) => row.room},
      {key: "visible", title: "in view", hint: "share of the surface that some frame saw", numeric: true, value: (row) => row.visible, show: (row) => blank(percent)(row.visible)},
      {key: "method", title: "method", value: (row) => methodLabel(row.method), show: (row) => methodTag(row.method)},
      {key: "outcome", title: "outcome", value: (row) => kOutcomes[row.outcome], show: (row) => h("span", {class: "outcome " + row.outcome}, kOutcomes[row.outcome])},
      {key: "distance", title: "centre [cm]", numeric: true, value: (row) => row.distance, show: (row) => blank(centimetres)(row.distance)},
      score("chamfer_l1", "Chamf. L1 [cm]", blank(centimetres), "mean distance between the surfaces"),
      score("b_iou", "B-IoU", blank(fixed)), score("obb_iou", "OBB-IoU", blank(fixed)), score("v_iou_solid", "V-IoU", blank(fixed)), score("f_score_2cm", "F 2 cm", blank(fixed)),
    ]}));
  }
  return {};
}

function rowsOf(world, setting) {
  const rows = [];
  const key = worldKey(world);
  const names = shownNames(world.truths);
  world.truths.forEach((truth, t) => {
    for (const method of world.methods) {
      const outcome = outcomesOf(method, setting, world.truths.length).ofTruth.get(t);
      if (!outcome) continue;
      rows.push({...common(truth, names[t]), visible: truth.visible, key: truthKey(key, truth), method: method.method, outcome: outcome.kind, distance: outcome.distance,
        scores: outcome.kind === "matched" ? scoresOf(method, outcome.estimate, t) : null});
    }
  });
  for (const method of world.methods) {
    for (const {kind, estimate, distance} of outcomesOf(method, setting, 0).extra) {
      const object = method.estimates[estimate];
      rows.push({...common(object, object.name), visible: null, key: estimateKey(key, method.method, object), method: method.method, outcome: kind, distance, scores: null});
    }
  }
  return rows;
}

const common = (object, name) => ({name, class: object.class, subtype: object.subtype ?? "", room: object.room ?? "",
  words: [name, object.id, object.class, object.subtype, object.room].join(" ").toLowerCase()});
