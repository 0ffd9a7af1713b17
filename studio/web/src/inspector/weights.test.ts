// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { kLeast, kMost, placeOf, weightAt, weightWords } from "./weights";

test("a place on the slider and its weight lead to each other", () => {
  for (const weight of [0.1, 0.5, 1, 2, 31]) assert.equal(weightAt(placeOf(weight)), weight);
  assert.equal(placeOf(100), kMost);
  assert.equal(placeOf(0.01), kLeast);
});

test("weights read as how much a wish matters", () => {
  assert.deepEqual([0.1, 0.5, 1, 3, 10, 30].map(weightWords),
    ["hardly", "less", "as usual", "more", "much", "above all"]);
});
