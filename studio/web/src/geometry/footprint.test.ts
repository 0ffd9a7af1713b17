// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { contains, corners, middleOf, normalOf, toObject, toRoom } from "./footprint";
import { vec, wrapped, type Vec } from "./vec";

const close = (actual: Vec, expected: Vec) =>
  assert.ok(Math.hypot(actual.x - expected.x, actual.y - expected.y) < 1e-9, `${actual.x}, ${actual.y}`);

test("a heading of 0 faces north, with the right side east", () => {
  const pose = { x: 1, y: 1, theta: 0 };
  close(normalOf(pose, "front"), vec(0, 1));
  close(normalOf(pose, "right"), vec(1, 0));
});

test("a quarter turn counter-clockwise faces west", () => {
  const pose = { x: 2, y: 3, theta: Math.PI / 2 };
  close(normalOf(pose, "front"), vec(-1, 0));
  close(middleOf(pose, { width: 1, depth: 2 }, "front"), vec(1, 3));
});

test("corners go counter-clockwise from the front left one", () => {
  const [frontLeft, backLeft, backRight] = corners({ x: 0, y: 0, theta: 0 }, { width: 2, depth: 1 });
  close(frontLeft!, vec(-1, 0.5));
  close(backLeft!, vec(-1, -0.5));
  close(backRight!, vec(1, -0.5));
});

test("frames are turned into each other and back", () => {
  const pose = { x: 1.2, y: -0.4, theta: 2.1 };
  close(toObject(pose, toRoom(pose, vec(0.3, 0.7))), vec(0.3, 0.7));
});

test("a point in a turned piece is in it", () => {
  const pose = { x: 0, y: 0, theta: Math.PI / 4 };
  assert.ok(contains(pose, { width: 2, depth: 0.2 }, vec(0.6, 0.6)));
  assert.ok(!contains(pose, { width: 2, depth: 0.2 }, vec(0.6, -0.6)));
});

test("headings are wrapped into [0, 2 pi)", () => {
  assert.equal(wrapped(-1e-18), 0);
  assert.ok(Math.abs(wrapped(-Math.PI / 2) - 1.5 * Math.PI) < 1e-12);
});
