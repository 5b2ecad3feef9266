// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
import {json} from "../data.js";
import {checkbox, fill, h, select} from "../dom.js";
import {chosenWorld, isFound, settingControls, worldControl} from "../model.js";
import {isBound, methodLabel, methodTag, scaleGradient, swatch} from "../palette.js";
import {heatmapCells} from "../scene/heatmap.js";
import {find, joined} from "../scene/joined.js";
import {Layers} from "../scene/layers.js";
import {objectPanel} from "../scene/panel.js";
import {Viewer} from "../scene/viewer.js";
import {World} from "../scene/world.js";
import * as state from "../state.js";
import {onTheme} from "../theme.js";
import {Vector3} from "three";

/** From where a world may be looked at first: obliquely from above, all around. */
const kDirections = Array.from({length: 8}, (_, i) => new Vector3(Math.cos((i + 0.6) * Math.PI / 4), Math.sin((i + 0.6) * Math.PI / 4), 1.25));

const kHeatless = {missed: ": it missed this object", found: ": what it has here is nearer to another object"};

/** The scene of a world: what was mapped, what is there, and how far apart they are. */
export function sceneTab(page) {
  const scene = json("scene");
  if (scene.worlds.length === 0) {
    fill(page, h("p", {class: "empty"}, scene.missing));
    return {};
  }
  const tab = new SceneTab(page);
  tab.open();
  return {onshow: () => {
    tab.viewer?.resize();
    tab.catchUp();
  }};
}

class SceneTab {
  constructor(page) {
    this.stage = h("div", {class: "stage"});
    this.left = h("aside", {class: "left", "aria-label": "What is shown"});
    this.right = h("aside", {class: "right", "aria-label": "Chosen object"});
    this.tip = h("div", {class: "tip", hidden: true});
    this.overlay = h("div", {class: "overlay"});
    fill(page, this.left, h("div", {class: "middle"}, this.stage, this.overlay, this.tip), this.right);
    if (document.createElement("canvas").getContext("webgl2")) this.viewer = new Viewer(this.stage);
    else fill(this.stage, h("p", {class: "empty"}, "This browser gives no WebGL 2, so there is no scene; everything else works."));
    this.options = {methods: new Set(), scene: "", color: "method", truths: "none", lines: false, path: false, maxError: 0.1, every: false, cut: null};
    this.viewer?.onPick((ray) => this.click(ray), (ray, event) => this.hover(ray, event));
    document.addEventListener("keydown", (event) => this.key(event));
    onTheme(() => this.show());
    this.page = page;
    this.changed = new Set();
    state.onChange((changed) => {
      changed.forEach((key) => this.changed.add(key));
      this.catchUp();
    });
  }

  /** Follows what changed; only while it is seen, since a camera has nowhere to stand before a stage without a size. */
  catchUp() {
    if (this.page.hidden) return;
    const changed = this.changed;
    this.changed = new Set();
    if (changed.has("world")) this.open();
    else if (["object", "method", "threshold", "matching", "heat"].some((key) => changed.has(key))) this.refresh(changed);
  }

  async open() {
    const key = chosenWorld();
    this.viewer?.setCells(null);
    this.layers?.close();
    this.layers = null;
    this.before = null;
    this.world = joined(key);
    if (!this.world || !this.viewer) {
      fill(this.overlay);
      fill(this.left, worldControl(), !this.world && h("p", {class: "hint"}, "This world has no scene in this file; the remarks under Setup say why."));
      fill(this.right);
      return;
    }
    const world = this.world;
    const shapes = await World.open(world.data);
    if (this.world !== world) return;
    this.shapes = shapes;
    this.layers = new Layers(this.viewer, shapes);
    const names = world.methods.map((method) => method.name);
    const best = bestMethod(names);
    const wanted = state.get("method");
    if (names.includes(wanted) && !this.options.methods.has(wanted)) this.options.methods = new Set([wanted]);
    if (![...this.options.methods].some((name) => names.includes(name))) this.options.methods = new Set([best].filter((name) => names.includes(name)));
    if (!world.methods.some((method) => method.name === this.options.scene && method.scene !== null)) {
      const withScene = world.methods.filter((method) => method.scene !== null).map((method) => method.name);
      this.options.scene = withScene.includes(best) ? best : withScene[0] ?? "";
    }
    const box = this.layers.bounds(world);
    this.floor = box.min.z;
    this.setCut(this.options.cut ?? 1.6);
    this.show();
    this.viewer.lookAt(box, {directions: kDirections, jump: true, room: 1.03});
    if (this.selected()) this.flyTo(true);
  }

  refresh(changed) {
    if (!this.layers) return;
    this.world = joined(chosenWorld());
    const method = state.get("method");
    if (changed.has("method") && method && !this.options.methods.has(method) && this.world.methods.some((m) => m.name === method)) this.options.methods = new Set([method]);
    const heat = this.heating();
    this.show();
    if (changed.has("object") || changed.has("heat")) this.flyTo(heat !== Boolean(this.viewer.cells));
  }

  selected() {
    return this.world && find(this.world, state.get("object"));
  }

