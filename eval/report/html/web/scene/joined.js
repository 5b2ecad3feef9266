// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "../data.js";
import {chosenSetting, estimateKey, outcomesOf, scoredWorld, scoresOf, shownNames, truthKey, worldKey} from "../model.js";

/**
 * What there is to see of a world with what became of it at a setting:
 * truths: [{id, key, name, class, mesh, scored}], methods: [{name, scene, objects: [{id, key, name, class, mesh, box, status, truth, distance}],
 * ofTruth: Map of truth index to {kind, object, distance, scores}, matches, candidates}]. A status is matched, unmatched, duplicate or
 * unscored.
 */
export function joined(key) {
  const data = json("scene").worlds.find((world) => worldKey(world) === key);
  if (!data) return null;
  const scored = scoredWorld(key);
  const setting = chosenSetting();
  const truthIndex = new Map(data.truths.map((truth, i) => [truth.id, i]));
  const names = shownNames(data.truths);
  const truths = data.truths.map((truth, i) => ({...truth, key: truthKey(key, truth), name: names[i], scored: scored?.truths.find((other) => other.id === truth.id) ?? null}));
  const methods = data.methods.map((method) => joinMethod(key, method, scored, setting, truthIndex));
  return {key, data, truths, methods};
}

function joinMethod(world, method, scored, setting, truthIndex) {
  const objects = method.objects.map((object) => ({...object, key: estimateKey(world, method.method, object), status: "unscored", truth: null, distance: null}));
  const ofTruth = new Map();
  const result = {name: method.method, scene: method.scene, objects, ofTruth, matches: method.matches, candidates: method.candidates, isScored: false};
  const evaluated = scored?.methods.find((other) => other.method === method.method);
  if (!evaluated) return result;
  result.isScored = true;
  const objectIndex = new Map(objects.map((object, i) => [object.id, i]));
  const sceneObject = (estimate) => objectIndex.get(evaluated.estimates[estimate]?.id);
  const sceneTruth = (truth) => truthIndex.get(scored.truths[truth]?.id);
  const {ofTruth: found, extra} = outcomesOf(evaluated, setting, scored.truths.length);
  for (const [truth, {kind, estimate, distance}] of found) {
    const t = sceneTruth(truth);
    if (t === undefined) continue;
    const object = estimate === null ? undefined : sceneObject(estimate);
    ofTruth.set(t, {kind, object: object ?? null, distance, scores: kind === "matched" ? scoresOf(evaluated, estimate, truth) : null});
  }
  // Under "exists" several estimates may stand for one truth: every line of the outcomes counts.
  for (const [kind, estimate, truth, distance] of evaluated.outcomes[setting] ?? []) {
    const object = kind === "matched" ? sceneObject(estimate) : undefined;
    if (object !== undefined) Object.assign(objects[object], {status: "matched", truth: sceneTruth(truth) ?? null, distance});
  }
  for (const {kind, estimate, truth, distance} of extra) {
    const object = sceneObject(estimate);
    if (object !== undefined) Object.assign(objects[object], {status: kind, truth: truth === null ? null : sceneTruth(truth) ?? null, distance});
  }
  return result;
}

/** What a key names: {truth} or {method, object}, indices; null for nothing. */
export function find(world, key) {
  if (!key) return null;
  const truth = world.truths.findIndex((candidate) => candidate.key === key);
  if (truth >= 0) return {truth};
  for (let method = 0; method < world.methods.length; ++method) {
    const object = world.methods[method].objects.findIndex((candidate) => candidate.key === key);
    if (object >= 0) return {method, object};
  }
  return null;
}
