// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {h} from "../dom.js";
import {centimetres, fixed, percent} from "../format.js";
import {kOutcomes} from "../model.js";
import {methodLabel, methodTag} from "../palette.js";
import {viewPager} from "./view.js";

/** What is known of the chosen object. actions: {step(by), close(), choose(method), heat()} */
export function objectPanel({world, shapes, selected, method: chosen, heat, actions}) {
  const truth = selected.truth !== undefined ? world.truths[selected.truth] : null;
  const body = truth ? truthBody(world, shapes, selected.truth, chosen, heat, actions) : estimateBody(world, shapes, selected, actions);
  return h("div", {class: "object"},
    h("div", {class: "title"},
      h("h2", {}, truth ? truth.name : world.methods[selected.method].objects[selected.object].name),
      h("button", {type: "button", "data-name": "previous", class: "quiet", title: "previous object (p)", onclick: () => actions.step(-1)}, "‹"),
      h("button", {type: "button", "data-name": "next", class: "quiet", title: "next object (n)", onclick: () => actions.step(1)}, "›"),
      h("button", {type: "button", class: "quiet", title: "close (Esc)", onclick: actions.close}, "×")),
    body);
}

function truthBody(world, shapes, t, chosen, heat, actions) {
  const truth = world.truths[t];
  const info = truth.scored;
  const scored = world.methods.filter((method) => method.isScored);
  const method = world.methods.find((candidate) => candidate.name === chosen);
  const found = method?.ofTruth.get(t);
  return [
    h("p", {class: "hint"}, [truth.class, info?.subtype, info?.room, info && info.visible !== null ? percent(info.visible) + " of its surface in view" : ""].filter(Boolean).join(" · ")),
    scored.length === 0 ? h("p", {class: "hint"}, "Nothing was scored here.") : h("table", {class: "data compact"},
      h("thead", {}, h("tr", {}, h("th", {}, "method"), ["centre", "Ch. L1", "B-IoU", "V-IoU"].map((title, i) => h("th", {class: "num", title: ["distance of the centres [cm]", "mean distance of the surfaces [cm]"][i]}, title)))),
      h("tbody", {}, scored.map((candidate) => {
        const outcome = candidate.ofTruth.get(t);
        const scores = outcome?.scores;
        return h("tr", {class: candidate.name === chosen ? "chosen" : ""},
          h("th", {scope: "row"}, h("button", {type: "button", "data-name": candidate.name, class: "row", "aria-pressed": String(candidate.name === chosen), onclick: () => actions.choose(candidate.name)}, methodTag(candidate.name))),
          outcome?.kind === "matched"
            ? [h("td", {class: "num"}, centimetres(outcome.distance)), h("td", {class: "num"}, scores ? centimetres(scores.chamfer_l1) : ""), h("td", {class: "num"}, scores ? fixed(scores.b_iou, 2) : ""), h("td", {class: "num"}, scores ? fixed(scores.v_iou_solid, 2) : "")]
            : h("td", {class: "missed", colspan: 4}, outcome ? kOutcomes[outcome.kind] : "n/a"));
      }))),
    h("p", {}, h("button", {type: "button", id: "heat", "data-name": "heat", class: "main", "aria-pressed": String(heat), onclick: actions.heat}, heat ? "Back to the scene (h)" : "Error heatmap (h)")),
    method && views(shapes, method, candidatesOf(method, t, found)),
  ];
}

/** Those that became the matched estimate, then those that were turned down next to the truth. */
function candidatesOf(method, t, found) {
  const id = found?.kind === "matched" && found.object !== null ? method.objects[found.object].id : null;
  const of = (test) => method.candidates.filter(test);
  return [...of((c) => id !== null && c.object === id), ...of((c) => c.object === null && c.near === t), ...of((c) => id === null && c.object !== null && c.near === t)];
}

function views(shapes, method, candidates) {
  if (method.candidates.length === 0) return h("p", {class: "hint"}, methodLabel(method.name) + " estimates no shapes from single views.");
  return [h("h3", {}, "Best view of ", methodTag(method.name)),
    candidates.length > 0 ? viewPager(shapes, candidates) : h("p", {class: "hint"}, "No shape was asked for here.")];
}

function estimateBody(world, shapes, {method: m, object: o}, actions) {
  const method = world.methods[m];
  const object = method.objects[o];
  const near = object.truth === null ? null : world.truths[object.truth];
  const text = {matched: "found", unmatched: "false positive: no true object of its class within the distance", duplicate: "duplicate: another estimate stands for the object", unscored: "not scored"}[object.status];
  return [
    h("p", {class: "hint"}, object.class, " · ", methodTag(method.name)),
    h("p", {}, h("span", {class: "outcome " + object.status}, text)),
    near && h("p", {}, "Nearest: ", h("button", {type: "button", class: "link", onclick: () => actions.select({truth: object.truth})}, near.name), object.distance === null ? "" : ", centres " + centimetres(object.distance) + " cm apart"),
    views(shapes, method, method.candidates.filter((c) => c.object === object.id)),
  ];
}
