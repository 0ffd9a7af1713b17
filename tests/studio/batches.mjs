// SPDX-License-Identifier: GPL-3.0-or-later
// A batch whose rooms are looked at, chosen by measure and opened; variants of a room side by side.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PROGRAM, call, seriousFaults, shown, until, withStudio } from './studio.mjs';

const BRIEFS = ['A bedroom that is 4m x 5m.', 'A small green boho dining room.', 'A home office for two with a bookshelf.',
  'A kitchen that is 3m x 4m.', 'A study with a desk.', 'A library with two armchairs.'];

await withStudio(async ({ page, studio, home, restart }) => {
  // A batch that the program itself has run before.
  await studio.stop();
  const file = join(home, 'rooms.txt');
  writeFileSync(file, `${BRIEFS.join('\n')}\n`);
  execFileSync(PROGRAM, ['batch', file, '--out', join(home, 'out')], { env: { ...process.env, FLAIR_HOME: home }, stdio: 'ignore' });
  await restart();

  await page.getByText('Jobs and batches').click();
  await page.locator('.job').nth(BRIEFS.length - 1).waitFor();
  // What came of each, and all that it has stored.
  await page.locator('.job-result').first().waitFor();
  assert.match(await page.locator('.job-result').first().innerText(), /^(\d+ not as asked · )?\d+ pieces: \S/);
  await page.getByRole('button', { name: 'Details' }).first().click();
  await page.locator('.job-plan').waitFor();
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Layout', exact: true }).click();
  const { solvedLayout } = JSON.parse(readFileSync(await (await saved).path(), 'utf8'));
  assert.ok(solvedLayout.placements.length > 0);
  assert.deepEqual(await seriousFaults(page), [], 'the jobs');
  await page.getByRole('button', { name: 'Batches', exact: true }).click();
  await page.getByRole('link', { name: 'rooms.txt' }).click();
  await page.getByText(`${BRIEFS.length} of ${BRIEFS.length} ended`).waitFor();
  await page.locator('.tile img').nth(BRIEFS.length - 1).waitFor();
  assert.deepEqual(await seriousFaults(page), [], 'the batch');

  // Only rooms whose floor can be reached as far as that; measures come from the reports.
  const { batches } = await call(page, 'ListBatches', {}, 'OrchestratorService');
  const { jobs } = await call(page, 'ListJobs', { batchId: batches[0].id }, 'OrchestratorService');
  assert.equal(jobs.length, BRIEFS.length);
  const reached = [];
  for (const { artifacts } of jobs) {
    const { id } = artifacts.find(({ kind }) => kind === 'ARTIFACT_KIND_REPORT');
    const { artifact } = await call(page, 'GetArtifact', { artifactId: id }, 'OrchestratorService');
    reached.push(artifact.report.metrics.reachableFloorShare ?? 0);
  }
  await page.getByLabel('Floor in reach').fill('0.95');
  const expected = reached.filter((share) => share >= 0.95).length;
  await page.getByText(`${expected} of the ${BRIEFS.length} rooms`).waitFor();
  await page.getByLabel('Floor in reach').fill('0');
  await page.locator('.tile button').first().click();
  await page.locator('[data-piece]').first().waitFor();

  await page.goto(`${new URL(page.url()).origin}/#/jobs/workers`);
  await page.getByRole('cell', { name: 'optimizer' }).waitFor();
  assert.deepEqual(await seriousFaults(page), [], 'the workers');

  // Three variants: one is taken, then the first again.
  await page.getByRole('button', { name: 'New room' }).click();
  await page.getByRole('button', { name: 'Make 3 variants' }).click();
  await page.getByLabel('Brief').fill(BRIEFS[0]);
  await page.keyboard.press('Enter');
  const tile = (number) => page.getByRole('button', { name: new RegExp(`^Variant ${number}`) });
  const isShown = (number) => until(page, async () => (await tile(number).getAttribute('aria-pressed')) === 'true', `variant ${number}`);
  await tile(3).waitFor();
  await isShown(1);
  assert.deepEqual(await seriousFaults(page), [], 'the variants');
  const first = await shown(page);
  await tile(3).click();
  await isShown(3);
  assert.equal((await shown(page)).document.undoLabel, 'take variant 3');
  await tile(1).click();
  await isShown(1);
  const { document, layout } = await shown(page);
  assert.equal(document.undoLabel, 'take variant 1');
  assert.deepEqual(layout.placements, first.layout.placements);

  // Its job opens as it ended, beside the room as it is by now.
  await page.getByText('Jobs and batches').click();
  await page.getByRole('button', { name: 'Open result' }).first().click();
  await page.locator('[data-piece]').first().waitFor();
  const { document: result } = await shown(page);
  assert.notEqual(result.id, document.id);
  assert.deepEqual([result.layoutId, result.undoLabel ?? ''], [first.document.layoutId, '']);
  await page.getByText('Jobs and batches').click();
  await page.getByRole('button', { name: 'Go to its room' }).click();
  await page.locator('[data-piece]').first().waitFor();
  assert.ok(page.url().endsWith(document.id));
});

// A batch whose program was killed waits in the store; it goes on here, is paused and cancelled.
await withStudio(async ({ page, studio, home, restart }) => {
  await studio.stop();
  const file = join(home, 'many.txt');
  writeFileSync(file, Array.from({ length: 200 }, (_, i) => `A bedroom that is 4m x ${3 + i / 100}m.\n`).join(''));
  const batch = spawn(PROGRAM, ['batch', file, '--out', join(home, 'out')], {
    env: { ...process.env, FLAIR_HOME: home },
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  await new Promise((begun) => {
    let said = '';
    batch.stderr.on('data', (bytes) => {
      said += bytes;
      if (said.includes('/200')) begun();
    });
  });
  batch.kill('SIGKILL');
  await restart();
  await page.goto(`${new URL(page.url()).origin}/#/jobs/batches`);
  await page.getByText('waiting ·').waitFor();
  await page.getByRole('button', { name: 'Resume' }).click();
  await page.getByText('running ·').first().waitFor();
  await page.getByRole('link', { name: 'many.txt' }).click();
  await page.locator('.tile img').first().waitFor();
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByText('paused').waitFor();
  await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  await page.getByText('200 of 200 ended').waitFor();
});
console.log('batch looked at, variant taken; batch resumed, paused, cancelled');
