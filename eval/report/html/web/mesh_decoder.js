// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT

/** Bytes of packed_mesh.h to arrays. `mesh`: {at, vertices, faces, low, size, colors, wide}; positions in metres. */
export function decodeMesh(bytes, mesh) {
  let at = mesh.at;
  const n = mesh.vertices;
  const positions = new Float32Array(3 * n);
  for (let axis = 0; axis < 3; ++axis) {
    let value = 0;
    for (let i = 0; i < n; ++i) {
      value = (value + bytes[at + i] + (bytes[at + n + i] << 8)) & 0xffff;
      positions[3 * i + axis] = mesh.low[axis] + value / 65535 * mesh.size[axis];
    }
    at += 2 * n;
  }
  let colors = null;
  if (mesh.colors) {
    colors = new Uint8Array(3 * n);
    for (let channel = 0; channel < 3; ++channel) {
      let value = 0;
      for (let i = 0; i < n; ++i) {
        value = (value + bytes[at + i]) & 0xff;
        colors[3 * i + channel] = value;
      }
      at += n;
    }
  }
  const corners = 3 * mesh.faces;
  const planes = mesh.wide ? 4 : 2;
  const indices = new Uint32Array(corners);
  let met = 0;
  for (let i = 0; i < corners; ++i) {
    let code = 0;
    for (let plane = 0; plane < planes; ++plane) code |= bytes[at + plane * corners + i] << (8 * plane);
    indices[i] = met - code;
    if (code === 0) ++met;
  }
  return {positions, colors, indices};
}
