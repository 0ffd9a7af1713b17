// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { sizeShifts } from "./dimensions";
import { vec } from "./vec";

const near = (found: number[], wanted: number[]) =>
  assert.deepEqual(found.map((metres) => Math.round(metres * 100) / 100), wanted);

test("lengths of walls without an inner corner stay beside them", () => {
  near(sizeShifts([vec(0, 0), vec(4, 0), vec(4, 3), vec(0, 3)]), [0, 0, 0, 0]);
});

test("at an inner corner they go beyond the walls, in line with the others", () => {
  const ell = [vec(0, 0), vec(4.6, 0), vec(4.6, 2.5), vec(3.4, 2.5), vec(3.4, 4), vec(0, 4)];
  near(sizeShifts(ell), [0, 0, 1.5, 1.2, 0, 0]);
});

test("within a niche they stay where they are when the length of another wall is there", () => {
  const niche = [vec(0, 0), vec(5, 0), vec(5, 4), vec(3, 4), vec(3, 3), vec(2, 3), vec(2, 4), vec(0, 4)];
  near(sizeShifts(niche), [0, 0, 0, 0, 1, 0, 0, 0]);
});
