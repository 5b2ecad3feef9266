// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// What a report keeps, tells apart and lets go of: the focus, worlds and objects, memory. For look_at_report.mjs; each takes
// {browser, check(ok, text), go(hash), open(file), report}.
import fs from "node:fs";
import path from "node:path";

/** Put into a page before anything else runs there: onCard() then says what it has on the graphics card. */
export const kCountOnCard = `(() => {
  const kinds = ["Buffer", "Texture", "VertexArray", "Program", "Shader"].map((kind) => [kind, new Set()]);
  for (const [kind, alive] of kinds) {
    const gl = WebGL2RenderingContext.prototype;
    const {["create" + kind]: create, ["delete" + kind]: remove} = gl;
    gl["create" + kind] = function (...all) { const made = create.apply(this, all); alive.add(made); return made; };
    gl["delete" + kind] = function (which) { alive.delete(which); return remove.call(this, which); };
  }
  window.onCard = () => kinds.map(([kind, alive]) => alive.size + " " + kind).join(", ");
})()`;

/** An object of the first world that a method found. */
export const matchedBy = (browser, method) => browser.evaluate("(() => { const world = JSON.parse(document.getElementById('scene').textContent).worlds[0]; return 'office_quick/1/' + world.truths[world.methods.find((m) => m.method === '" + method + "').matches[0].truth].id; })()");

/** Does something by keyboard with a control, found by its data-name: afterwards it, or the one in its place, has the focus. */
async function keeps({browser, check}, page, name, key, changed) {
  const control = "[...document.querySelectorAll('#page-" + page + " [data-name]')].find((c) => c.dataset.name === " + JSON.stringify(name) + ")";
  const what = page + ", " + name;
  await browser.until(control);
  await browser.evaluate("{window.old = " + control + "; old.focus();}");
  await browser.key(key);
  await browser.until(changed);
  check(await browser.evaluate("document.activeElement === " + control), what + ": the focus went to " + await browser.evaluate("document.activeElement.outerHTML.slice(0, 80)"));
  check(await browser.evaluate("old !== " + control), what + ": nothing was drawn anew, so this says nothing");
}

export async function theFocus(look) {
  const {browser, check, go} = look;
  await go("tab=table&theme=light");
  const pressed = (page, name) => "document.querySelector(\"#page-" + page + " [data-name='" + name + "']\").getAttribute('aria-pressed') === 'true'";
  await keeps(look, "table", "matching exists", " ", pressed("table", "matching exists"));
  await keeps(look, "table", "matching one_to_one", "Enter", pressed("table", "matching one_to_one"));
  await keeps(look, "table", "sort recall", "Enter", "document.querySelectorAll('#page-table .comparison th')[2].ariaSort === 'descending'");
  await keeps(look, "table", "cells p", "Enter", pressed("table", "cells p"));
  await go("tab=thresholds&theme=light");
  await keeps(look, "thresholds", "95 % intervals", " ", "!document.querySelector('#page-thresholds [type=checkbox]').checked");
  await keeps(look, "thresholds", "Hydra", " ", "document.querySelector('#page-thresholds tr.faint')");
  await go("tab=objects&theme=light");
  await keeps(look, "objects", "world", "ArrowDown", "location.hash.includes('office_quick%2F2')");
  await keeps(look, "objects", "matching exists", " ", "location.hash.includes('matching=exists')");
  await go("tab=scene&theme=light");
  await browser.until("document.querySelectorAll('.list li').length > 0");
  await keeps(look, "scene", "matching", "ArrowUp", "location.hash.includes('matching=exists')");
  await keeps(look, "scene", "colour by", "ArrowDown", "document.querySelectorAll('.left select')[3].value === 'outcome'");
  await keeps(look, "scene", "Hydra", " ", "true");
  await keeps(look, "scene", "list", "ArrowDown", "document.querySelector('.right h2')");
  await keeps(look, "scene", "next", "Enter", "document.querySelector('.list li:nth-child(2)[aria-selected=true]')");
  await go("tab=scene&theme=light&method=oracle_shape&object=" + encodeURIComponent(await matchedBy(browser, "oracle_shape")));
  await keeps(look, "scene", "heat", "Enter", "document.querySelector('.captions')");
  await keeps(look, "scene", "every method", " ", "document.querySelectorAll('.captions > div').length === 2 && document.querySelector('.overlay [type=checkbox]').checked");
  // What closes itself leaves the focus where it was.
  await browser.evaluate("[...document.querySelectorAll('.title button')].at(-1).focus()");
  await browser.key("Enter");
  await browser.until("!document.querySelector('.right h2')");
  check(await browser.evaluate("document.activeElement.className === 'right'"), "the closed object took the focus with it");
}

/** The second world by keyboard, and one of its objects that has a namesake in the first. */
export async function theWorlds({browser, check, go}) {
  const object = (seed) => "JSON.parse(document.getElementById('scene').textContent).worlds.find((w) => w.seed === '" + seed + "').truths.find((t) => t.name === 'chair_001')";
  const rows = "[...document.querySelectorAll('#page-objects tbody tr')].filter((row) => row.cells[0].textContent === 'chair_001')";
  const seen = [];
  for (const seed of ["1", "2"]) {
    await go("tab=objects&theme=light&world=office_quick%2F" + seed);
    const cells = await browser.evaluate("[..." + rows + "[0].cells].map((cell) => cell.textContent)");
    await browser.evaluate(rows + "[0].querySelector('a').click()");
    // The panel says of it what the row does: that of the other world may stand there until this one is read.
    const said = JSON.stringify(cells.slice(1, 5).filter(Boolean));
    await browser.until("document.querySelector('.right h2')?.textContent === 'chair_001' && " + said + ".every((cell) => document.querySelector('.right .hint').textContent.includes(cell))");
    const {id} = await browser.evaluate(object(seed));
    check(await browser.evaluate("new URLSearchParams(location.hash.slice(1)).get('object')") === "office_quick/" + seed + "/" + id, "seed " + seed + ": the address is " + await browser.evaluate("location.hash"));
    seen.push(await browser.evaluate("document.querySelector('.right .hint').textContent"));
  }
  check(seen[0] !== seen[1], "both worlds show the same chair");
  // A link to an object of one world means nothing in the other.
  await go("tab=scene&theme=light&world=office_quick%2F2&object=office_quick%2F1%2F" + (await browser.evaluate(object("1"))).id);
  await browser.until("document.querySelector('.list li') && !document.querySelector('.right h2')");
}

