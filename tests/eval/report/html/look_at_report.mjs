// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// node look_at_report.mjs CHROMIUM REPORT.html FOLDER: opens a report from disk without network, goes through it as a reader would and writes
// pictures of it. The report has two worlds, hydra and oracle_shape, and claims of which one was not run. Exit code 1 and a line per fault.
import {Chromium} from "./chromium.mjs";
import {kCountOnCard, matchedBy, theCharts, theFocus, theMatchings, theMemory, theSameNames, theWorlds} from "./report_habits.mjs";
import fs from "node:fs";
import path from "node:path";

const [program, report, folder] = process.argv.slice(2);
const faults = [];

/** How varied the canvas is: colours in it, and the share of pixels unlike its first. */
const pixels = `(() => {
  const canvas = document.querySelector(".stage canvas");
  const copy = document.createElement("canvas");
  copy.width = 160; copy.height = 160;
  copy.getContext("2d").drawImage(canvas, 0, 0, 160, 160);
  const data = copy.getContext("2d").getImageData(0, 0, 160, 160).data;
  const colors = new Set();
  let other = 0;
  for (let i = 0; i < data.length; i += 4) {
    colors.add(data[i] >> 3 << 10 | data[i + 1] >> 3 << 5 | data[i + 2] >> 3);
    other += Math.abs(data[i] - data[0]) + Math.abs(data[i + 1] - data[1]) + Math.abs(data[i + 2] - data[2]) > 24;
  }
  return {colors: colors.size, share: other / (data.length / 4)};
})()`;

const check = (ok, text) => { if (!ok) faults.push(text); };
fs.mkdirSync(folder, {recursive: true});

const browser = await Chromium.start(program);
browser.listeners.push((method, params) => {
  if (method === "Runtime.exceptionThrown") faults.push("exception: " + (params.exceptionDetails.exception?.description ?? params.exceptionDetails.text));
  if (method === "Runtime.consoleAPICalled" && ["error", "warning", "assert"].includes(params.type)) faults.push("console " + params.type + ": " + params.args.map((arg) => arg.value ?? arg.description).join(" "));
  if (method === "Log.entryAdded" && params.entry.level === "error") faults.push("log: " + params.entry.text);
  if (method === "Network.requestWillBeSent" && !/^(file|data|blob):/.test(params.request.url)) faults.push("request: " + params.request.url);
});
try {
  for (const domain of ["Runtime", "Log", "Page", "Network"]) await browser.call(domain + ".enable");
  await browser.call("Network.emulateNetworkConditions", {offline: true, latency: 0, downloadThroughput: 0, uploadThroughput: 0});
  await browser.call("Emulation.setDeviceMetricsOverride", {width: 1280, height: 800, deviceScaleFactor: 1, mobile: false});
  await browser.call("Page.addScriptToEvaluateOnNewDocument", {source: kCountOnCard});
  await open(report);
  for (const theme of ["light", "dark"]) await everyTab(theme);
  await theTable();
  await theObjects();
  await theScene();
  await theClaims();
  const look = {browser, check, go, open, report};
  for (const habit of [theFocus, theWorlds, theMatchings, theMemory, theCharts, theSameNames]) await habit(look);
} catch (error) {
  faults.push(error.message);
}
await browser.stop();
for (const fault of faults) console.log(fault);
console.log(faults.length === 0 ? "report: nothing to complain about" : "report: " + faults.length + " faults");
process.exit(faults.length === 0 ? 0 : 1);

async function go(hash) {
  await browser.evaluate("location.hash = " + JSON.stringify(hash));
  await new Promise((resolve) => setTimeout(resolve, 300));
}

async function open(file) {
  await browser.call("Page.navigate", {url: "file://" + path.resolve(file)});
  await browser.until("document.querySelectorAll('[role=tab]').length === 7");
}

async function everyTab(theme) {
  for (const tab of ["table", "thresholds", "claims", "objects", "scene", "timing", "setup"]) {
    await go("tab=" + tab + "&theme=" + theme);
    await browser.until("!document.getElementById('page-" + tab + "').hidden && document.getElementById('page-" + tab + "').textContent.length > 20");
    if (tab === "scene") await browser.until("document.querySelectorAll('.list li').length > 0");
    await new Promise((resolve) => setTimeout(resolve, 500));
    await browser.screenshot(path.join(folder, tab + "_" + theme + ".png"));
  }
  const page = await browser.evaluate("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)");
  check(theme === "dark" ? page[0] < 80 : page[0] > 200, theme + ": the page is rgb " + page);
}

async function theTable() {
  await go("tab=table&theme=light");
  const rows = "[...document.querySelectorAll('#page-table .comparison tbody tr')]";
  check(await browser.evaluate(rows + ".length >= 2"), "the table has no rows");
  const recalls = rows + ".map((row) => Number(row.cells[2].querySelector('.value').textContent))";
  const button = "document.querySelectorAll('#page-table .comparison thead button')[2]";
  await browser.evaluate(button + ".click()");
  const down = await browser.evaluate(recalls);
  check(await browser.evaluate(button + ".parentElement.getAttribute('aria-sort') === 'descending'"), "aria-sort is not set");
  await browser.evaluate(button + ".click()");
  const up = await browser.evaluate(recalls);
  check(down[0] > up[0] && JSON.stringify([...down].sort((a, b) => b - a)) === JSON.stringify(down), "recall does not sort: " + down + " and " + up);
  const before = await browser.evaluate("document.querySelector('#page-table .comparison').textContent");
  await browser.evaluate("[...document.querySelectorAll('#page-table .segments button')].find((b) => b.getAttribute('aria-pressed') === 'false').click()");
  check(before !== await browser.evaluate("document.querySelector('#page-table .comparison').textContent"), "another threshold shows the same table");
}

