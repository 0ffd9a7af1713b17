// SPDX-License-Identifier: GPL-3.0-or-later
// A studio with a store of its own, and a real Chromium that looks at it. FLAIR names the program, FLAIR_CHROMIUM the browser.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

export const PROGRAM = process.env.FLAIR ?? new URL('../../build/release/bin/flair', import.meta.url).pathname;
const CHROMIUM = process.env.FLAIR_CHROMIUM ?? '/usr/bin/chromium';
// Machines are shared: what takes seconds alone may take a minute.
export const PATIENCE_MS = 120_000;

/** A running `flair studio`; `stop` ends it as ^C does, `kill` as a crash does. */
export class Studio {
  constructor(home, port) {
    this.home = home;
    this.process = spawn(PROGRAM, ['studio', '--port', String(port)], {
      env: { ...process.env, FLAIR_HOME: home },
      stdio: ['ignore', 'ignore', 'pipe'],
    });
    this.exited = new Promise((done) => this.process.once('exit', done));
    this.said = '';
    this.url = new Promise((found, failed) => {
      this.process.stderr.on('data', (bytes) => {
        this.said += bytes;
        const url = this.said.match(/http:\/\/\S+/);
        if (url) found(url[0]);
      });
      this.exited.then((code) => failed(new Error(`flair studio ended with ${code}: ${this.said}`)));
    });
    this.url.catch(() => {});
  }
  async stop() {
    this.process.kill('SIGTERM');
    return this.exited;
  }
  async kill() {
    this.process.kill('SIGKILL');
    return this.exited;
  }
}

/** Calls `run({ studio, page, context, restart })` with a page that has opened the studio; whatever happens, ends both. */
export async function withStudio(run, { viewport = { width: 1440, height: 900 } } = {}) {
  const home = mkdtempSync(join(tmpdir(), 'flair-studio-'));
  let studio = new Studio(home, 0);
  const browser = await chromium.launch({
    executablePath: CHROMIUM,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking', '--disable-component-update'],
  });
  const faults = [];
  try {
    const context = await browser.newContext({ viewport, acceptDownloads: true });
    context.setDefaultTimeout(PATIENCE_MS);
    const page = await context.newPage();
    page.on('pageerror', (error) => faults.push(`page: ${error.message}`));
    await page.goto(await studio.url);
    const restart = async () => {
      await studio.kill();
      studio = new Studio(home, 0);
      await page.goto(await studio.url);
      return studio;
    };
    await run({ studio, page, context, restart, home });
    if (faults.length > 0) throw new Error(faults.join('\n'));
  } finally {
    await browser.close();
    await studio.stop();
    rmSync(home, { recursive: true, force: true });
  }
}

/** A call of the studio's service from the page, as JSON; throws what the server says. */
export async function call(page, method, request, service = 'StudioService') {
  return page.evaluate(
    async ([path, body]) => {
      const response = await fetch(path, {
        method: 'POST',
        headers: { 'Content-Type': 'application/json' },
        body: JSON.stringify(body),
      });
      const answer = await response.json();
      if (!response.ok) throw new Error(`${answer.code}: ${answer.message}`);
      return answer;
    },
    [`/flair.v1.${service}/${method}`, request],
  );
}

/** The document that the page shows, with its layout. */
export async function shown(page) {
  const { documents } = await call(page, 'ListDocuments', {});
  return call(page, 'GetDocument', { documentId: documents[0].id });
}

/** The layout's file, base64: the same bytes, the same text. */
export async function layoutBytes(page, documentId) {
  const file = await call(page, 'ExportDocument', { documentId, format: 'DOCUMENT_FORMAT_LAYOUT_PB' });
  return file.content;
}

/** Looks again until `look` says something true, without a clock of its own: each look waits for the page. */
export async function until(page, look, what) {
  const end = Date.now() + PATIENCE_MS;
  for (;;) {
    const seen = await look();
    if (seen) return seen;
    if (Date.now() > end) throw new Error(`never came: ${what}`);
    await page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
  }
}

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What axe-core finds of the whole page that is serious or worse. */
export async function seriousFaults(page) {
  // The page's own policy takes no script of others; a test's comes from beside it.
  const found = await page.evaluate(`${axe}; axe.run(document, { resultTypes: ['violations'] })`);
  return found.violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}
