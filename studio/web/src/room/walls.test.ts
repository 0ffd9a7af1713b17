// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { area } from "../geometry/polygon";
import { add, times } from "../geometry/vec";
import { newFixture, settledOffset, withEndAt, withFixture } from "./fixtures";
import { counterClockwise, rectangle, wallsOf, type Sketch } from "./sketch";
import { tidied, withCornerOn, withoutCorner, withWallLength, withWallMoved } from "./walls";

const room = rectangle(4, 3);
const shape = (sketch: Sketch) => sketch.corners.map(({ x, y }) => [x, y]);
const door = { ...newFixture(room, "door", "w3", 1), width: 0.9 };

function placeOf(sketch: Sketch, id: string) {
  const fixture = sketch.fixtures.find((one) => one.id === id)!;
  const wall = wallsOf(sketch).find(({ key }) => key === fixture.wall)!;
  const { x, y } = add(wall.a, times(wall.along, fixture.offset));
  return [Math.round(x * 1e4) / 1e4, Math.round(y * 1e4) / 1e4];
}

test("a wall that is moved takes its neighbours along", () => {
  assert.deepEqual(shape(withWallMoved(room, 0, -0.5)), [
    [0, -0.5],
    [4, -0.5],
    [4, 3],
    [0, 3],
  ]);
});

test("the half of a wall, moved, makes an L", () => {
  const halved = withCornerOn(room, 2, 1.5);
  assert.equal(halved.corners.length, 5);
  const l = withWallMoved(halved, 3, 1);
  assert.deepEqual(shape(l), [
    [0, 0],
    [4, 0],
    [4, 3],
    [2.5, 3],
    [2.5, 2],
    [0, 2],
  ]);
  assert.equal(area(l.corners), 9.5);
  assert.deepEqual(shape(tidied(withWallMoved(l, 4, -1))).length, 5, "moved back, the step is gone");
});

test("a door stays where it is when the wall grows at its start", () => {
  const withDoor = withFixture(room, door);
  const before = placeOf(withDoor, door.id);
  // Wall w3 runs west; its start is on the east wall.
  const wider = withWallMoved(withDoor, 1, -1);
  assert.equal(wallsOf(wider)[2]!.length, 5);
  assert.deepEqual(placeOf(wider, door.id), before);
});

test("a typed length moves the wall after it", () => {
  assert.deepEqual(shape(withWallLength(room, 0, 5.2)), [
    [0, 0],
    [5.2, 0],
    [5.2, 3],
    [0, 3],
  ]);
});

test("a slanted wall keeps its end corner only", () => {
  const slanted: Sketch = { ...room, corners: room.corners.map((c, i) => (i === 2 ? { ...c, x: 3 } : c)) };
  assert.deepEqual(shape(withWallLength(slanted, 0, 5)), [
    [0, 0],
    [5, 0],
    [3, 3],
    [0, 3],
  ]);
});

test("a corner that goes leaves its wall's door in the other wall", () => {
  const halved = withCornerOn(withFixture(room, door), 2, 0.5);
  assert.notEqual(halved.fixtures[0]!.wall, "w3");
  const before = placeOf(halved, door.id);
  const back = withoutCorner(halved, 3);
  assert.equal(back.corners.length, 4);
  assert.deepEqual(placeOf(back, door.id), before);
});

test("a room that was drawn clockwise is turned round, doors and all", () => {
  const corners = [...room.corners].reverse();
  const wall = wallsOf({ ...room, corners })[0]!;
  const sketch: Sketch = { ...room, corners, fixtures: [{ ...door, wall: wall.key, offset: 0.5 }] };
  const before = placeOf(sketch, door.id),
    turned = counterClockwise(sketch);
  assert.ok(area(turned.corners) > 0);
  const [fixture] = turned.fixtures;
  assert.equal(fixture!.kind === "door" && fixture!.hinge, "end");
  const host = wallsOf(turned).find(({ key }) => key === fixture!.wall)!;
  const end = add(host.a, times(host.along, fixture!.offset + 0.9));
  assert.deepEqual([end.x, end.y], before);
});

test("something put on a wall stays within it and stops at its ends and middle", () => {
  assert.equal(settledOffset(0.2, 0.9, 4, 0.1, 0.05), 0);
  assert.equal(settledOffset(2.03, 1, 4, 0.1, 0.05), 1.5);
  assert.equal(settledOffset(9, 0.9, 4, 0.1, 0.05), 3.1);
  assert.equal(settledOffset(1.33, 0.9, 4, 0.1, 0.05), 0.9);
});

test("an end that is pulled leaves the other one", () => {
  const pulled = withEndAt(door, "start", 0.4, 4);
  assert.deepEqual([pulled.offset, pulled.kind === "door" && pulled.width], [0.4, 1.5]);
});
