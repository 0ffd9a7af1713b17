// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { DoorSwing, HingeSide, RoomSchema } from "../gen/flair/v1/room_pb";
import { newFixture, withFixture } from "./fixtures";
import { begun, pushed, redone, undone } from "./history";
import { wallNamesOf } from "./names";
import { placed, scaled } from "./picture";
import { problemsOf } from "./problems";
import { rectangle, type Sketch } from "./sketch";
import { roomOf, sketchOf } from "./to_room";
import { withCornerOn, withWallMoved } from "./walls";

const rect = rectangle(4, 3);
const texts = (sketch: Sketch) => problemsOf(sketch, "m").map(({ text }) => text);

test("the walls of a rectangle are called by compass, others by number", () => {
  assert.deepEqual([...wallNamesOf(rect).values()], ["south", "east", "north", "west"]);
  const l = withWallMoved(withCornerOn(rect, 2, 1.5), 3, 1);
  assert.deepEqual([...wallNamesOf(l).values()], ["wall_1", "wall_2", "wall_3", "wall_4", "wall_5", "wall_6"]);
});

test("the room begins at the origin, counter-clockwise, its door as it was drawn", () => {
  const moved: Sketch = { ...rect, corners: rect.corners.map((c) => ({ ...c, x: c.x - 1.5, y: c.y + 2 })) };
  const door = { ...newFixture(moved, "door", "w4", 0.4), hinge: "end", swing: "outward" } as const;
  const { room, shift } = roomOf(withFixture(moved, door as never), "My room");
  assert.deepEqual(
    room.floor!.vertices!.map((v) => [v.xM, v.yM]),
    [
      [0, 0],
      [4, 0],
      [4, 3],
      [0, 3],
    ],
  );
  assert.deepEqual(shift, { x: 1.5, y: -2 });
  const [opening] = room.openings!;
  assert.equal(opening!.wall, "west");
  assert.equal(opening!.leaf!.swing, DoorSwing.OUTWARD);
  assert.equal(opening!.leaf!.hinge, HingeSide.END);
});

test("a room that is edited keeps its names, ids and remarks", () => {
  const before = create(RoomSchema, {
    roomType: "study",
    title: "A study",
    heightM: 2.5,
    floor: {
      vertices: [
        { xM: 0, yM: 0 },
        { xM: 4, yM: 0 },
        { xM: 4, yM: 3 },
        { xM: 0, yM: 3 },
      ],
    },
    walls: ["garden", "street", "stairs", "yard"].map((name) => ({ name })),
    sockets: [{ id: "socket_7", wall: "stairs", offsetM: 0.5, heightM: 0.3 }],
    diagnostics: [{ message: "the ceiling was assumed" }],
  });
  const { room } = roomOf(withCornerOn(sketchOf(before), 0, 2), before.title, before);
  assert.deepEqual(
    room.walls!.map((wall) => wall.name),
    ["garden", "wall_2", "street", "stairs", "yard"],
  );
  assert.equal(room.sockets![0]!.id, "socket_7");
  assert.equal(room.diagnostics!.length, 1);
});

test("what the server would refuse is said before", () => {
  assert.deepEqual(texts(rect), []);
  const crossed: Sketch = {
    ...rect,
    corners: [rect.corners[0]!, rect.corners[2]!, rect.corners[1]!, rect.corners[3]!].map((c, i) => ({
      ...c,
      wall: `w${i + 1}`,
    })),
  };
  assert.match(texts(crossed).join(), /The south wall and the north wall cross or touch/);
  const door = newFixture(rect, "door", "w4", 2.5);
  assert.match(texts(withFixture(rect, door)).join(), /Door 1 reaches beyond the end of the west wall/);
  const window = newFixture(rect, "window", "w1", 1);
  const twice = withFixture(withFixture(rect, window), { ...newFixture(rect, "door", "w1", 2), id: "door_1" });
  assert.match(texts(twice).join(), /Window 1 and door 1 overlap/);
  assert.match(texts(rectangle(4, 0.8)).join(), /too narrow: 0.80 m/);
  assert.match(texts({ ...withFixture(rect, window), height: 2 }).join(), /higher than the ceiling/);
});

test("a window above a door does not overlap it", () => {
  const door = newFixture(rect, "door", "w1", 1);
  const above = { ...newFixture(rect, "window", "w1", 1), sill: 2.1, head: 2.5, width: 0.9 } as const;
  assert.deepEqual(texts(withFixture(withFixture(rect, door), above as never)), []);
});

test("history goes back and forth, and forgets what was undone on a new act", () => {
  const one = pushed(pushed(begun("a"), "b", "to b"), "c", "to c");
  const back = undone(one);
  assert.equal(back.now.state, "b");
  assert.equal(redone(back).now.state, "c");
  assert.equal(pushed(back, "d", "to d").future.length, 0);
  assert.equal(undone(undone(undone(one))).now.state, "a");
});

test("a picture is scaled by a known length, about its first point", () => {
  const picture = placed("blob:x", "plan.png", 1000, 500);
  const to = scaled(picture, { x: 2, y: 1 }, { x: 4, y: 1 }, 3);
  assert.ok(Math.abs(to.metresPerPixel - picture.metresPerPixel * 1.5) < 1e-12);
  // What was at the first point still is.
  assert.ok(Math.abs((2 - picture.at.x) / picture.metresPerPixel - (2 - to.at.x) / to.metresPerPixel) < 1e-9);
});
