// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer} from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";
import {cssColor} from "../palette.js";
import {onTheme} from "../theme.js";

const kFlight = 350;  // [ms]
const kClick = 5;     // [px] a pointer may move in a click

/** Canvas, camera and light. Draws when something changed, not all the time. */
export class Viewer {
  constructor(holder) {
    this.holder = holder;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(45, 1, 0.02, 500);
    this.camera.up.set(0, 0, 1);
    this.cut = new Plane(new Vector3(0, 0, -1), Infinity);
    this.cells = null;
    this.renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute("aria-label", "3-D scene; arrow keys turn, plus and minus zoom, n and p go through the objects");
    holder.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.zoomToCursor = true;
    addLamp(this.scene);
    this.paint();
    onTheme(() => this.paint());
    new ResizeObserver(() => this.resize()).observe(holder);
    this.renderer.domElement.addEventListener("keydown", (event) => this.key(event));
  }

  /** Small pictures in a grid instead of the scene: [{scene}], see heatmap.js; null for the scene. Those that stood there are released. */
  setCells(cells) {
    for (const {scene} of this.cells ?? []) {
      scene.traverse(({geometry, material}) => {
        geometry?.dispose();
        material?.dispose();
      });
    }
    this.cells = cells;
    this.draw();
  }

  paint() {
    this.background = new Color(cssColor("--stage"));
    this.draw();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.holder;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.draw();
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.render();
    });
  }

  render() {
    const {clientWidth: width, clientHeight: height} = this.holder;
    if (width === 0 || height === 0) return;
    this.renderer.setClearColor(this.background);
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    if (!this.cells) {
      this.renderCell(this.scene, 0, 0, width, height);
      return;
    }
    const {columns, rows} = this.gridSize();
    this.renderer.setScissorTest(true);
    this.cells.forEach(({scene}, i) => {
      const w = width / columns;
      const high = height / rows;
      this.renderCell(scene, (i % columns) * w, height - (Math.floor(i / columns) + 1) * high, w, high);
    });
  }

  gridSize() {
    const columns = Math.min(this.cells.length, this.cells.length > 4 ? Math.ceil(this.cells.length / 2) : this.cells.length);
    return {columns, rows: Math.ceil(this.cells.length / columns)};
  }

  renderCell(scene, left, bottom, width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    // The lamp is beside the camera, so that nothing is ever in the dark.
    scene.userData.lamp.position.copy(this.camera.localToWorld(new Vector3(0.4, 0.6, 0))).sub(this.controls.target);
    this.renderer.setViewport(left, bottom, width, height);
    this.renderer.setScissor(left, bottom, width, height);
    this.renderer.render(scene, this.camera);
  }

  /** Looks at a box: from where the camera is, or from that of `directions` in which it appears largest. */
  lookAt(box, {directions = null, jump = false, room = 1.15} = {}) {
    const center = box.getCenter(new Vector3());
    const here = this.camera.position.clone().sub(this.controls.target);
    let best = null;
    for (const direction of directions ?? [here.lengthSq() > 0 ? here : new Vector3(-0.4, -0.7, 0.8)]) {
      const away = direction.clone().normalize();
      const distance = this.distanceFor(box, center, away, room);
      if (!best || distance < best.distance) best = {away, distance};
    }
    const eye = center.clone().addScaledVector(best.away, best.distance);
    if (jump || matchMedia("(prefers-reduced-motion: reduce)").matches) this.place(eye, center);
    else this.fly(eye, center);
  }

  /** As far as it takes for every corner of the box to be inside. */
  distanceFor(box, center, away, room) {
    const {clientWidth: width, clientHeight: height} = this.holder;
    const shape = this.cells ? this.gridSize() : {columns: 1, rows: 1};
    const aspect = (width / shape.columns) / Math.max(1, height / shape.rows);
    const half = Math.tan(this.camera.fov * Math.PI / 360);
    const right = new Vector3(0, 0, 1).cross(away).normalize();
    const up = away.clone().cross(right);
    let distance = 0.1;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z).sub(center);
      distance = Math.max(distance, corner.dot(away) + room * Math.max(Math.abs(corner.dot(right)) / (half * aspect), Math.abs(corner.dot(up)) / half));
    }
    return distance;
  }

  place(eye, target) {
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
    this.draw();
  }

  fly(eye, target) {
    const from = {eye: this.camera.position.clone(), target: this.controls.target.clone()};
    const start = performance.now();
    const flight = (this.flight = {});
    const step = (now) => {
      if (this.flight !== flight) return;
      const x = Math.min(1, Math.max(0, (now - start) / kFlight));
      const ease = x * x * (3 - 2 * x);
      this.place(from.eye.clone().lerp(eye, ease), from.target.clone().lerp(target, ease));
      if (x < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Calls back with a click's ray (and moves, for a hint); drags are the camera's. */
  onPick(click, hover) {
    const canvas = this.renderer.domElement;
    let down = null;
    const ray = (event) => {
      const box = canvas.getBoundingClientRect();
      const caster = new Raycaster();
      this.camera.aspect = box.width / box.height;
      this.camera.updateProjectionMatrix();
      caster.setFromCamera(new Vector2((event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2), this.camera);
      return caster;
    };
    canvas.addEventListener("pointerdown", (event) => { down = event; });
    canvas.addEventListener("pointerup", (event) => {
      if (down && !this.cells && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < kClick) click(ray(event));
      down = null;
    });
    canvas.addEventListener("pointermove", (event) => { if (!down && !this.cells) hover(ray(event), event); });
    canvas.addEventListener("pointerleave", () => hover(null));
  }

  key(event) {
    const turn = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[event.key];
    const zoom = {"+": 0.87, "=": 0.87, "-": 1.15}[event.key];
    if (!turn && !zoom) return;
    event.preventDefault();
    const offset = this.camera.position.clone().sub(this.controls.target);
    if (turn) {
      offset.applyAxisAngle(new Vector3(0, 0, 1), turn[0]);
      const polar = Math.min(3.1, Math.max(0.04, Math.acos(offset.z / offset.length()) + turn[1]));
      const flat = Math.hypot(offset.x, offset.y) || 1e-6;
      const length = offset.length();
      offset.set(offset.x / flat * Math.sin(polar) * length, offset.y / flat * Math.sin(polar) * length, Math.cos(polar) * length);
    }
    this.place(this.controls.target.clone().addScaledVector(offset, zoom ?? 1), this.controls.target.clone());
  }
}

/** Every scene that a viewer draws needs one. */
export function addLamp(scene) {
  scene.userData.lamp = new DirectionalLight(0xffffff, 1.35);
  const sky = new HemisphereLight(0xffffff, 0x83868c, 1.85);
  sky.position.set(0, 0, 1);
  scene.add(sky, scene.userData.lamp);
}
