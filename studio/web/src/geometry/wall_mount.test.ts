// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { vec } from "./vec";
import { mounted } from "./wall_mount";

const floor = [vec(0, 0), vec(4, 0), vec(4, 3), vec(0, 3)];
const near = (value: number, wanted: number) => assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);

test("a picture hangs on the nearest wall, faces the room and stays between its corners", () => {
  const south = mounted(vec(1, 0.4), 1, 0.1, floor)!;
  near(south.pose.x, 1), near(south.pose.y, 0.05), near(south.pose.theta, 0);
  const east = mounted(vec(3.9, 2.7), 1, 0.1, floor)!;
  near(east.pose.x, 3.95), near(east.pose.y, 2.5), near(east.pose.theta, Math.PI / 2);
});

test("what is wider than its wall hangs in the middle of it", () => {
  const wide = mounted(vec(4.5, 0.2), 5, 0.1, floor)!;
  near(wide.pose.y, 1.5);
});