  method() {
    const wanted = state.get("method");
    const names = this.world.methods.map((method) => method.name);
    return names.includes(wanted) ? wanted : [...this.options.methods][0] ?? bestMethod(names);
  }

  heating() {
    return state.get("heat") === "1" && this.selected()?.truth !== undefined;
  }

  flyTo(jump = false) {
    const selected = this.selected();
    if (!selected) {
      if (this.before) this.viewer.fly(this.before.eye, this.before.target);
      this.before = null;
      return;
    }
    this.before ??= {eye: this.viewer.camera.position.clone(), target: this.viewer.controls.target.clone()};
    const [box] = this.layers.boxesOf(this.world, selected);
    this.viewer.lookAt(box, {jump, room: this.heating() ? 1.35 : 3});
  }

  show() {
    if (!this.layers) return;
    const selected = this.selected();
    this.layers.show({...this.options, world: this.world, selected});
    this.tip.hidden = true;
    const cells = this.heating() ? heatmapCells(this.shapes, this.world, selected.truth, this.method(), this.options) : [];
    this.viewer.setCells(cells.length > 0 ? cells : null);
    this.drawLeft();
    this.drawRight();
    this.drawOverlay();
  }

  setCut(height) {
    this.options.cut = height;
    this.viewer.cut.constant = height >= 4 ? 1e9 : this.floor + height;
    this.viewer.draw();
  }

  drawLeft() {
    const {world, options} = this;
    const change = (key) => (value) => { options[key] = value; this.show(); };
    const scroll = this.list?.scrollTop ?? 0;
    const counts = (method) => {
      if (!method.isScored) return String(method.objects.length);
      const found = [...method.ofTruth.values()].filter(isFound).length;
      const extra = method.objects.filter((object) => object.status === "unmatched" || object.status === "duplicate").length;
      return found + (extra > 0 ? " + " + extra : "");
    };
    fill(this.left,
      worldControl(),
      h("div", {class: "pair"}, settingControls(true)),
      h("fieldset", {}, h("legend", {}, "Objects of", h("small", {}, "found + false")), world.methods.map((method) => h("div", {class: "methodline"},
        checkbox(methodLabel(method.name), options.methods.has(method.name), (on) => { on ? options.methods.add(method.name) : options.methods.delete(method.name); this.show(); }, swatch(method.name)),
        h("small", {}, counts(method))))),
      h("div", {class: "twin"},
        select("colour by", [["method", "method"], ["outcome", "outcome"], ["error", "error"], ["class", "class"]], options.color, change("color")),
        select("ground truth", [["none", "missed"], ["wire", "wireframe"], ["veil", "translucent"], ["solid", "solid"]], options.truths, change("truths")),
        select("scene mesh", [["", "none"], ...world.methods.filter((method) => method.scene !== null).map((method) => [method.name, methodLabel(method.name)])], options.scene, change("scene")),
        h("label", {class: "field"}, h("span", {}, "cut above"), h("input", {type: "range", "data-name": "cut", min: 0.1, max: 4, step: 0.1, value: options.cut, oninput: (event) => this.setCut(Number(event.target.value))})),
        checkbox("match lines", options.lines, change("lines")),
        checkbox("camera path", options.path, change("path"))),
      this.objectList());
    this.list.scrollTop = scroll;
    const current = this.list.querySelector("[aria-selected=true]");
    current?.scrollIntoView({block: "nearest"});
  }

  /** Every object that can be chosen, in the order of n and p: the true ones, then what stands for none. */
  choices() {
    const result = this.world.truths.map((truth, t) => ({key: truth.key, truth: t, text: truth.name, hint: this.missed(t) ? "missed" : ""}));
    for (const method of this.world.methods) {
      if (!this.options.methods.has(method.name)) continue;
      for (const object of method.objects) {
        if (object.status === "matched" || (object.status === "unscored" && method.isScored)) continue;
        result.push({key: object.key, text: object.name + " " + object.class, hint: object.status === "unscored" ? "" : object.status === "duplicate" ? "duplicate" : "false"});
      }
    }
    return result;
  }

  missed(t) {
    const shown = this.world.methods.filter((method) => method.isScored && this.options.methods.has(method.name));
    return shown.length > 0 && shown.every((method) => method.ofTruth.get(t)?.kind === "missed");
  }

  objectList() {
    const choices = this.choices();
    const chosen = state.get("object");
    this.list = h("ul", {class: "list", role: "listbox", "data-name": "list", tabindex: "0", "aria-label": "objects", onkeydown: (event) => {
      const by = {ArrowDown: 1, ArrowUp: -1}[event.key];
      if (!by) return;
      event.preventDefault();
      this.step(by);
    }}, choices.map((choice) => h("li", {role: "option", "aria-selected": String(choice.key === chosen), onclick: () => this.choose(choice.key)},
      choice.text, choice.hint && h("small", {class: choice.hint === "missed" ? "missed" : "extra"}, choice.hint))));
    return h("div", {class: "choices"}, h("span", {class: "label"}, choices.length + " objects"), this.list);
  }

