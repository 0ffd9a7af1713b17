// SPDX-License-Identifier: GPL-3.0-or-later
// From a brief to an edited room: what one does in the studio, done with the mouse and the keys.
import assert from 'node:assert/strict';
import { call, layoutBytes, seriousFaults, shown, until, withStudio } from './studio.mjs';

const placeOf = (layout, id) => layout.placements.find(({ objectId }) => objectId === id);
const middleOf = async (page, id) => {
  const box = await page.locator(`[data-piece="${id}"]`).first().boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

await withStudio(async ({ page, context, restart }) => {
  assert.deepEqual(await seriousFaults(page), [], 'the start page');
  await page.getByLabel('Brief').fill('A bedroom that is 4m x 5m.');
  await page.keyboard.press('Enter');
  await page.locator('[data-piece]').first().waitFor();
  const { document: made, layout } = await shown(page);
  const start = await layoutBytes(page, made.id);
  assert.deepEqual(await seriousFaults(page), [], 'the plan');

  // Drag: verdicts come while the piece is in hand, and it stays just there.
  const wardrobe = layout.graph.objectList.objects.find(({ name }) => name === 'wardrobe').id;
  const from = await middleOf(page, wardrobe);
  const room = await page.locator('svg').filter({ has: page.locator('[data-piece]') }).first().boundingBox();
  const towards = { x: room.x + room.width / 2, y: room.y + room.height / 2 };
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const judged = page.waitForResponse((response) => response.url().endsWith('/Judge'));
  await page.mouse.move(from.x + (towards.x - from.x) / 4, from.y + (towards.y - from.y) / 4, { steps: 6 });
  assert.equal((await judged).status(), 200);
  await page.mouse.up();
  const moved = await until(page, async () => {
    const now = await shown(page);
    return now.document.undoLabel === 'move the wardrobe' && now;
  }, 'the moved wardrobe');
  assert.notDeepEqual(placeOf(moved.layout, wardrobe), placeOf(layout, wardrobe));
  for (const other of layout.placements) {
    const hosted = layout.graph.objectList.objects.find(({ id }) => id === other.objectId).hostId === wardrobe;
    if (other.objectId === wardrobe || hosted) continue;
    assert.deepEqual(placeOf(moved.layout, other.objectId), other, `${other.objectId} stays`);
  }

  // Settle: the others follow, and nothing overlaps. The button says whether anything waits for it.
  const settle = page.getByRole('button', { name: 'Settle', exact: true });
  const isDue = async () => (await settle.getAttribute('class')).includes('is-due');
  await until(page, isDue, 'something to settle');
  await page.keyboard.press('s');
  const settled = await until(page, async () => {
    const now = await shown(page);
    return !now.document.unsettled && now;
  }, 'the settled room');
  assert.deepEqual(placeOf(settled.layout, wardrobe), placeOf(moved.layout, wardrobe));
  assert.ok((settled.layout.metrics.deepestOverlapM ?? 0) < 1e-6);
  await until(page, async () => !(await isDue()), 'nothing to settle');

  // A sentence is added and weighs something.
  await page.getByLabel(/say|sentence|room/i).and(page.locator('input[maxlength="400"]')).first().fill('The wardrobe is in a corner.');
  await page.keyboard.press('Enter');
  const said = await until(page, async () => {
    const now = await shown(page);
    return now.document.undoLabel?.startsWith('say') && now;
  }, 'the sentence');
  const sentence = said.layout.graph.constraintList.sentences.at(-1);
  assert.equal(sentence.text, 'The wardrobe is in a corner.');

  // Its slider is in hand until it is let go, which is one act.
  await page.locator('.sentence-line', { hasText: 'in a corner' }).last().click();
  const { x, y, width, height } = await page.getByLabel(/^How much it matters/).boundingBox();
  const acts = [];
  page.on('request', (request) => { if (request.url().endsWith('/Act')) acts.push(request); });
  await page.mouse.move(x + width * 0.4, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width * 0.8, y + height / 2, { steps: 5 });
  assert.equal(acts.length, 0, 'nothing is sent while it is dragged');
  await page.mouse.up();
  const weighed = await until(page, async () => {
    const now = await shown(page);
    return now.document.undoLabel?.startsWith('weigh') && now;
  }, 'the weighed sentence');
  assert.equal(acts.length, 1);
  assert.ok(weighed.layout.graph.edges.filter(({ sentenceId }) => sentenceId === sentence.id).every(({ weight }) => weight > 2));

  // Reload, and a server that is killed, keep the work.
  await page.reload();
  await page.locator('[data-piece]').first().waitFor();
  const before = await layoutBytes(page, made.id);
  await restart();
  assert.equal(await layoutBytes(page, made.id), before);
  await page.goto(`${new URL(page.url()).origin}/#/room/${made.id}`);
  await page.getByText(made.title).first().click();
  await page.locator('[data-piece]').first().waitFor();

  // Undo to the start gives the same bytes.
  for (let label; (label = (await shown(page)).document.undoLabel);) {
    await page.getByLabel(/^Undo/).first().click();
    await until(page, async () => (await shown(page)).document.undoLabel !== label, `undo of ${label}`);
  }
  assert.equal(await layoutBytes(page, made.id), start);

  // Two pages on one room: who has not seen the latest revision is told so.
  const second = await context.newPage();
  await second.goto(page.url());
  const now = await shown(page);
  await call(second, 'Act', { documentId: made.id, revision: now.document.revision, title: 'Ours' });
  await assert.rejects(call(page, 'Act', { documentId: made.id, revision: now.document.revision, title: 'Mine' }), /aborted/);

  // A page of another origin gets nothing, though the browser has the cookie.
  const foreign = await context.newPage();
  const port = Number(new URL(page.url()).port);
  await foreign.goto(`http://localhost:${port}/`).catch(() => {});
  const stolen = await foreign.evaluate(
    (address) => fetch(address, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: '{}', credentials: 'include' })
      .then((response) => response.status, () => 'refused'),
    `http://127.0.0.1:${port}/flair.v1.StudioService/ListDocuments`,
  );
  assert.ok(stolen === 'refused' || stolen === 403 || stolen === 401, String(stolen));
});
console.log('edited, settled, said, undone; kept through a reload and a kill');
