// SPDX-License-Identifier: GPL-3.0-or-later
// A room of one's own: an L is drawn by clicks and typed lengths, gets a door and a window, and is furnished.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { seriousFaults, shown, until, withStudio } from './studio.mjs';

const corners = (room) => room.floor.vertices.map(({ xM, yM }) => [xM ?? 0, yM ?? 0]);

await withStudio(async ({ page }) => {
  await page.getByText('Draw your own room').click();
  const canvas = page.getByRole('application');
  await canvas.waitFor();
  assert.deepEqual(await seriousFaults(page), [], 'the empty page');
  const box = await canvas.boundingBox();
  const click = async (x, y) => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.up();
  };

  // The first corner is clicked, the first wall's way pointed at, all lengths typed.
  await click(box.x + box.width * 0.25, box.y + box.height * 0.75);
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.74);
  await page.keyboard.type('6');
  await page.keyboard.press('Enter');
  for (const [key, metres] of [['ArrowUp', '3'], ['ArrowLeft', '2.5'], ['ArrowUp', '250 cm'], ['ArrowLeft', '3.5']]) {
    await page.keyboard.press(key);
    await page.keyboard.type(metres);
    await page.keyboard.press('Enter');
  }
  await page.keyboard.press('Enter');
  await page.locator('.room-floor').waitFor();

  // Undo takes one wall's end back at a time, and redo gives it again.
  await page.keyboard.press('Control+z');
  await page.locator('.room-floor').waitFor({ state: 'detached' });
  await page.keyboard.press('Control+Shift+z');
  await page.locator('.room-floor').waitFor();

  // A reload loses nothing that was drawn.
  await page.reload();
  await page.locator('.room-floor').waitFor();
  await canvas.focus();

  // Where it is once the drawing has found its place on the page.
  const steadyBox = async (locator) => {
    let last = '';
    await until(page, async () => {
      const before = last;
      last = JSON.stringify(await locator.boundingBox());
      return last === before;
    }, 'a drawing that stands still');
    return JSON.parse(last);
  };

  // A door in the north wall, a window in the south wall.
  const onWall = async (number, share) => {
    const wall = await steadyBox(page.locator('.room-wall .hit-line').nth(number - 1));
    await click(wall.x + wall.width * share, wall.y + wall.height * share);
  };
  await page.keyboard.press('d');
  await onWall(5, 0.3);
  await page.getByRole('heading', { name: 'Door 1' }).waitFor();
  await page.keyboard.press('w');
  await onWall(1, 0.5);
  await page.getByRole('heading', { name: 'Window 1' }).waitFor();
  // With the tool still in hand a press on it takes it, and puts no other over it.
  await page.keyboard.press('Escape');
  await page.keyboard.press('w');
  await page.getByRole('heading', { name: 'Window 1' }).waitFor({ state: 'detached' });
  await onWall(1, 0.5);
  await page.getByRole('heading', { name: 'Window 1' }).waitFor();
  assert.equal(await page.locator('[data-fixture^="window"]').count(), 1);

  // What cannot be is said, and nothing is sent.
  const done = page.getByRole('button', { name: 'Done' });
  await page.getByLabel('Width', { exact: true }).fill('7');
  await page.keyboard.press('Enter');
  await page.getByText('Window 1 is wider than the south wall').waitFor();
  assert.ok(await done.isDisabled());
  assert.deepEqual(await seriousFaults(page), [], 'the drawing');
  await page.getByLabel('Width', { exact: true }).fill('1.8');
  await page.keyboard.press('Enter');
  await page.getByLabel('From the west end').fill('2');
  await page.keyboard.press('Enter');
  await until(page, () => done.isEnabled(), 'a room without faults');
  await done.click();

  // The empty room, as the renderer draws it.
  const brief = page.getByRole('textbox', { name: 'Furnish it' });
  await brief.waitFor();
  const { layout: empty } = await shown(page);
  const room = empty.graph.room;
  assert.deepEqual(corners(room), [[0, 0], [6, 0], [6, 3], [3.5, 3], [3.5, 5.5], [0, 5.5]]);
  assert.deepEqual(room.walls.map(({ name }) => name), [1, 2, 3, 4, 5, 6].map((number) => `wall_${number}`));
  const [door, window] = room.openings;
  assert.equal(door.wall, 'wall_5');
  assert.deepEqual([window.wall, window.offsetM, window.widthM], ['wall_1', 2, 1.8]);

  await brief.fill('A living room with a sofa, a tv stand, a bookshelf and a dining table for four.');
  await page.keyboard.press('Enter');
  await page.locator('[data-piece]').first().waitFor();
  const { layout } = await shown(page);
  assert.deepEqual(corners(layout.graph.room), corners(room));
  assert.ok(layout.placements.length > 5);
  assert.ok((layout.metrics.deepestOverlapM ?? 0) < 1e-6, 'nothing overlaps');

  // Other layouts of it, the sofa where it is; what is taken is undone as one act.
  const sofaId = layout.graph.objectList.objects.find(({ name }) => name === 'sofa').id;
  const at = (from) => from.placements.find(({ objectId }) => objectId === sofaId);
  await page.getByRole('button', { name: /^Sofa/ }).click();
  await page.keyboard.press('l');
  await until(page, async () => (await shown(page)).layout.graph.pinnedPlacements?.length === 1, 'the lock');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Other layouts' }).click();
  await page.getByRole('button', { name: /^Variant 2/ }).click();
  const taken = await until(page, async () => {
    const now = await shown(page);
    return now.document.undoLabel === 'take variant 2' && now;
  }, 'the variant');
  assert.deepEqual(at(taken.layout), at(layout));
  assert.notDeepEqual(taken.layout.placements, layout.placements);
  assert.equal(taken.layout.graph.pinnedPlacements.length, 1);
  assert.deepEqual(await seriousFaults(page), [], 'the variants');
  await page.keyboard.press('Control+z');
  await until(page, async () => (await shown(page)).document.layoutId !== taken.document.layoutId, 'the undo');
  const before = await shown(page);
  assert.deepEqual(before.layout.placements, layout.placements);

  // A search that is given up finds nothing, whatever the server comes to.
  let isAsked = false;
  await page.route('**/FindVariants', () => { isAsked = true; });
  await page.getByRole('button', { name: 'Search others' }).click();
  await page.getByText('Searching for other layouts').waitFor();
  await until(page, async () => isAsked, 'the question');
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.getByText('Searching for other layouts').waitFor({ state: 'detached' });
  await page.unroute('**/FindVariants');

  // The brief is changed and run again within the same walls; undo gives back the layout and the brief.
  await page.getByRole('button', { name: 'Furnish again' }).click();
  const again = page.getByRole('textbox', { name: 'What shall it hold?' });
  assert.match(await again.inputValue(), /^A living room with a sofa/);
  await again.fill('A study with a desk and a bookshelf.');
  await page.keyboard.press('Enter');
  await page.getByText('Furnished anew').waitFor();
  const study = await shown(page);
  assert.equal(study.document.brief.text, 'A study with a desk and a bookshelf.');
  assert.deepEqual(corners(study.layout.graph.room), corners(room));
  assert.ok(study.layout.graph.objectList.objects.some(({ name }) => name === 'desk'));
  await page.getByRole('button', { name: 'Back to what was before' }).click();
  await until(page, async () => (await shown(page)).document.layoutId === before.document.layoutId, 'what was before');
  assert.match((await shown(page)).document.brief.text, /^A living room/);

  // The west wall goes 40 cm out: furniture stays where it is in the room, also as its origin moves.
  const sofa = layout.graph.objectList.objects.find(({ name }) => name === 'sofa').id;
  const placeOf = (from) => from.placements.find(({ objectId }) => objectId === sofa);
  await page.getByRole('button', { name: 'Edit room' }).click();
  await page.getByRole('button', { name: /^West wall/ }).click();
  for (let i = 0; i < 4; ++i) await page.keyboard.press('Shift+ArrowLeft');
  await page.getByRole('button', { name: 'Done' }).click();
  await page.locator('[data-piece]').first().waitFor();
  const wider = await until(page, async () => {
    const now = await shown(page);
    return corners(now.layout.graph.room)[1][0] === 6.4 && placeOf(now.layout).xM !== placeOf(layout).xM && now;
  }, 'the wider room');
  assert.ok(Math.abs(placeOf(wider.layout).xM - placeOf(layout).xM - 0.4) < 1e-6);

  // Its picture can be printed: the longer side of the paper at 200 dots an inch.
  for (const [paper, side_mm] of [['A4', 297], ['A3', 420]]) {
    await page.getByRole('button', { name: 'Export' }).click();
    await page.getByRole('menuitemradio', { name: paper }).click();
    const saved = page.waitForEvent('download');
    await page.getByRole('menuitem', { name: 'Plan as a picture' }).click();
    const png = readFileSync(await (await saved).path());
    const sides = [png.readUInt32BE(16), png.readUInt32BE(20)];
    assert.ok(Math.abs(Math.max(...sides) - (side_mm / 25.4) * 200) < 2, `${paper}: ${sides}`);
  }
});
console.log('drawn, furnished, changed');
