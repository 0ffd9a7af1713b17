// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { newFixture, placed } from "./fixtures";
import { emptySketch, rectangle, wallsOf, type Door } from "./sketch";

const sketch = rectangle(4, 3, emptySketch), wall = wallsOf(sketch)[0]!;
const put = (door: Door, offset: number, from = wall) => placed(door, from, wall, offset) as Door;
const newAt = (offset: number) => placed(newFixture(sketch, "door", "", 0), undefined, wall, offset) as Door;

test("a new door opens against the nearer end of its wall", () => {
  assert.deepEqual([newAt(0.1).wall, newAt(0.1).offset, newAt(0.1).hinge], [wall.key, 0.1, "start"]);
  assert.equal(newAt(wall.length - 1).hinge, "end");
});

test("it does so wherever it is moved to, unless it was hung otherwise", () => {
  const middle = newAt((wall.length - 0.9) / 2);
  assert.equal(put(middle, wall.length - 1).hinge, "end");
  assert.equal(put(put(middle, wall.length - 1), 0.1).hinge, "start");
  assert.equal(put({ ...newAt(0.1), hinge: "end" }, 0.4).hinge, "end");
});
