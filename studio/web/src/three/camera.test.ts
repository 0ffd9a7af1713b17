// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { viewCameraOf } from "./camera";

const eye = { x: 1, y: 1.6, z: -2 }, target = { x: 3, y: 1, z: -4 };

test("the view's frame is turned into the room's", () => {
  const { eyeM, targetM } = viewCameraOf({ eye, target, angle: 60, aspect: 1 });
  assert.deepEqual([eyeM, targetM], [[1, 2, 1.6], [3, 4, 1]]);
});

test("a square picture holds all of a wide one, and all of a high one", () => {
  const angleOf = (aspect: number) => viewCameraOf({ eye, target, angle: 90, aspect }).fieldOfViewRad!;
  assert.ok(Math.abs(Math.tan(angleOf(2) / 2) - 2) < 1e-9);
  assert.ok(Math.abs(angleOf(0.5) - Math.PI / 2) < 1e-9);
});

test("a look straight down has an upright", () => {
  const { eyeM, targetM } = viewCameraOf({ eye: { x: 1, y: 6, z: -1 }, target: { x: 1, y: 0, z: -1 }, angle: 50, aspect: 1 });
  assert.notDeepEqual(eyeM!.slice(0, 2), targetM!.slice(0, 2));
});
