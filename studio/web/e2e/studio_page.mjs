// SPDX-License-Identifier: GPL-3.0-or-later
// The page in Debian's Chromium, over its own fake server or, with FLAIR_STUDIO_URL, a real one.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "../scripts/serve.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

export class StudioPage {
  // Everything that went wrong in the page itself.
  faults = [];

  static async open({ theme = "light", width = 1440, height = 900 } = {}) {
    const self = new StudioPage();
    self.server = process.env.FLAIR_STUDIO_URL ? { url: process.env.FLAIR_STUDIO_URL, close() {} }
      : await serve(resolve(root, "../../build/studio_web_dev"));
    self.browser = await chromium.launch({
      executablePath: process.env.FLAIR_CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
    self.page = await self.browser.newPage({
      viewport: { width, height },
      colorScheme: theme,
      reducedMotion: "reduce",
    });
    self.page.on("pageerror", (error) => self.faults.push(error.message));
    self.page.on("console", (message) => { if (message.type() === "error") self.faults.push(message.text()); });
    await self.page.goto(self.server.url);
    await self.page.waitForSelector(".examples");
    return self;
  }

  async close() {
    await this.browser.close();
    this.server.close();
  }

  // A room of a brief, furnished and drawn.
  async design(brief) {
    await this.page.fill(".brief textarea", brief);
    await this.page.keyboard.press("Enter");
    await this.page.waitForSelector(".piece", { timeout: 60_000 });
    await this.page.waitForSelector(".measures");
  }

  // The floor that a piece covers, in pixels of the page.
  box(id) {
    return this.page.locator(`[data-piece="${id}"] > .hit`).boundingBox();
  }

  async select(id) {
    const { x, y } = await this.box(id);
    await this.page.mouse.click(x + 8, y + 8);
    await this.page.waitForSelector(".piece-name");
  }

  // Drags a piece by its corner, in steps; `before` is run with the button still down.
  async drag(id, dx, dy, before = async () => {}) {
    const { x, y } = await this.box(id);
    await this.page.mouse.move(x + 8, y + 8);
    await this.page.mouse.down();
    for (let i = 1; i <= 10; i += 1) await this.page.mouse.move(x + 8 + (dx * i) / 10, y + 8 + (dy * i) / 10);
    await before();
    await this.page.mouse.up();
  }

  undoLabel() {
    return this.page.locator("[aria-label^='Undo']").getAttribute("aria-label");
  }

  field(label) {
    return this.page.locator(`.field:has-text("${label}") input`).inputValue();
  }

  // What axe-core finds that is serious, in words.
  async seriousFaults() {
    const client = await this.page.context().newCDPSession(this.page);
    // By the debugger: the page's policy lets nobody else run a script.
    await client.send("Runtime.evaluate", { expression: axe });
    const { result } = await client.send("Runtime.evaluate", {
      awaitPromise: true,
      expression: `axe.run(document).then(({ violations }) => JSON.stringify(violations
        .filter(({ impact }) => impact === "serious" || impact === "critical")
        .map(({ id, nodes }) => id + ": " + nodes.map((node) => node.target.join(" ")).join(", "))))`,
    });
    return JSON.parse(result.value);
  }
}
