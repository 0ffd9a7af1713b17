// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { vec } from "./vec";
import { corners } from "./footprint";
import { heldInside, isBacked, mounted, turnedToWall } from "./wall_mount";

const floor = [vec(0, 0), vec(4, 0), vec(4, 3), vec(0, 3)];
const picture = { width: 1, depth: 0.1 }, wardrobe = { width: 1.6, depth: 0.6 };
const near = (value: number, wanted: number) => assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);

test("a picture hangs on the nearest wall, faces the room and stays between its corners", () => {
  const south = mounted(vec(1, 0.4), picture, floor)!;
  near(south.pose.x, 1), near(south.pose.y, 0.05), near(south.pose.theta, 0);
  const east = mounted(vec(3.9, 2.7), picture, floor)!;
  near(east.pose.x, 3.95), near(east.pose.y, 2.5), near(east.pose.theta, Math.PI / 2);
});

test("what is wider than its wall hangs in the middle of it", () => {
  const wide = mounted(vec(4.5, 0.2), { width: 5, depth: 0.1 }, floor)!;
  near(wide.pose.y, 1.5);
});

test("a picture is caught by the middle of what stands below it, and of its wall", () => {
  const bed = { id: "bed", polygon: corners({ x: 1.3, y: 1, theta: 0 }, { width: 1.6, depth: 2 }), theta: 0 };
  const above = mounted(vec(1.36, 0.2), picture, floor, [bed], 0.1)!;
  near(above.pose.x, 1.3);
  assert.equal(above.guides.length, 2);
  near(mounted(vec(1.95, 0.2), picture, floor, [bed], 0.1)!.pose.x, 2);
  near(mounted(vec(1.7, 0.2), picture, floor, [bed], 0.1)!.pose.x, 1.7);
});

test("what has its back at a wall turns it to the wall that it is brought to", () => {
  assert.ok(isBacked({ x: 2, y: 0.3, theta: 0 }, wardrobe, floor));
  assert.ok(!isBacked({ x: 2, y: 0.3, theta: Math.PI }, wardrobe, floor));
  const east = turnedToWall({ x: 3.25, y: 1.5, theta: 0 }, wardrobe, floor, 0.1);
  near(east.x, 3.7), near(east.y, 1.5), near(east.theta, Math.PI / 2);
  const pushed = turnedToWall({ x: 3.9, y: 1.5, theta: 0 }, wardrobe, floor, 0.1);
  near(pushed.x, 3.7);
});

test("along its own wall, in its corners and in the middle of the room it keeps its heading", () => {
  for (const [x, y] of [[2, 0.35], [3.25, 0.3], [2, 1.5]] as const) {
    assert.equal(turnedToWall({ x, y, theta: 0 }, wardrobe, floor, 0.1).theta, 0);
  }
});

test("what is turned at a wall stays in the room", () => {
  const turned = heldInside({ x: 2, y: 0.3, theta: Math.PI / 2 }, wardrobe, floor);
  near(turned.x, 2), near(turned.y, 0.8);
  near(heldInside({ x: 2, y: 1.5, theta: 1 }, wardrobe, floor).y, 1.5);
});
