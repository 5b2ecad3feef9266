// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT

/** What is being looked at, kept in the URL's hash so that a link shows the same. */
const listeners = new Set();
let current = parse();

function parse() {
  return Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
}

export const get = (key, otherwise = "") => current[key] ?? otherwise;

/** Changes keys; null takes one away. */
export function set(changes) {
  const next = {...current};
  for (const [key, value] of Object.entries(changes)) {
    if (value === null || value === "") delete next[key];
    else next[key] = String(value);
  }
  const hash = "#" + new URLSearchParams(next);
  if (hash === "#" + new URLSearchParams(current)) return;
  const before = current;
  current = next;
  history.replaceState(null, "", hash);
  tell(before);
}

/** The hash of a place, for links. */
export const linkTo = (changes) => "#" + new URLSearchParams({...(current.theme ? {theme: current.theme} : {}), ...changes});

export function onChange(listener) {
  listeners.add(listener);
}

function tell(before) {
  const changed = new Set([...Object.keys(before), ...Object.keys(current)].filter((key) => before[key] !== current[key]));
  if (changed.size > 0) for (const listener of listeners) listener(changed);
}

window.addEventListener("hashchange", () => {
  const before = current;
  current = parse();
  tell(before);
});