  drawRight() {
    const selected = this.selected();
    if (!selected) {
      fill(this.right, h("div", {class: "object"}, h("p", {class: "hint"}, "Click an object, or choose one from the list, to see what every method made of it."),
        h("dl", {class: "keys"}, [["n p", "next, previous object"], ["h", "its error heatmap"], ["Esc", "back"], ["drag, wheel", "turn, zoom"], ["right drag", "move"]].map(([keys, text]) => h("div", {}, h("dt", {}, keys), h("dd", {}, text))))));
      return;
    }
    fill(this.right, objectPanel({world: this.world, shapes: this.shapes, selected, method: this.method(), heat: this.heating(), actions: {
      step: (by) => this.step(by), close: () => this.choose(null), choose: (method) => state.set({method}),
      select: ({truth}) => this.choose(this.world.truths[truth].key), heat: () => this.toggleHeat()}}));
  }

  drawOverlay() {
    const cells = this.viewer.cells;
    const swatchOf = (color, text) => h("span", {class: "method"}, h("span", {class: "swatch", style: "--c:var(" + color + ")"}), text);
    const scale = () => h("div", {class: "scale"}, h("span", {}, "0"), h("i", {style: "background:" + scaleGradient()}), h("span", {}, "≥ " + Math.round(100 * this.options.maxError) + " cm"),
      select("scale", [["0.05", "5 cm"], ["0.1", "10 cm"], ["0.2", "20 cm"]], String(this.options.maxError), (value) => { this.options.maxError = Number(value); this.show(); }));
    if (cells) {
      const {columns} = this.viewer.gridSize();
      fill(this.overlay, h("div", {class: "captions", style: "--columns:" + columns}, cells.map((cell) => h("div", {}, h("b", {}, cell.caption), h("small", {}, cell.detail)))),
        h("div", {class: "corner"}, scale(), checkbox("every method", this.options.every, (every) => { this.options.every = every; this.show(); this.flyTo(true); })));
      return;
    }
    const outcome = this.heating() && this.world.methods.find((method) => method.name === this.method()).ofTruth.get(this.selected().truth)?.kind;
    const heatless = this.heating() && h("p", {class: "notice"}, methodLabel(this.method()) + " has nothing here to compare with" + (kHeatless[outcome] ?? "") + ".");
    fill(this.overlay, heatless, h("div", {class: "corner"},
      this.options.color === "error" && scale(),
      h("div", {class: "legend"}, (this.options.truths !== "none" || this.selected()?.truth !== undefined) && swatchOf("--truth", "ground truth"), swatchOf("--missed", "missed (ghost)"), swatchOf("--extra", "false or duplicate (crossed box)"), this.options.color === "outcome" && swatchOf("--found", "found"))));
  }

  hit(ray) {
    return ray && this.layers ? ray.intersectObjects(this.layers.pickable, false)[0]?.object.userData.pick : null;
  }

  click(ray) {
    const pick = this.hit(ray);
    if (!pick) return;
    if (pick.truth !== null && pick.truth !== undefined) state.set({object: this.world.truths[pick.truth].key, ...(pick.method ? {method: pick.method} : {}), heat: null});
    else this.choose(pick.key);
  }

  hover(ray, event) {
    const pick = this.hit(ray);
    this.tip.hidden = !pick;
    this.stage.classList.toggle("over", Boolean(pick));
    if (!pick) return;
    const truth = pick.truth !== null && pick.truth !== undefined ? this.world.truths[pick.truth].name : "";
    fill(this.tip, pick.method ? [methodTag(pick.method), " ", pick.name, truth && " for " + truth] : truth);
    const box = this.stage.getBoundingClientRect();
    this.tip.style.left = Math.min(event.clientX - box.left + 14, box.width - 220) + "px";
    this.tip.style.top = event.clientY - box.top + 14 + "px";
  }

  choose(key) {
    state.set({object: key, heat: null});
  }

  step(by) {
    const keys = this.choices().map((choice) => choice.key);
    const at = keys.indexOf(state.get("object"));
    if (keys.length > 0) state.set({object: keys[at < 0 ? (by > 0 ? 0 : keys.length - 1) : (at + by + keys.length) % keys.length]});
  }

  toggleHeat() {
    if (this.selected()?.truth !== undefined) state.set({heat: this.heating() ? null : "1"});
  }

  key(event) {
    if (state.get("tab") !== "scene" || !this.layers || event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input:not([type=checkbox]), select, textarea")) return;
    const action = {n: () => this.step(1), p: () => this.step(-1), h: () => this.toggleHeat(), Escape: () => (this.heating() ? this.toggleHeat() : this.choose(null))}[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

/** The method a reader most likely wants to see first: the best F1 that knows no ground truth. */
function bestMethod(names) {
  const block = json("tables")[0]?.blocks[0];
  const f1 = json("tables")[0]?.columns.findIndex((column) => column.metric === "f1");
  const rows = (block?.rows ?? []).filter((row) => names.includes(row.method) && !isBound(row.method) && row.cells[f1][0] !== null);
  return rows.sort((a, b) => b.cells[f1][0] - a.cells[f1][0])[0]?.method ?? names[0];
}
