// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { headingText, parseHeading, pointOf } from "./compass";

const degrees = (angle: number) => (angle * Math.PI) / 180;

test("headings are read as on a compass, clockwise from north", () => {
  for (const [theta, text] of [[0, "N"], [270, "E"], [180, "S"], [90, "W"], [45, "NW"], [323, "37°"]] as const) {
    assert.equal(headingText(degrees(theta)), text);
  }
});

test("what is typed may be a point or degrees, and a quarter clockwise adds 90", () => {
  for (const text of ["E", "east", "90", "90°", " 450 "]) {
    assert.ok(Math.abs(parseHeading(text)! - degrees(270)) < 1e-9, text);
  }
  assert.ok(Math.abs(parseHeading("south west")! - degrees(135)) < 1e-9);
  assert.equal(parseHeading("up"), undefined);
  assert.equal(parseHeading(""), undefined);
});

test("directions in the room have the names of the compass", () => {
  assert.deepEqual([pointOf({ x: 0, y: 1 }), pointOf({ x: -1, y: 0 }), pointOf({ x: 1, y: -1 })], ["north", "west", "south-east"]);
});
