// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {BufferAttribute, BufferGeometry} from "three";
import {bytes} from "../data.js";
import {decodeMesh} from "../mesh_decoder.js";

/** The shapes of one world, decoded when they are asked for. */
export class World {
  static async open(data) {
    return new World(data, await bytes(data.prefix + "-shapes.gz"));
  }

  constructor(data, shapes) {
    this.data = data;
    this.shapes = shapes;
    this.geometries = new Map();
    this.scenes = new Map();
  }

  /** Takes everything off the graphics card; what is still asked for afterwards comes back there. */
  dispose() {
    for (const geometry of this.geometries.values()) geometry.dispose();
    for (const scene of this.scenes.values()) scene.then((geometry) => geometry.dispose());
  }

  /** Of an object; shared by all who ask for it, so it must not be changed. Equal bytes may stand for shapes of other places and sizes. */
  geometry(mesh) {
    const key = [mesh.at, ...mesh.low, ...mesh.size].join();
    if (!this.geometries.has(key)) this.geometries.set(key, geometryOf(decodeMesh(this.shapes, mesh)));
    return this.geometries.get(key);
  }

  /** The same with room for a colour per vertex, the caller's own. */
  paintable(mesh) {
    const geometry = this.geometry(mesh).clone();
    geometry.setAttribute("color", new BufferAttribute(new Uint8Array(3 * mesh.vertices), 3, true));
    return geometry;
  }

  /** Distances of a mesh's vertices in millimetres, 255: that or more. */
  distances(at, mesh) {
    return this.shapes.subarray(at, at + mesh.vertices);
  }

  /** Promise of a scene mesh, shared as well. */
  sceneGeometry(index) {
    if (!this.scenes.has(index)) {
      this.scenes.set(index, bytes(this.data.prefix + "-scene-" + index + ".gz").then((packed) => geometryOf(decodeMesh(packed, this.data.scenes[index]))));
    }
    return this.scenes.get(index);
  }

  /** A picture as a Blob. */
  async picture([offset, size], type) {
    return new Blob([(await bytes(this.data.prefix + "-views")).subarray(offset, offset + size)], {type});
  }
}

function geometryOf({positions, colors, indices}) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3, true));
  geometry.setIndex(new BufferAttribute(indices, 1));
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  return geometry;
}