async function theObjects() {
  await go("tab=objects&theme=light");
  const count = "parseInt(document.querySelector('#page-objects output').textContent)";  // "12 of 30 rows"
  const all = await browser.evaluate(count);
  await browser.evaluate("{const box = document.getElementById('object-filter'); box.value = 'chair'; box.dispatchEvent(new Event('input', {bubbles: true}));}");
  const some = await browser.evaluate(count);
  check(some > 0 && some < all, "the filter leaves " + some + " of " + all + " rows");
  await browser.evaluate("{const box = document.getElementById('object-filter'); box.value = ''; box.dispatchEvent(new Event('input', {bubbles: true}));}");
  // From a row to the same object in the scene.
  const name = await browser.evaluate("document.querySelector('#page-objects tbody a').textContent");
  await browser.evaluate("document.querySelector('#page-objects tbody a').click()");
  await browser.until("!document.getElementById('page-scene').hidden && document.querySelector('.right h2')?.textContent === " + JSON.stringify(name));
}

async function theScene() {
  await go("tab=scene&theme=light");
  await browser.until("document.querySelectorAll('.list li').length > 0");
  await new Promise((resolve) => setTimeout(resolve, 1500));
  const whole = await browser.evaluate(pixels);
  check(whole.share > 0.05 && whole.colors > 20, "the canvas looks empty: " + JSON.stringify(whole));

  // Two clicks: an object in the scene, its heatmap.
  const {left, top, width, height} = await browser.evaluate("JSON.parse(JSON.stringify(document.querySelector('.stage canvas').getBoundingClientRect()))");
  let clicked = false;
  for (let i = 0; i < 40 * 40 && !clicked; ++i) {
    const x = left + width * (0.1 + 0.8 * ((i * 17) % 40) / 40);
    const y = top + height * (0.1 + 0.7 * Math.floor(i / 40) / 40);
    await browser.call("Input.dispatchMouseEvent", {type: "mouseMoved", x, y});
    if (!(await browser.evaluate("!document.querySelector('.tip').hidden && /chair|couch|bin|plant/.test(document.querySelector('.tip').textContent)"))) continue;
    await browser.click(x, y);
    await new Promise((resolve) => setTimeout(resolve, 800));
    clicked = await browser.evaluate("Boolean(document.getElementById('heat'))");
  }
  check(clicked, "no object could be clicked");
  if (!clicked) return;
  await browser.screenshot(path.join(folder, "object.png"));
  await browser.evaluate("document.getElementById('heat').click()");
  await new Promise((resolve) => setTimeout(resolve, 1500));
  await browser.screenshot(path.join(folder, "heatmap.png"));
  check(await browser.evaluate("location.hash.includes('heat=1') && document.querySelectorAll('.captions > div').length === 2 && Boolean(document.querySelector('.scale'))"), "no heatmap after two clicks");
  const heat = await browser.evaluate(pixels);
  check(heat.share > 0.02 && heat.colors > 5, "the heatmap looks empty: " + JSON.stringify(heat));

  // By keyboard: next object, out of the heatmap, away.
  const before = await browser.evaluate("document.querySelector('.right h2').textContent");
  await browser.key("n");
  await browser.until("document.querySelector('.right h2').textContent !== " + JSON.stringify(before));
  await browser.key("Escape");
  await browser.key("Escape");
  await browser.until("!document.querySelector('.right h2')");

  // The view with its masks, of a method that estimates shapes.
  await go("tab=scene&theme=light&method=oracle_shape");
  await go("tab=scene&theme=light&method=oracle_shape&object=" + encodeURIComponent(await matchedBy(browser, "oracle_shape")));
  await browser.until("document.querySelector('.view canvas')?.width > 100");
  await new Promise((resolve) => setTimeout(resolve, 800));
  await browser.screenshot(path.join(folder, "best_view.png"));
}

async function theClaims() {
  await go("tab=claims&theme=light");
  const verdicts = await browser.evaluate("[...document.querySelectorAll('#page-claims > .claim')].map((claim) => claim.querySelector('h2').textContent)");
  check(JSON.stringify(verdicts) === JSON.stringify(["holdsTrue shapes have the best box IoUTest", "failsTrue shapes have the worst box IoUTest"]), "claims: " + verdicts);
  const row = await browser.evaluate("document.querySelector('#page-claims .claim tbody tr').textContent");
  check(/^holdsb_iou of the found at 0.5 m, .*: Oracle shape .*, Hydra .*\+0\.\d+\+0\.\d+ to \+0\.\d+> 0$/.test(row), "claims: the comparison reads " + row);
  check(await browser.evaluate("!document.querySelector('#page-claims details').open && document.querySelectorAll('#page-claims details .claim').length === 1"), "claims: what was not run is not folded");
}
