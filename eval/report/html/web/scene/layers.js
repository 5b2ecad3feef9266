// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {Box3, BufferAttribute, BufferGeometry, Color, DoubleSide, FrontSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, Points, PointsMaterial, Vector3} from "three";
import {distinct} from "../data.js";
import {classColor, cssColor, methodColor, scaleColor} from "../palette.js";

/** What stands in the scene. Everything is built anew when something changes: it is a few hundred meshes at most. */
export class Layers {
  constructor(viewer, world) {
    this.viewer = viewer;
    this.world = world;
    this.group = new Group();
    this.pickable = [];
    viewer.scene.add(this.group);
  }

  /** options: {world (joined), methods: Set of names, scene: name or "", color, truths, lines, path, maxError, selected} */
  show(options) {
    this.dispose();
    const {world} = options;
    const shown = world.methods.filter((method) => options.methods.has(method.name));
    const classes = distinct(world.truths.map((truth) => truth.class)).sort();
    for (const method of shown) this.addEstimates(method, options, classes);
    this.addTruths(world, shown, options);
    if (options.lines) this.addLines(world, shown);
    if (options.path) this.addPath(world.data.path);
    if (options.selected) this.addSelection(world, options.selected);
    this.addScene(world.methods.find((method) => method.name === options.scene));
    this.viewer.draw();
  }

  dispose() {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      if (child.userData.own) child.geometry.dispose();
      if (child.material) child.material.dispose();
    }
    this.pickable = [];
    this.wanted = null;  // a scene mesh still on its way comes too late
  }

  /** Before the layers of another world. */
  close() {
    this.dispose();
    this.world.dispose();
    this.viewer.scene.remove(this.group);
  }

  add(object, own = false) {
    object.userData.own = own;
    this.group.add(object);
    return object;
  }

  addEstimates(method, options, classes) {
    method.objects.forEach((object, i) => {
      if (!object.mesh) {
        this.add(outline(object.box.map((v) => new Vector3(...v)), methodColor(method.name)), true);
        return;
      }
      const extra = object.status === "unmatched" || object.status === "duplicate";
      let geometry = this.world.geometry(object.mesh);
      let color = methodColor(method.name);
      let painted = false;
      if (options.color === "class") color = classColor(object.class, classes);
      if (options.color === "outcome") color = cssColor(extra ? "--extra" : object.status === "matched" ? "--found" : "--faint");
      if (options.color === "error") {
        const match = method.matches.find((candidate) => candidate.object === i && candidate.truth === object.truth);
        color = cssColor("--faint");
        if (match && object.status === "matched") {
          geometry = paint(this.world.paintable(object.mesh), this.world.distances(match.on_estimate, object.mesh), options.maxError);
          painted = true;
        }
      }
      const mesh = this.add(new Mesh(geometry, surface(painted ? 0xffffff : color, {vertexColors: painted})), painted);
      mesh.userData.pick = {key: object.key, method: method.name, name: object.name, truth: object.status === "matched" ? object.truth : null};
      this.pickable.push(mesh);
      if (extra) this.add(outline(boxPoints(geometry), cssColor("--extra"), 0, kCross), true);
    });
  }

  /** Overlay of all true objects, or at least those that no method shown has found. */
  addTruths(world, shown, {truths, selected}) {
    const scored = shown.filter((method) => method.isScored);
    world.truths.forEach((truth, t) => {
      const missed = scored.length > 0 && scored.every((method) => method.ofTruth.get(t)?.kind === "missed");
      const geometry = this.world.geometry(truth.mesh);
      if (missed) this.add(outline(boxPoints(geometry), cssColor("--missed")), true);
      const chosen = selected?.truth === t && truths === "none";
      if (truths === "none" && !missed && !chosen) return;
      const wire = (truths === "wire" || chosen) && !missed;
      const color = cssColor(missed ? "--missed" : "--truth");
      const mesh = this.add(new Mesh(geometry, wire ? new MeshBasicMaterial({color: new Color(color), wireframe: true, transparent: true, opacity: 0.5}) : surface(color, {transparent: true, opacity: truths === "solid" && !missed ? 1 : 0.42, depthWrite: truths === "solid" && !missed})));
      mesh.userData.pick = {truth: t, name: truth.name};
      this.pickable.push(mesh);
    });
  }

  addLines(world, shown) {
    const points = [];
    for (const method of shown) {
      for (const object of method.objects) {
        if (object.status !== "matched" || object.truth === null || !object.mesh) continue;
        points.push(center(this.world.geometry(object.mesh)), center(this.world.geometry(world.truths[object.truth].mesh)));
      }
    }
    const geometry = new BufferGeometry().setFromPoints(points);
    const ink = cssColor("--ink");
    const over = {depthTest: false, transparent: true};
    this.add(new LineSegments(geometry, new LineBasicMaterial({color: ink, ...over})), true).renderOrder = 5;
    const ends = new BufferGeometry().setFromPoints(points.filter((_, i) => i % 2 === 1));
    this.add(new Points(ends, new PointsMaterial({color: ink, size: 4, sizeAttenuation: false, ...over})), true).renderOrder = 5;
  }

  addPath(path) {
    const points = path.slice(1).flatMap((to, i) => [new Vector3(...path[i]), new Vector3(...to)]);
    this.add(new LineSegments(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({color: cssColor("--muted")})), true);
  }

  addSelection(world, selected) {
    const boxes = this.boxesOf(world, selected);
    const color = cssColor("--accent");
    for (const box of boxes) {
      const frame = this.add(outline([box.min, box.max], color, 0.02), true);
      frame.material.depthTest = false;
      frame.renderOrder = 6;
    }
  }

  /** Of a selection: the box of the truth, or of the estimate. */
  boxesOf(world, {truth, method, object}) {
    if (truth !== undefined) return [this.world.geometry(world.truths[truth].mesh).boundingBox];
    const {mesh, box} = world.methods[method].objects[object];
    return [mesh ? this.world.geometry(mesh).boundingBox : new Box3(new Vector3(...box[0]), new Vector3(...box[1]))];
  }

  async addScene(method) {
    const wanted = (this.wanted = {});
    if (!method || method.scene === null) return;
    const geometry = await this.world.sceneGeometry(method.scene);
    if (this.wanted !== wanted) return;
    // Walls are seen from inside only: from above one looks into the rooms.
    const colors = Boolean(geometry.getAttribute("color"));
    this.add(new Mesh(geometry, surface(colors ? 0xffffff : cssColor("--faint"), {vertexColors: colors, side: FrontSide, clippingPlanes: [this.viewer.cut], polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2})));
    this.viewer.draw();
  }

  /** Box of all that can be looked at. */
  bounds(world) {
    const box = new Box3();
    for (const truth of world.truths) box.union(this.world.geometry(truth.mesh).boundingBox);
    for (const method of world.methods) for (const object of method.objects) box.union(new Box3(new Vector3(...object.box[0]), new Vector3(...object.box[1])));
    return box.isEmpty() ? new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)) : box;
  }
}

