// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ObjectKind, ObjectSchema } from "../gen/flair/v1/object_list_pb";
import { OpeningKind, RoomSchema } from "../gen/flair/v1/room_pb";
import type { Piece } from "../state/pieces";
import { atDoor, fromPiece, keptInside, wallBehind, wallsInTheWay } from "./places";

const floor = [{ x: 0, y: 0 }, { x: 4, y: 0 }, { x: 4, y: 3 }, { x: 0, y: 3 }];
const room = create(RoomSchema, {
  floor: { vertices: floor.map(({ x, y }) => ({ xM: x, yM: y })) },
  walls: ["south", "east", "north", "west"].map((name) => ({ name })),
  openings: [{ id: "door_1", kind: OpeningKind.DOOR, wall: "south", offsetM: 3.1, widthM: 0.9 }],
});
const piece = (category: string, y: number, kind = ObjectKind.FLOOR): Piece => ({
  id: category, object: create(ObjectSchema, { category, kind, heightM: 1 }), size: { width: 1.6, depth: 2 },
  pose: { x: 2, y, theta: Math.PI }, z: 0, pinned: false,
});

test("one begins a step inside the door, clear of the corner, and looks into the room", () => {
  const { eye, target } = atDoor(room);
  assert.deepEqual([eye.x, eye.y, eye.z, target.x, target.y], [3.5, 0.8, 1.6, 2, 1.5]);
});

test("nobody stands in a wall", () => {
  const { x, y } = keptInside(floor, { x: 3.95, y: -0.1 });
  assert.ok(Math.hypot(x - 3.7, y - 0.3) < 1e-9);
  assert.deepEqual(keptInside(floor, { x: 2, y: 1 }), { x: 2, y: 1 });
});

test("from a bed one looks from the pillow to its foot", () => {
  const { eye, target } = fromPiece(piece("bed", 2), floor);
  assert.ok(eye.y > 2.6 && eye.z < 1 && target.y < 1.1);
});

test("walls that are seen from behind go, with what hangs on them", () => {
  assert.deepEqual([...wallsInTheWay(room, { x: 6, y: -4 })], ["south", "east"]);
  assert.deepEqual([...wallsInTheWay(room, { x: 2, y: 1 })], []);
  assert.equal(wallBehind(piece("painting", 2, ObjectKind.WALL), room), "north");
});
