// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/benchmarks.md says of the studio; by hand: node figures.mjs [MINUTES]. Prints one JSON object.
import { call, shown, until, withStudio } from './studio.mjs';

const kSoakMinutes = Number(process.argv[2] ?? 1);
const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];
const rounded = (value) => Math.round(value * 10) / 10;

// A room that is not shown: what a call takes then is its own.
async function made(page, brief) {
  const { document } = await call(page, 'CreateDocument', { requestId: brief, design: { brief: { text: brief } } });
  await until(page, async () => (await shown(page)).document.jobState === 'JOB_STATE_SUCCEEDED', brief);
  return shown(page);
}

async function open(page, brief) {
  const { document } = await made(page, brief);
  await page.reload();
  await page.getByText(document.title).first().click();
  await page.locator('[data-piece]').first().waitFor();
  return shown(page);
}

const middleOf = async (page, id) => {
  const box = await page.locator(`[data-piece="${id}"]`).first().boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

// Drags a piece to and fro over `frames` frames; what scripts took of each.
async function drag(page, id, frames) {
  const metrics = await page.context().newCDPSession(page);
  await metrics.send('Performance.enable');
  const scripting = async () => (await metrics.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'ScriptDuration').value;
  const at = await middleOf(page, id);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 10, at.y + 10, { steps: 4 });
  const before = await scripting();
  for (let i = 0; i < frames; ++i) {
    await page.mouse.move(at.x + 40 * Math.sin(i / 9), at.y + 25 * Math.cos(i / 7));
    await page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
  }
  const spent = (await scripting()) - before;
  await page.mouse.move(at.x, at.y);
  await page.mouse.up();
  return (1000 * spent) / frames;
}

async function timed(page, method, request) {
  const start = performance.now();
  const answer = await call(page, method, request);
  return { ms: performance.now() - start, answer };
}

const figures = {};
await withStudio(async ({ page }) => {
  await page.reload();
  const painted = () => page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  figures.first_paint_ms = rounded(await until(page, painted, 'a first paint'));
  figures.transferred_kb = rounded(await page.evaluate(() =>
    performance.getEntriesByType('resource').reduce((sum, { transferSize }) => sum + transferSize, 0) / 1000));

  let { document, layout } = await made(page, 'A restaurant of 9 m x 7 m with six tables for four guests each, a bar and plants.');
  figures.pieces = layout.placements.length;
  const piece = layout.placements.find(({ objectId }) => objectId.includes('table'));
  const verdicts = [];
  for (let i = 0; i < 200; ++i) {
    const there = { ...piece, xM: (piece.xM ?? 0) + 0.002 * i };
    verdicts.push((await timed(page, 'Judge', { documentId: document.id, revision: document.revision, placements: [there] })).ms);
  }
  figures.verdict_ms = { median: rounded(quantile(verdicts, 0.5)), p95: rounded(quantile(verdicts, 0.95)) };
  const settles = [];
  for (let i = 0; i < 40; ++i) {
    const there = { ...piece, xM: (piece.xM ?? 0) + 0.05 * ((i % 5) - 2) };
    const moved = await call(page, 'Act', { documentId: document.id, revision: document.revision, move: { placements: [there] } });
    const settled = await timed(page, 'Act', { documentId: document.id, revision: moved.document.revision, settle: {} });
    settles.push(settled.ms);
    document = settled.answer.document;
  }
  figures.settle_ms = { median: rounded(quantile(settles, 0.5)), p95: rounded(quantile(settles, 0.95)) };

  ({ document, layout } = await open(page, 'A banquet hall of 14 m x 20 m with ten round tables for eight guests each and a stage.'));
  figures.hall_pieces = layout.placements.length;
  const table = layout.placements.find(({ objectId }) => objectId.includes('table')).objectId;
  figures.scripting_ms_a_frame = rounded(await drag(page, table, 300));

  const memory = await page.context().newCDPSession(page);
  const heap = async () => {
    await memory.send('HeapProfiler.collectGarbage');
    return (await memory.send('Runtime.getHeapUsage')).usedSize / 1e6;
  };
  await drag(page, table, 60);
  const start = await heap();
  const end = Date.now() + kSoakMinutes * 60_000;
  let rounds = 0;
  for (; Date.now() < end; ++rounds) {
    await drag(page, table, 30);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Escape');
  }
  figures.soak = { minutes: kSoakMinutes, rounds, heap_mb: [rounded(start), rounded(await heap())] };
});
console.log(JSON.stringify(figures, null, 1));
