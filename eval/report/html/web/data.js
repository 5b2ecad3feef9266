// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT

/** The data that stands in the page: JSON, and bytes as base64 (gzipped where the id ends in .gz). */
const parsed = new Map();
const decoded = new Map();

export function json(id) {
  if (!parsed.has(id)) parsed.set(id, JSON.parse(document.getElementById(id)?.textContent ?? "null"));
  return parsed.get(id);
}

export function bytes(id) {
  if (!decoded.has(id)) decoded.set(id, read(id));
  return decoded.get(id);
}

async function read(id) {
  const binary = atob(document.getElementById(id).textContent);
  const packed = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) packed[i] = binary.charCodeAt(i);
  if (!id.endsWith(".gz")) return packed;
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Rows of {columns, rows} as objects. */
export function records(table) {
  if (!table) return [];
  return table.rows.map((row) => Object.fromEntries(table.columns.map((column, i) => [column, row[i]])));
}

export const distinct = (values) => [...new Set(values)];
