// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { corrected } from "./still";

test("what goes down is followed by scrolling, with room made below where that is not enough", () => {
  assert.deepEqual(corrected(18, { top: 10, most: 100 }), { top: 28, above: 0, below: 0 });
  assert.deepEqual(corrected(18, { top: 0, most: 0 }), { top: 18, above: 0, below: 18 });
  assert.deepEqual(corrected(18, { top: 0, most: -200 }), { top: 18, above: 0, below: 218 });
});

test("what goes up is followed as far as there is something above, else room is made there", () => {
  assert.deepEqual(corrected(-18, { top: 30, most: 100 }), { top: 12, above: 0, below: 0 });
  assert.deepEqual(corrected(-18, { top: 8, most: 100 }), { top: 0, above: 10, below: 0 });
});
