// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Chromium over its debugging pipe (Chrome DevTools Protocol), with nothing but Node.
import {spawn} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

/** Without a number Chromium tells the page of a key and does nothing itself. */
const kKeyCodes = {Enter: 13, Escape: 27, " ": 32, ArrowUp: 38, ArrowDown: 40};

export class Chromium {
  static async start(program) {
    const browser = new Chromium(program);
    const {targetId} = await browser.call("Target.createTarget", {url: "about:blank"});
    browser.session = (await browser.call("Target.attachToTarget", {targetId, flatten: true})).sessionId;
    return browser;
  }

  constructor(program) {
    this.profile = fs.mkdtempSync(path.join(os.tmpdir(), "hydrabench-browser-"));
    // SwiftShader draws WebGL without a graphics card.
    this.child = spawn(program, ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
      "--hide-scrollbars", "--user-data-dir=" + this.profile, "about:blank"], {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
    this.waiting = new Map();
    this.listeners = [];
    this.next = 0;
    let rest = "";
    this.child.stdio[4].setEncoding("utf8").on("data", (chunk) => {
      rest += chunk;
      for (let end; (end = rest.indexOf("\0")) >= 0; rest = rest.slice(end + 1)) this.receive(JSON.parse(rest.slice(0, end)));
    });
    this.child.on("exit", () => {
      for (const {reject} of this.waiting.values()) reject(new Error("Chromium ended"));
    });
  }

  receive(message) {
    if (!message.id) {
      for (const listener of this.listeners) listener(message.method, message.params);
      return;
    }
    const {resolve, reject} = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) reject(new Error(message.error.message));
    else resolve(message.result);
  }

  call(method, params = {}) {
    return new Promise((resolve, reject) => {
      const id = ++this.next;
      this.waiting.set(id, {resolve, reject});
      this.child.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.session}) + "\0");
    });
  }

  /** The value of an expression in the page; promises are waited for. */
  async evaluate(expression) {
    const {result, exceptionDetails} = await this.call("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until an expression is true. */
  async until(expression, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    while (!(await this.evaluate("Boolean(" + expression + ")"))) {
      if (Date.now() > end) throw new Error("waited in vain for " + expression);
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }

  async click(x, y) {
    for (const type of ["mousePressed", "mouseReleased"]) await this.call("Input.dispatchMouseEvent", {type, x, y, button: "left", clickCount: 1});
  }

  /** Presses a key: a character, or one that kKeyCodes names. */
  async key(key) {
    const text = key === "Enter" ? "\r" : key.length === 1 ? key : undefined;
    for (const type of ["keyDown", "keyUp"]) {
      await this.call("Input.dispatchKeyEvent", {type, key, code: key, windowsVirtualKeyCode: kKeyCodes[key], text: type === "keyDown" ? text : undefined});
    }
  }

  async screenshot(file) {
    const {data} = await this.call("Page.captureScreenshot", {format: "png"});
    fs.writeFileSync(file, Buffer.from(data, "base64"));
  }

  async stop() {
    this.session = undefined;
    await this.call("Browser.close").catch(() => {});
    await new Promise((resolve) => (this.child.exitCode === null ? this.child.on("exit", resolve) : resolve()));
    fs.rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}
