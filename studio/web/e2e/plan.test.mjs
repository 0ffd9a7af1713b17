// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { StudioPage } from "./studio_page.mjs";

let studio;
before(async () => {
  studio = await StudioPage.open();
  await studio.design("A bedroom that is 4m x 5m.");
});
after(() => studio.close());

test("a brief becomes a plan with nothing to undo", async () => {
  assert.equal(await studio.undoLabel(), "Undo: nothing");
  assert.ok(await studio.page.locator(".piece").count() > 8);
});

test("a piece that is dragged is judged on its way, and stays there as one act", async () => {
  const { page } = studio;
  const before = await studio.box("wardrobe");
  await studio.drag("wardrobe", 120, 150, () => page.waitForSelector(".sentence.is-live.is-missed"));
  await page.waitForSelector("[aria-label^='Undo: move']");
  const after = await studio.box("wardrobe");
  assert.ok(after.y - before.y > 100);
  assert.equal(await page.locator(".sentence.is-live").count(), 0);
  assert.ok(await page.locator(".sentence.is-missed").count() > 0);
});

test("undo puts it back, redo does it again", async () => {
  const { page } = studio;
  const moved = await studio.box("wardrobe");
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label='Undo: nothing']");
  const back = await studio.box("wardrobe");
  assert.ok(moved.y - back.y > 100);
  await page.keyboard.press("Control+Shift+z");
  await page.waitForSelector("[aria-label^='Undo: move']");
  assert.ok(Math.abs((await studio.box("wardrobe")).y - moved.y) < 0.5);
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label='Undo: nothing']");
});

test("a press beside a piece is not on it", async () => {
  const { page } = studio;
  await studio.select("wardrobe");
  const { x, y, width, height } = await studio.box("wardrobe");
  await page.mouse.click(x + width + 14, y + height / 2);
  assert.equal(await page.locator(".piece-name").count(), 0);
});

test("a marquee selects what it touches", async () => {
  const { page } = studio;
  const { x, y, width, height } = await studio.box("wardrobe");
  await page.mouse.move(x + width + 40, y + height + 40);
  await page.mouse.down();
  await page.mouse.move(x + width - 20, y + height - 10, { steps: 4 });
  await page.mouse.up();
  assert.equal(await page.locator(".piece-name input").inputValue(), "Wardrobe");
  await page.keyboard.press("Escape");
});

test("escape ends a drag as if it had not begun", async () => {
  const before = await studio.box("wardrobe");
  await studio.drag("wardrobe", 90, 90, () => studio.page.keyboard.press("Escape"));
  assert.deepEqual(await studio.box("wardrobe"), before);
  assert.equal(await studio.undoLabel(), "Undo: nothing");
});

test("a typed distance moves the piece so that it has it", async () => {
  const { page } = studio;
  await studio.select("wardrobe");
  await page.locator(".figure").first().click();
  await page.locator(".clearance-field").fill("0.9");
  await page.keyboard.press("Enter");
  await page.waitForSelector("[aria-label^='Undo: move']");
  assert.equal(await page.locator(".figure text", { hasText: /^0\.90$/ }).count(), 1);
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label='Undo: nothing']");
});

test("arrows go one centimetre, with shift ten, and held keys are one act", async () => {
  const { page } = studio;
  await studio.select("double_bed");
  const before = Number(await studio.field("To south wall"));
  await page.keyboard.down("ArrowUp");
  await page.keyboard.down("ArrowUp");
  await page.keyboard.up("ArrowUp");
  await page.waitForSelector("[aria-label^='Undo: move']");
  assert.ok(Math.abs(Number(await studio.field("To south wall")) - before - 0.02) < 0.006);
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label='Undo: nothing']");
});

test("R turns by 90 degrees clockwise", async () => {
  const { page } = studio;
  await studio.select("double_bed");
  assert.equal(await studio.field("Faces"), "W");
  await page.keyboard.press("r");
  await page.waitForSelector("[aria-label^='Undo: ']:not([aria-label='Undo: nothing'])");
  assert.equal(await studio.field("Faces"), "N");
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label='Undo: nothing']");
});

test("a piece is duplicated, locked and removed by keys", async () => {
  const { page } = studio;
  const count = await page.locator(".piece").count();
  await studio.select("wardrobe");
  await page.keyboard.press("Control+d");
  await page.waitForFunction((n) => document.querySelectorAll(".piece").length === n + 1, count);
  await page.waitForSelector(".outline.is-selected");
  await page.keyboard.press("l");
  await page.waitForSelector(".outline.is-locked");
  // What is locked stays.
  await page.keyboard.press("Delete");
  await page.waitForSelector(".message");
  await page.keyboard.press("l");
  await page.waitForSelector(".outline.is-locked", { state: "detached" });
  await page.keyboard.press("Delete");
  await page.waitForFunction((n) => document.querySelectorAll(".piece").length === n, count);
});

test("settling is one act", async () => {
  const { page } = studio;
  await studio.drag("double_bed", -60, 20);
  await page.waitForSelector("[aria-label^='Undo: move']");
  await page.keyboard.press("s");
  await page.waitForSelector("[aria-label='Undo: settle']");
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[aria-label^='Undo: move']");
  await page.keyboard.press("Control+z");
});

test("furniture is found and added", async () => {
  const { page } = studio;
  await page.keyboard.press("f");
  await page.fill(".search input", "armchair");
  await page.waitForFunction(() => document.querySelector(".offer-name")?.textContent === "armchair");
  await page.locator(".offer > button").first().click();
  await page.waitForFunction(() => document.querySelector(".piece-name input")?.value.startsWith("Armchair"));
  await page.keyboard.press("Delete");
  await page.waitForSelector(".piece-name", { state: "detached" });
});

