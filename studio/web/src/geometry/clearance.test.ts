// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { clearances, measuredAlong, withClearance, type Obstacle } from "./clearance";
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

test("a turned piece is measured from its outermost corners, square to the room", () => {
  // Half of its diagonal is 0.5 m.
  const pose = { x: 2, y: 2, theta: Math.PI / 4 }, size = { width: Math.SQRT1_2, depth: Math.SQRT1_2 };
  const all = clearances(pose, size, floor, []);
  assert.deepEqual(all.map(({ side }) => side), ["north", "west", "south", "east"]);
  const north = all[0]!, west = all[1]!;
  assert.ok(Math.abs(north.metres - 2.5) < 1e-9 && Math.abs(west.metres - 1.5) < 1e-9);
  assert.ok(Math.abs(north.from.y - 2.5) < 1e-9 && Math.abs(north.to.x - north.from.x) < 1e-9);
});

test("a number that is typed for a turned piece is what is then measured", () => {
  const pose = { x: 2, y: 2, theta: 0.4 };
  const desk = { id: "desk", polygon: corners({ x: 1.2, y: 4, theta: 0 }, { width: 1, depth: 0.6 }) };
  const before = clearances(pose, bed, floor, [desk]);
  const north = before.find(({ side }) => side === "north")!;
  assert.equal(north.target, "desk");
  const after = clearances(withClearance(pose, north, 0.3), bed, floor, [desk]);
  assert.ok(Math.abs(after.find(({ side }) => side === "north")!.metres - 0.3) < 1e-9);
  // What is met is aside of the corner that it is measured from.
  assert.ok(north.met.x < north.to.x - 0.1 && Math.abs(north.met.y - 3.7) < 1e-6);
});

test("a piece along an oblique wall is measured along its own sides", () => {
  const turnedFloor = corners({ x: 0, y: 0, theta: 0.4 }, { width: 4, depth: 5 });
  assert.equal(measuredAlong(0.4 + Math.PI / 2, turnedFloor), 0.4 + Math.PI / 2);
  assert.ok(Math.abs(measuredAlong(0, turnedFloor) - 0.4) < 1e-9);
});
