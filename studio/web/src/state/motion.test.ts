// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { between, differs } from "./motion";

test("a turn takes the shorter way", () => {
  const half = between({ x: 0, y: 0, theta: 0.1 }, { x: 2, y: 0, theta: 2 * Math.PI - 0.1 }, 0.5);
  assert.ok(Math.abs(half.theta) < 1e-9);
  assert.equal(half.x, 1);
});

test("a whole turn is no difference", () => {
  assert.ok(!differs({ x: 0, y: 0, theta: 0 }, { x: 0, y: 0, theta: 2 * Math.PI }));
  assert.ok(differs({ x: 0, y: 0, theta: 0 }, { x: 0.01, y: 0, theta: 0 }));
});
