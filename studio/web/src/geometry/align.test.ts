// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { aligned, spread } from "./align";
import { vec } from "./vec";

const box = (x: number, width: number, y = 0) => ({ min: vec(x, y), max: vec(x + width, y + 1) });
const xs = (by: Array<{ x: number; y: number }>) => by.map(({ x }) => Math.round(x * 100) / 100);

test("boxes are brought into line at a side or at their middles", () => {
  const boxes = [box(0, 1), box(2, 2)];
  assert.deepEqual(xs(aligned(boxes, "x", "min")), [0, -2]);
  assert.deepEqual(xs(aligned(boxes, "x", "max")), [3, 0]);
  assert.deepEqual(xs(aligned(boxes, "x", "middle")), [1.5, -1]);
  assert.deepEqual(aligned([box(0, 1, 3), box(0, 1, 1)], "y", "min").map(({ y }) => y), [-2, 0]);
});

test("gaps become equal, whatever the order and the sizes, and the outer ones stay", () => {
  assert.deepEqual(xs(spread([box(8, 2), box(0, 1), box(2, 3)], "x")), [0, 0, 1]);
});
