// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {distinct, json} from "./data.js";
import {choice, select} from "./dom.js";
import {matchingText, thresholdText} from "./format.js";
import * as state from "./state.js";

/** What became of every object, by world and setting (threshold and matching); the choice of both is kept in the URL. */
export const objects = () => json("objects");
export const worldKey = (world) => world.dataset + "/" + world.seed;

/** Worlds that have scores, or at least a scene. */
export function worldKeys() {
  return distinct([...objects().worlds.map(worldKey), ...json("scene").worlds.map(worldKey)]);
}
export const chosenWorld = () => (worldKeys().includes(state.get("world")) ? state.get("world") : worldKeys()[0]);
export const scoredWorld = (key) => objects().worlds.find((world) => worldKey(world) === key);

const settingKey = (setting) => setting.kind + ":" + setting.value;

/** Index of the chosen setting; the widest distance in metres, one to one, if nothing is chosen. */
export function chosenSetting() {
  const settings = objects().settings;
  const metres = settings.filter((setting) => setting.kind === "tau_m").map((setting) => setting.value);
  const threshold = state.get("threshold", metres.length > 0 ? "tau_m:" + Math.max(...metres) : settingKey(settings[0] ?? {}));
  const matching = state.get("matching", "one_to_one");
  const index = settings.findIndex((setting) => settingKey(setting) === threshold && setting.matching === matching);
  return Math.max(0, index);
}

export function worldControl() {
  const keys = worldKeys();
  return keys.length > 1 && select("world", keys.map((key) => [key, key.replace("/", ", seed ")]), chosenWorld(), (world) => state.set({world, object: null}));
}

/** How a thing is called in the URL, wherever it is listed: a name may stand for several, in one world or in different ones. */
export const truthKey = (world, truth) => world + "/" + truth.id;
export const estimateKey = (world, method, estimate) => world + "/" + method + "/" + estimate.id;

/** Names to show: where several of a world have the same one, with the id. */
export function shownNames(truths) {
  const names = truths.map((truth) => truth.name || truth.id);
  return names.map((name, i) => (names.indexOf(name) === names.lastIndexOf(name) ? name : name + " #" + truths[i].id));
}

/** @param narrow  two drop-downs that fit beside each other */
export function settingControls(narrow = false) {
  const settings = objects().settings;
  if (settings.length === 0) return null;
  const chosen = settings[chosenSetting()];
  return [
    select("centre within", distinct(settings.map(settingKey)).map((key) => {
      const [kind, value] = key.split(":");
      return [key, thresholdText(kind, value)];
    }), settingKey(chosen), (threshold) => state.set({threshold})),
    (narrow ? select : choice)("matching", distinct(settings.map((setting) => setting.matching)).map((m) => [m, matchingText(m), m]), chosen.matching, (matching) => state.set({matching})),
  ];
}

/** Of one method at one setting: the outcome of every one of `count` truths by index, and the estimates that stand for none. */
export function outcomesOf(method, setting, count) {
  const ofTruth = new Map();
  const extra = [];
  for (const [kind, estimate, truth, distance] of method.outcomes[setting] ?? []) {
    if (kind === "matched" || kind === "missed") {
      const known = ofTruth.get(truth);
      if (!known || distance < known.distance) ofTruth.set(truth, {kind, estimate, distance});
    } else {
      extra.push({kind, estimate, truth, distance});
    }
  }
  // Many to one, a truth counts as found by an estimate whose own line names a nearer truth.
  for (let truth = 0; truth < count && method.outcomes[setting]; ++truth) {
    if (!ofTruth.has(truth)) ofTruth.set(truth, {kind: "found", estimate: null, distance: null});
  }
  return {ofTruth, extra};
}

export const isFound = (outcome) => outcome?.kind === "matched" || outcome?.kind === "found";

/** The scores of an estimate against a truth by name; null where they were not computed. */
export function scoresOf(method, estimate, truth) {
  const pair = method.pairs.find((candidate) => candidate.e === estimate && candidate.t === truth);
  return pair ? Object.fromEntries(objects().score_names.map((name, i) => [name, pair.scores[i]])) : null;
}

export const kOutcomes = {matched: "found", found: "found beside another", missed: "missed", unmatched: "false positive", duplicate: "duplicate"};
