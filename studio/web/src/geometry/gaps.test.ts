// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { gapsOf } from "./gaps";
import { vec } from "./vec";

// 6 m by 5 m without its south-western 2 m by 3 m.
const ell = [vec(2, 0), vec(6, 0), vec(6, 5), vec(0, 5), vec(0, 3), vec(2, 3)];
const box = (x: number, y: number, w = 1, d = 1) => ({ min: vec(x, y), max: vec(x + w, y + d) });
const near = (a: number, b: number) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a piece in the arm of an L is measured to the wall that it faces", () => {
  near(gapsOf(box(3, 1), ell).x, 1);
  near(gapsOf(box(3, 1), ell).y, 1);
  near(gapsOf(box(0.5, 3.5), ell).x, 0.5);
  near(gapsOf(box(0.5, 3.5), ell).y, 0.5);
});

test("of two walls the nearer one counts, and one that is merely touched does not", () => {
  near(gapsOf(box(3, 2.5), ell).x, 1);
  near(gapsOf(box(3, 3), ell).x, 3);
  near(gapsOf(box(1.5, 3.5), ell).y, 0.5);
  near(gapsOf(box(2, 3.5), ell).y, 3.5);
});

test("in a wall it is negative, outside of the room as to the room's end", () => {
  near(gapsOf(box(1.8, 1), ell).x, -0.2);
  near(gapsOf(box(3, 7), ell).x, 3);
});

test("a slanting wall is measured where it comes nearest", () => {
  const slanted = [vec(0, 0), vec(4, 0), vec(4, 4), vec(2, 4)];
  near(gapsOf(box(2, 1), slanted).x, 2 - (2 - 0.005) / 2);
});
