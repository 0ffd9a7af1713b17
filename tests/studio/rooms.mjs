// SPDX-License-Identifier: GPL-3.0-or-later
// What one does with whole rooms: names, copies, the bin, files; and what the page itself says and shows.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { call, layoutBytes, seriousFaults, shown, until, withStudio } from './studio.mjs';

const titles = async (page) => (await call(page, 'ListDocuments', {})).documents?.map(({ title }) => title) ?? [];
const fields = async (page) => Object.fromEntries(await page.locator('.fields label').evaluateAll(
  (labels) => labels.map((label) => [label.querySelector('span').textContent, label.querySelector('input').value])));

await withStudio(async ({ page }) => {
  await page.getByLabel('Brief').fill('A bedroom that is 4m x 5m.');
  await page.keyboard.press('Enter');
  await page.locator('[data-piece]').first().waitFor();
  const { document: made } = await shown(page);
  const message = page.locator('.message-text');
  const more = async (title, act) => {
    await page.locator('.document', { hasText: title }).hover();
    await page.getByRole('button', { name: `More about ${title}`, exact: true }).click();
    await page.getByRole('menuitem', { name: act }).click();
  };

  // A name of its own, given in the list.
  await more(made.title, 'Rename');
  await page.getByLabel('Name of the room').fill('Attic');
  await page.keyboard.press('Enter');
  await until(page, async () => (await titles(page)).includes('Attic'), 'the name');
  assert.equal(await page.getByLabel('Title').inputValue(), 'Attic');
  await page.getByText('Asked: “A bedroom that is 4m x 5m.”').waitFor();

  // A copy is open, and as the original.
  const bytes = await layoutBytes(page, made.id);
  await more('Attic', 'Copy');
  await until(page, async () => (await page.getByLabel('Title').inputValue()) === 'Copy of Attic', 'the copy');
  const { document: copy } = await shown(page);
  assert.equal(await layoutBytes(page, copy.id), bytes);
  assert.equal(copy.brief.text, made.brief.text);

  // What is deleted is offered back, at once and later.
  await more('Copy of Attic', 'Delete');
  await message.getByText('“Copy of Attic” is deleted.').waitFor();
  assert.deepEqual(await titles(page), ['Attic']);
  assert.deepEqual(await seriousFaults(page), [], 'the start page with a message');
  await page.getByRole('button', { name: 'Put it back' }).click();
  await page.locator('[data-piece]').first().waitFor();
  assert.equal(await layoutBytes(page, copy.id), bytes);
  await more('Copy of Attic', 'Delete');
  await page.getByText('1 deleted').click();
  await page.getByRole('button', { name: 'Put back', exact: true }).click();
  await until(page, async () => (await titles(page)).length === 2, 'the room from the bin');
  await page.getByRole('link', { name: /^Attic/ }).click();
  await page.locator('[data-piece]').first().waitFor();

  // Files are told by their names; everything is one archive.
  const exported = async (label) => {
    await page.getByRole('button', { name: 'Export' }).click();
    const saved = page.waitForEvent('download');
    await page.getByRole('menuitem', { name: label }).click();
    const file = await saved;
    await message.getByText(`Saved ${file.suggestedFilename()}.`).waitFor();
    return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
  };
  const list = await exported('List of furniture');
  assert.equal(list.name, 'attic-furniture.csv');
  assert.match(list.bytes.toString(), /^name,count,width_m,depth_m,height_m,where\r\ndouble bed,1,/);
  const all = await exported('Everything in one archive');
  assert.equal(all.name, 'attic.zip');
  for (const name of ['plan.png', 'plan.svg', 'plan.pdf', 'view-from-above.png', 'furniture.csv', 'artifacts/layout.pb'])
    assert.ok(all.bytes.includes(name), name);

  // Messages have a place of their own.
  const plan = await page.locator('.plan').boundingBox(), bar = await page.locator('.message-bar').boundingBox();
  assert.ok(plan.y + plan.height <= bar.y + 0.5, 'nothing lies over the plan');

  // What hangs from the ceiling is taken by its name, and lets through to what stands below it.
  const bed = await page.locator('[data-piece^="double_bed"]').first().boundingBox();
  await page.keyboard.press('f');
  await page.getByRole('searchbox').fill('iron ring chandelier');
  await page.locator('.offer', { hasText: 'iron ring chandelier' }).first().locator('button').first().dragTo(page.locator('.plan-drawing'),
    { targetPosition: { x: bed.x + bed.width / 2 - plan.x, y: bed.y + bed.height / 2 - plan.y } });
  const label = page.locator('text.is-of-ceiling', { hasText: 'iron ring chandelier' });
  await label.waitFor();
  await until(page, async () => (await fields(page))['Above floor'] === '2.50', 'the chandelier at its height');
  await page.locator('.plan').focus();
  await page.keyboard.press('Escape');
  const disc = await page.locator('[data-piece="iron_ring_chandelier"]').first().boundingBox();
  await page.mouse.click(disc.x + disc.width * 0.75, disc.y + disc.height - 2);
  await until(page, async () => (await page.getByLabel('Name', { exact: true }).inputValue()) === 'Double bed', 'the bed');
  await page.keyboard.press('Escape');
  await label.click();
  await until(page, async () => (await page.getByLabel('Name', { exact: true }).inputValue()) === 'Iron ring chandelier', 'the chandelier');

  // A copy of a piece has on it what its original has.
  const { layout } = await shown(page);
  const objects = layout.graph.objectList.objects;
  const rider = objects.find(({ kind, hostId }) => kind === 'OBJECT_KIND_SURFACE' && /nightstand/.test(hostId ?? ''));
  const host = await page.locator(`[data-piece="${rider.hostId}"]`).first().boundingBox();
  await page.locator('.plan').focus();
  await page.keyboard.press('Escape');
  await page.mouse.click(host.x + host.width * 0.2, host.y + host.height * 0.75);
  await page.keyboard.press('Control+d');
  const doubled = await until(page, async () => {
    const now = await shown(page);
    return now.document.undoLabel?.startsWith('add') && now.layout.placements.length > layout.placements.length && now.layout;
  }, 'the copy of the nightstand');
  const known = new Set(objects.map(({ id }) => id));
  const added = doubled.graph.objectList.objects.filter(({ id }) => !known.has(id));
  assert.ok(added.some(({ kind, hostId }) => kind === 'OBJECT_KIND_SURFACE' && added.some(({ id }) => id === hostId)));

  // Buttons say what they do, also while they can do nothing.
  await page.getByRole('button', { name: 'Auto' }).hover();
  await page.locator('.tip', { hasText: 'Auto is off' }).waitFor();

  // On a tablet nothing lies over anything.
  await page.setViewportSize({ width: 834, height: 1112 });
  const side = await page.locator('.sidebar').boundingBox(), stage = await page.locator('.stage').boundingBox();
  assert.ok(side.x + side.width <= stage.x + 0.5);
  await page.setViewportSize({ width: 1440, height: 900 });

  // The kind of a room is chosen, or said.
  await page.locator('.plan').focus();
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Edit room' }).click();
  const kind = page.locator('label', { hasText: 'Kind of room' }).locator('select, input');
  assert.equal(await kind.inputValue(), 'bedroom');
  await kind.selectOption('guest room');
  assert.equal(await kind.inputValue(), 'guest room');
  await kind.selectOption('another');
  await page.keyboard.type('box room');
  await page.keyboard.press('Enter');
  await until(page, async () => (await kind.inputValue()) === 'box room', 'the kind of room');
  assert.deepEqual(await seriousFaults(page), [], 'the drawing');
});
console.log('named, copied, deleted and put back; saved; taken by its name');