export function surface(color, more = {}) {
  return new MeshLambertMaterial({color: new Color(color), side: DoubleSide, flatShading: true, ...more});
}

/** Colours of a scale from 0 to `maxError` [m] for distances in millimetres. */
export function paint(geometry, millimetres, maxError) {
  const table = Array.from({length: 256}, (_, mm) => scaleColor(mm / 1000 / maxError));
  const colors = geometry.getAttribute("color");
  millimetres.forEach((mm, i) => colors.array.set(table[mm].map(linear), 3 * i));
  colors.needsUpdate = true;
  return geometry;
}

/** Colours of vertices are taken as linear light; those of the scale are sRGB. */
const linear = (value) => Math.round(255 * (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));

const center = (geometry) => geometry.boundingBox.getCenter(new Vector3());
const boxPoints = (geometry) => [geometry.boundingBox.min, geometry.boundingBox.max];

const kEdges = [[0, 1], [1, 3], [3, 2], [2, 0], [4, 5], [5, 7], [7, 6], [6, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

const kCross = [[4, 7], [5, 6]];  // on top

function outline([low, high], color, margin = 0, more = []) {
  const corner = (i) => [0, 1, 2].map((axis) => ((i >> axis) & 1 ? high.getComponent(axis) + margin : low.getComponent(axis) - margin));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([...kEdges, ...more].flatMap(([a, b]) => [...corner(a), ...corner(b)])), 3));
  return new LineSegments(geometry, new LineBasicMaterial({color: new Color(color)}));
}
