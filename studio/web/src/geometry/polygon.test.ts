// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { area, clipped, inside } from "./polygon";
import { vec } from "./vec";

const square = (x: number, y: number, side: number) =>
  [vec(x, y), vec(x + side, y), vec(x + side, y + side), vec(x, y + side)];

test("two squares share what both cover", () => {
  assert.ok(Math.abs(area(clipped(square(0, 0, 2), square(1, 1, 2))) - 1) < 1e-9);
});

test("what does not meet shares nothing", () => {
  assert.deepEqual(clipped(square(0, 0, 1), square(2, 2, 1)), []);
});

test("the notch of an L is outside", () => {
  const floor = [vec(0, 0), vec(4, 0), vec(4, 2), vec(2, 2), vec(2, 4), vec(0, 4)];
  assert.ok(inside(floor, vec(1, 3)));
  assert.ok(!inside(floor, vec(3, 3)));
});
