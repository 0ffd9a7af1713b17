// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms of one's own, drawn.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { StudioPage } from "./studio_page.mjs";

let studio;
before(async () => {
  studio = await StudioPage.open();
  await studio.page.click("text=Draw your own room");
  await studio.page.waitForSelector(".rectangle");
});
after(() => studio.close());

const intoWall = async (thing) => {
  const { page } = studio;
  await page.locator(".room-panel .piece-row", { hasText: "north wall" }).first().click();
  await page.locator(".panel-buttons button", { hasText: thing }).click();
  await page.waitForSelector(`.panel-head h2:has-text('${thing}')`);
};

test("the kind of room is asked for before its walls are drawn", async () => {
  const { page } = studio;
  await page.selectOption(".room-panel select", "bedroom");
  await page.click(".rectangle >> text=Make");
  await page.waitForSelector(".panel-head h2:has-text('Your own room')");
  assert.equal(await page.locator(".room-panel select").inputValue(), "bedroom");
});

test("tab takes what was typed and goes to the next field", async () => {
  const { page } = studio;
  await intoWall("Window");
  await page.locator(".field:has-text('Width') input").click();
  await page.keyboard.type("1.6");
  await page.keyboard.press("Tab");
  await page.keyboard.type("0.4");
  await page.keyboard.press("Tab");
  assert.equal(await studio.field("Width"), "1.60");
  assert.equal(await studio.field("Sill"), "0.40");
  await page.locator(".field:has-text('Width') input").click();
  await page.keyboard.type("1.6");
  await page.keyboard.press("Tab");
  assert.equal(await studio.field("Width"), "1.60");
});

test("what is removed is offered back", async () => {
  const { page } = studio;
  const close = await page.locator(".panel-head .is-close").boundingBox();
  const remove = await page.locator(".is-remove").boundingBox();
  assert.ok(remove.x + remove.width < close.x - 20 && remove.y > close.y + close.height - 4);
  await page.click(".is-remove");
  await page.waitForSelector(".message:has-text('is removed.')");
  assert.equal(await page.locator(".room-fixture").count(), 0);
  await page.click(".message >> text=Put it back");
  await page.waitForFunction(() => document.querySelectorAll(".room-fixture").length === 1);
});

test("nothing went wrong in the page", () => assert.deepEqual(studio.faults, []));
