// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { vec } from "../geometry/vec";
import { penAt, segmentsMeet } from "./pen";

const options = { within: 0.1, isFree: false, step: 0.05 };

test("walls go at right angles, in steps of 5 cm", () => {
  assert.deepEqual(penAt([vec(0, 0)], vec(3.22, 0.4), options).at, vec(3.2, 0));
});

test("alt frees the corner", () => {
  assert.deepEqual(penAt([vec(0, 0)], vec(3.22, 0.4), { ...options, isFree: true }).at, vec(3.22, 0.4));
});

test("a wall stops in line with an earlier corner", () => {
  const { at, inLine } = penAt([vec(0.123, 0), vec(3, 0), vec(3, 2)], vec(0.16, 2.1), options);
  assert.deepEqual(at, vec(0.123, 2));
  assert.deepEqual(inLine, [vec(0.123, 0)]);
});

test("the first corner closes once there are three", () => {
  assert.ok(!penAt([vec(0, 0), vec(3, 0)], vec(0.05, 0), options).closes);
  assert.ok(penAt([vec(0, 0), vec(3, 0), vec(3, 2)], vec(0.05, 0.05), options).closes);
});

test("after a slanted wall the pen goes along and across it", () => {
  const { at } = penAt([vec(0, 0), vec(1, 1)], vec(0.1, 2.05), options);
  assert.ok(Math.abs(at.x + at.y - 2) < 1e-3);
});

test("segments that cross or touch meet", () => {
  assert.ok(segmentsMeet(vec(0, 0), vec(2, 2), vec(0, 2), vec(2, 0)));
  assert.ok(segmentsMeet(vec(0, 0), vec(2, 0), vec(1, 0), vec(1, 2)));
  assert.ok(!segmentsMeet(vec(0, 0), vec(2, 0), vec(3, 0), vec(5, 0)));
  assert.ok(!segmentsMeet(vec(0, 0), vec(2, 0), vec(0, 1), vec(2, 1)));
});
