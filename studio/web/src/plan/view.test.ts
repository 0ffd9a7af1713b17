// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { vec } from "../geometry/vec";
import { fitted, kMaxScale, toRoom, toScreen, zoomedAt } from "./view";

const floor = [vec(0, 0), vec(4, 0), vec(4, 5), vec(0, 5)];

test("north is up, and pixels lead back to the room", () => {
  const view = fitted(floor, 800, 600, 50);
  assert.ok(toScreen(view, vec(0, 5)).y < toScreen(view, vec(0, 0)).y);
  assert.ok(Math.abs(toRoom(view, toScreen(view, vec(1.5, 2))).y - 2) < 1e-9);
});

test("the room is fitted in the middle with its margin", () => {
  const view = fitted(floor, 800, 600, 50);
  assert.equal(view.scale, 100);
  assert.deepEqual(toScreen(view, vec(2, 2.5)), vec(400, 300));
});

test("zooming keeps what is under the pointer", () => {
  const view = fitted(floor, 800, 600, 50), pixel = vec(123, 456);
  const before = toRoom(view, pixel), after = toRoom(zoomedAt(view, pixel, 1.7), pixel);
  assert.ok(Math.hypot(before.x - after.x, before.y - after.y) < 1e-9);
});

test("zooming ends at the closest view", () => {
  assert.equal(zoomedAt({ scale: 1000, left: 0, top: 0 }, vec(0, 0), 9).scale, kMaxScale);
});