/** The rows of the objects, the counts beside the scene and the pooled recall of the table are of one and the same matching. */
export async function theMatchings({browser, check, go}) {
  for (const matching of ["one_to_one", "exists"]) {
    let found = 0;
    let truths = 0;
    for (const seed of ["1", "2"]) {
      const at = "&theme=light&threshold=tau_m%3A0.5&matching=" + matching + "&world=office_quick%2F" + seed;
      await go("tab=objects" + at);
      const rows = await browser.evaluate("[...document.querySelectorAll('#page-objects tbody tr')].filter((row) => row.cells[5].textContent === 'Hydra').map((row) => row.cells[6].textContent)");
      const here = rows.filter((outcome) => outcome.startsWith("found")).length;
      await go("tab=scene" + at);
      await browser.until("document.querySelector('.list li')");
      const line = "[...document.querySelectorAll('.methodline')].find((l) => l.textContent.startsWith('Hydra'))";
      await browser.until("parseInt(" + line + ".querySelector('small').textContent) === " + here);
      found += here;
      truths += here + rows.filter((outcome) => outcome === "missed").length;
    }
    await go("tab=table&theme=light");
    for (const name of ["centre within 0.5", "matching " + matching]) await browser.evaluate("document.querySelector(\"#page-table [data-name='" + name + "']\").click()");
    const recall = await browser.evaluate("[...document.querySelectorAll('.comparison tbody tr')].find((row) => row.cells[0].textContent === 'Hydra').cells[2].querySelector('.value').textContent");
    check(recall === (found / truths).toFixed(3), matching + ": the table's recall is " + recall + ", the objects' " + found + " of " + truths);
  }
}

/** What was looked at leaves the graphics card with the look. */
export async function theMemory({browser, check, go}) {
  const rest = async (seed) => {
    await go("tab=scene&theme=light&method=hydra&world=office_quick%2F" + seed);
    await browser.until("document.querySelector('.list li')");
    await new Promise((resolve) => setTimeout(resolve, 1500));
    return browser.evaluate("onCard()");
  };
  const first = await rest(1);
  check(parseInt(first) > 10, "nothing was counted on the graphics card: " + first);
  await go("tab=scene&theme=light&method=hydra&world=office_quick%2F1&heat=1&object=" + encodeURIComponent(await matchedBy(browser, "hydra")));
  await browser.until("document.querySelector('.captions')");
  // What is out of sight stays off the card: the camera jumps, so that every heatmap is in sight at once.
  await browser.call("Emulation.setEmulatedMedia", {features: [{name: "prefers-reduced-motion", value: "reduce"}]});
  const seen = new Set();
  for (let i = 0; i < 20; ++i) {
    await browser.key("n");
    await browser.evaluate("new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)))");
    seen.add(await browser.evaluate("onCard()"));
  }
  await browser.call("Emulation.setEmulatedMedia", {features: []});
  check(seen.size > 1, "the heatmaps do not reach the graphics card");
  const second = await rest(1);
  check(second === first, "on the graphics card before 20 heatmaps: " + first + "; after: " + second);
  const other = await rest(2);
  const third = await rest(1);
  check(third === first && other !== first, "on the graphics card: " + first + "; with another world: " + other + "; back again: " + third);
}

/** Charts that others took the place of are gone. */
export async function theCharts({browser, check, go}) {
  await go("tab=thresholds&theme=light");
  const redraw = async (times) => {
    for (let i = 0; i < times; ++i) await browser.evaluate("document.querySelector(\"#page-thresholds [data-name='95 % intervals']\").click()");
    await new Promise((resolve) => setTimeout(resolve, 500));
    for (let i = 0; i < 2; ++i) await browser.call("HeapProfiler.collectGarbage");
    return browser.call("Memory.getDOMCounters");
  };
  const before = await redraw(20);
  const after = await redraw(20);
  check(after.nodes < before.nodes + 200, "20 redraws of the charts leave " + (after.nodes - before.nodes) + " elements");
}

/** Two objects of one name in one world. */
export async function theSameNames({browser, check, go, open, report}) {
  const copy = path.join(browser.profile, "same_names.html");
  fs.writeFileSync(copy, fs.readFileSync(report, "utf8").replaceAll('"name":"chair_002"', '"name":"chair_001"'));
  await open(copy);
  await go("tab=scene&theme=light");
  await browser.until("document.querySelector('.list li')");
  const items = "[...document.querySelectorAll('.list li')].filter((item) => item.textContent.startsWith('chair_001'))";
  const seen = [];
  for (const i of [0, 1]) {
    await browser.evaluate(items + "[" + i + "].click()");
    await browser.until(items + "[" + i + "].ariaSelected === 'true'");
    check(await browser.evaluate("document.querySelectorAll('.list [aria-selected=true]').length === 1"), "two objects are chosen at once");
    seen.push(await browser.evaluate("document.querySelector('.right h2').textContent"));
  }
  check(seen.every((name) => name.startsWith("chair_001 #")) && seen[0] !== seen[1], "two objects of one name are called " + seen);
}
