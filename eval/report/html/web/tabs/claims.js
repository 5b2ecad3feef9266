// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct, json} from "../data.js";
import {fill, h} from "../dom.js";

const kVerdicts = {holds: "yes", fails: "no", undecided: "open", "not run": "none"};  // the classes of style.css

/** What this result says to the sentences of a paper: each with its verdict and every comparison behind it. */
export function claimsTab(page) {
  const claims = json("claims");
  const judged = claims.filter((claim) => claim.verdict !== "not run");
  const notRun = claims.filter((claim) => claim.verdict === "not run");
  const datasets = distinct(claims.flatMap((claim) => claim.findings.map((finding) => finding.dataset)).filter(Boolean));
  const counts = Object.keys(kVerdicts).map((verdict) => claims.filter((claim) => claim.verdict === verdict).length + " " + verdict);
  fill(page,
    h("p", {class: "hint"}, counts.join(", "), ". A claim holds where every comparison below it does: where all of its 95 % interval is on the side that is asked for. It fails where ",
      "all of one is on the other side, and is undecided between. Bars show the intervals, the line in the middle of each is the bound. Over κ the numbers are those that speak most against the claim."),
    judged.map((claim) => section(claim, datasets.length > 1)),
    notRun.length > 0 && h("details", {class: "notrun"}, h("summary", {}, notRun.length + " not run: this result lacks what they take"), notRun.map((claim) => section(claim, datasets.length > 1))));
  return {};
}

function section(claim, withDataset) {
  return h("section", {class: "claim"},
    h("h2", {}, badge(claim.verdict), claim.says, claim.source && h("small", {}, claim.source)),
    h("div", {class: "scroll"}, h("table", {class: "data"},
      h("thead", {}, h("tr", {}, h("th", {}, "verdict"), withDataset && h("th", {}, "dataset"), h("th", {class: "grow"}, "comparison"),
        h("th", {class: "num wide", title: "in favour of the method the claim is about; of real time its least and largest multiple"}, "difference, 95 %"), h("th", {class: "num"}, "asked for"), h("th", {class: "wide"}, "interval and bound"))),
      h("tbody", {}, claim.findings.map((finding) => h("tr", {class: finding.verdict === "not run" ? "faint" : ""},
        h("td", {}, badge(finding.verdict)), withDataset && h("td", {}, finding.dataset), h("td", {}, finding.what),
        h("td", {class: "num"}, numbers(finding)), h("td", {class: "num"}, finding.relation && finding.relation.replace(">=", "≥") + " " + digits(finding.bound)),
        h("td", {}, finding.ci95 && finding.relation && bar(finding))))))));
}

const badge = (verdict) => h("span", {class: "badge " + kVerdicts[verdict]}, verdict);

const digits = (value) => String(Number(value.toPrecision(3))).replace("-", "−");
const signed = (value) => (value === 0 ? "0" : (value > 0 ? "+" : "") + value.toPrecision(3).replace("-", "−"));

function numbers({difference, ci95}) {
  if (!ci95) return "";
  if (difference === undefined) return digits(ci95[0]) + " to " + digits(ci95[1]) + " ×";
  return [h("span", {class: "value"}, signed(difference)), h("span", {class: "interval"}, signed(ci95[0]) + " to " + signed(ci95[1]))];
}

/** The interval around the bound; every comparison has a unit, so a scale, of its own. */
function bar({verdict, difference, ci95: [low, high], bound}) {
  const reach = Math.max(Math.abs(low - bound), Math.abs(high - bound), 1e-12) * 1.1;
  const at = (value) => (50 + 50 * (value - bound) / reach).toFixed(1) + "%";
  return h("span", {class: "lean " + kVerdicts[verdict], "aria-hidden": "true"}, h("i", {style: "left:" + at(low) + ";right:calc(100% - " + at(high) + ")"}),
    difference !== undefined && h("b", {style: "left:" + at(difference)}));
}