test("a click takes what is on top, the next on the same spot what carries it; its name is seen before", async () => {
  const { page } = studio;
  const { x, y, width, height } = await studio.box("desk_lamp");
  const name = () => page.locator(".piece-name input").inputValue();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.waitForSelector("text.is-pointed:has-text('desk lamp, on the desk')");
  await page.mouse.click(x + width / 2, y + height / 2);
  await page.waitForSelector(".piece-name");
  assert.equal(await name(), "Desk lamp");
  await page.mouse.click(x + width / 2, y + height / 2);
  await page.waitForFunction(() => document.querySelector(".piece-name input")?.value === "Desk");
  await page.click("[aria-label='Back to the room']");
  await page.waitForSelector(".piece-name", { state: "detached" });
});

test("who presses what stands on the desk and drags moves the desk", async () => {
  const { page } = studio;
  const before = await studio.box("desk"), last = await studio.undoLabel();
  await studio.drag("desk_lamp", 60, 40);
  await page.waitForSelector("[aria-label^='Undo: move']");
  assert.equal(await page.locator(".piece-name input").inputValue(), "Desk");
  assert.ok((await studio.box("desk")).x - before.x > 20);
  await page.keyboard.press("Control+z");
  await page.waitForSelector(`[aria-label='${last}']`);
  await page.keyboard.press("Escape");
});

test("every panel is closed at the same place, and removing is elsewhere and offers the piece back", async () => {
  const { page } = studio;
  const count = await page.locator(".piece").count();
  await studio.select("wardrobe");
  const close = await page.locator(".panel-head .is-close").boundingBox();
  const remove = await page.locator(".is-remove").boundingBox();
  assert.ok(remove.x + remove.width < close.x - 20 && remove.y > close.y + close.height - 4);
  await page.keyboard.press("Control+a");
  await page.waitForSelector(".panel-head h2:has-text('pieces')");
  assert.deepEqual(await page.locator(".panel-head .is-close").boundingBox(), close);
  await page.click(".panel-head .is-close");
  await studio.select("wardrobe");
  await page.click(".is-remove");
  await page.waitForSelector(".message:has-text('The wardrobe is removed.')");
  await page.click(".message >> text=Put it back");
  await page.waitForFunction((n) => document.querySelectorAll(".piece").length === n, count);
  await page.waitForSelector(".message:has-text('Undone')");
  assert.equal(await page.locator(".message >> text=Put it back").count(), 0);
});

test("wishes are counted alike wherever they are", async () => {
  const { page } = studio;
  const shown = async (of) => (await page.locator(of).first().innerText()).match(/\d+/g).map(Number);
  const [held, all] = await shown(".measure dd");
  assert.deepEqual(await shown(".wish-choice button:nth-child(2)"), [held]);
  assert.deepEqual(await shown(".wish-choice button:nth-child(3)"), [all]);
  await page.click(".wish-choice button:nth-child(3)");
  assert.equal(await page.locator(".sentences > li").count(), all);
  await page.click(".wish-choice button:nth-child(1)");
});

test("what was told before is listed by a click", async () => {
  const { page } = studio;
  const last = await studio.undoLabel();
  await studio.select("wardrobe");
  await page.keyboard.press("l");
  await page.waitForSelector(".outline.is-locked");
  await page.keyboard.press("Delete");
  await page.waitForSelector(".message.is-warning:has-text('The wardrobe is locked.')");
  await page.click(".message .is-quiet");
  assert.ok(await page.locator(".message-list .message").count() > 1);
  await page.keyboard.press("Escape");
  await page.waitForSelector(".message-list", { state: "detached" });
  await page.click(".message >> text=Unlock");
  await page.waitForSelector(".outline.is-locked", { state: "detached" });
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await page.waitForSelector(`[aria-label='${last}']`);
});

test("pieces are brought into line as one act", async () => {
  const { page } = studio;
  const last = await studio.undoLabel();
  await studio.select("wardrobe");
  const { x, y } = await studio.box("dresser");
  await page.keyboard.down("Shift");
  await page.mouse.click(x + 4, y + 4);
  await page.keyboard.up("Shift");
  await page.waitForSelector(".panel-head h2:has-text('2 pieces')");
  await page.click("[aria-label='Align the eastern sides']");
  await page.waitForSelector(`[aria-label^='Undo: ']:not([aria-label='${last}'])`);
  const [one, two] = [await studio.box("wardrobe"), await studio.box("dresser")];
  assert.ok(Math.abs(one.x + one.width - two.x - two.width) < 1);
  await page.keyboard.press("Control+z");
  await page.waitForSelector(`[aria-label='${last}']`);
  await page.keyboard.press("Escape");
});

test("the paper is chosen once", async () => {
  const { page } = studio;
  for (const paper of ["A3", "A4"]) {
    await page.click("[aria-label=Export]");
    await page.click(`.menu-choice >> text=${paper}`);
    await page.keyboard.press("Escape");
    await page.click("[aria-label=Export]");
    assert.equal(await page.locator(".menu-choice [aria-checked=true]").innerText(), paper);
    assert.equal(await page.evaluate(() => localStorage.getItem("flair.paper")), paper);
    await page.keyboard.press("Escape");
  }
});

test("a reload shows the same room", async () => {
  if (!process.env.FLAIR_STUDIO_URL) return;
  await studio.page.reload();
  await studio.page.waitForSelector(".piece");
});

test("nothing went wrong in the page", () => assert.deepEqual(studio.faults, []));
