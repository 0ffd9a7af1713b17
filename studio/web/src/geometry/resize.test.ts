// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { toRoom } from "./footprint";
import { pulled } from "./resize";
import { vec } from "./vec";

const size = { width: 1, depth: 0.6 };

test("pulling the right side leaves the left one where it was", () => {
  const { pose, size: grown } = pulled({ x: 2, y: 2, theta: 0 }, size, { x: 1, y: 0 }, vec(2.8, 2.4), 0.01);
  assert.ok(Math.abs(grown.width - 1.3) < 1e-9);
  assert.equal(grown.depth, 0.6);
  assert.ok(Math.abs(pose.x - grown.width / 2 - 1.5) < 1e-9);
});

test("a turned piece is pulled along its own sides", () => {
  const before = { x: 2, y: 2, theta: Math.PI / 2 };
  // Its front faces west.
  const { pose, size: grown } = pulled(before, size, { x: 0, y: 1 }, vec(1.4, 2), 0.01);
  assert.ok(Math.abs(grown.depth - 0.9) < 1e-9);
  const back = toRoom(pose, vec(0, -grown.depth / 2));
  assert.ok(Math.abs(back.x - 2.3) < 1e-9 && Math.abs(back.y - 2) < 1e-9);
});

test("nothing becomes smaller than a hand", () => {
  const { size: least } = pulled({ x: 0, y: 0, theta: 0 }, size, { x: 1, y: 1 }, vec(-3, -3), 0.01);
  assert.deepEqual(least, { width: 0.05, depth: 0.05 });
});
