// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { StudioPage } from "./studio_page.mjs";

for (const theme of ["light", "dark"]) {
  test(`axe-core finds nothing serious, ${theme}`, async () => {
    const studio = await StudioPage.open({ theme });
    try {
      const { page } = studio;
      assert.deepEqual(await studio.seriousFaults(), [], "start page");
      await studio.design("A bedroom that is 4m x 5m.");
      assert.deepEqual(await studio.seriousFaults(), [], "room");
      await studio.select("double_bed");
      await page.locator(".sentence-line").first().click();
      await page.keyboard.press("f");
      await page.waitForSelector(".offer");
      assert.deepEqual(await studio.seriousFaults(), [], "piece and furniture");
      await page.click("[aria-label=Export]");
      await page.waitForSelector("[role=menu]");
      assert.deepEqual(await studio.seriousFaults(), [], "menu");
      await page.keyboard.press("Escape");
      await page.keyboard.press("?");
      await page.waitForSelector("dialog[open]");
      assert.deepEqual(await studio.seriousFaults(), [], "keys");
    } finally {
      await studio.close();
    }
  });
}
