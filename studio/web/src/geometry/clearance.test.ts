// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { clearances, withClearance, type Obstacle } from "./clearance";
import { corners, type Side } from "./footprint";
import { vec } from "./vec";

const floor = [vec(0, 0), vec(4, 0), vec(4, 5), vec(0, 5)];
const bed = { width: 1.5, depth: 2 };
const at = { x: 2, y: 1, theta: 0 };

function of(side: Side, pieces: Obstacle[] = [], pose = at) {
  return clearances(pose, bed, floor, pieces).find((one) => one.side === side)!;
}

test("an empty room is measured to its walls", () => {
  assert.ok(Math.abs(of("front").metres - 3) < 1e-9);
  assert.ok(Math.abs(of("back").metres) < 1e-9);
  assert.ok(Math.abs(of("left").metres - 1.25) < 1e-9);
  assert.equal(of("left").target, "");
});

test("a piece before the wall is nearer", () => {
  const desk = { id: "desk", polygon: corners({ x: 2.5, y: 4, theta: 0.3 }, { width: 1, depth: 0.6 }) };
  assert.equal(of("front", [desk]).target, "desk");
  assert.ok(of("front", [desk]).metres < 3);
});

test("what only touches the strip beside a piece is not before it", () => {
  const nightstand = { id: "n", polygon: corners({ x: 3, y: 3, theta: 0 }, { width: 0.5, depth: 0.4 }) };
  assert.equal(of("front", [nightstand]).target, "");
});

test("a typed clearance moves the piece along that side", () => {
  const pose = withClearance(at, of("front"), 0.9);
  assert.ok(Math.abs(pose.y - 3.1) < 1e-9);
  assert.ok(Math.abs(of("front", [], pose).metres - 0.9) < 1e-9);
});

test("a piece through a wall has no clearance there", () => {
  assert.equal(of("back", [], { x: 2, y: 0.9, theta: 0 }).metres, 0);
});
