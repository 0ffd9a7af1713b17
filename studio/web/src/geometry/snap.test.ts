// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { corners } from "./footprint";
import { snapped, snappedAngle } from "./snap";
import { add, vec } from "./vec";

const floor = [vec(0, 0), vec(4, 0), vec(4, 5), vec(0, 5)];
const size = { width: 1, depth: 0.5 };
const piece = (x: number, y: number, theta = 0) => ({ polygon: corners({ x, y, theta }, size), theta });

test("a piece near a wall is put to it, and only as far", () => {
  const snap = snapped(piece(1.2, 0.29), floor, [], 0.08);
  assert.ok(Math.abs(snap.by.y + 0.04) < 1e-9);
  assert.equal(snap.by.x, 0);
  assert.equal(snap.guides[0]?.kind, "wall");
});

test("a corner is met exactly", () => {
  const { by, guides } = snapped(piece(0.55, 4.7), floor, [], 0.08);
  assert.ok(Math.abs(by.x + 0.05) < 1e-9);
  assert.ok(Math.abs(by.y - 0.05) < 1e-9);
  assert.equal(guides.length, 2);
});

test("nothing within reach leaves it alone", () => {
  assert.deepEqual(snapped(piece(1.3, 1.4), floor, [], 0.05), { by: vec(0, 0), guides: [] });
});

test("edges come in line with those of another piece", () => {
  const other = { id: "other", polygon: corners({ x: 1.2, y: 2.4, theta: 0 }, size), theta: 0 };
  const { by, guides } = snapped(piece(1.23, 1.4), floor, [other], 0.05);
  assert.ok(Math.abs(by.x + 0.03) < 1e-9);
  assert.equal(guides[0]?.kind, "piece");
});

test("what is far away catches nothing", () => {
  const other = { id: "other", polygon: corners({ x: 1.2, y: 4.2, theta: 0 }, size), theta: 0 };
  assert.deepEqual(snapped(piece(1.23, 1.4), floor, [other], 0.05).guides, []);
});

test("a turned piece touches a wall with its corner", () => {
  const moving = piece(2.6, 0.6, 0.5);
  const { by } = snapped(moving, floor, [], 0.2);
  assert.ok(Math.abs(Math.min(...moving.polygon.map((p) => add(p, by).y))) < 1e-9);
});

test("a wall at an angle catches the piece that is parallel to it", () => {
  const cut = [vec(0, 0), vec(4, 0), vec(4, 3), vec(2, 5), vec(0, 5)];
  const theta = (3 * Math.PI) / 4;
  const moving = piece(2.79, 3.79, theta);
  const { by } = snapped(moving, cut, [], 0.1);
  const beyond = Math.max(...moving.polygon.map((p) => add(p, by)).map((p) => p.x + p.y - 7));
  assert.ok(Math.abs(beyond) < 1e-9);
});

test("angles near a step are taken to it", () => {
  assert.equal(snappedAngle(0.26, Math.PI / 12, 0.05), Math.PI / 12);
  assert.equal(snappedAngle(0.13, Math.PI / 12, 0.05), 0.13);
});

test("what is pushed into a wall comes out of it, whatever else it could be in line with", () => {
  const other = { id: "other", polygon: corners({ x: 3.54, y: 2.4, theta: 0 }, size), theta: 0 };
  const { by } = snapped(piece(3.53, 1.6), floor, [other], 0.05);
  assert.ok(Math.abs(by.x + 0.03) < 1e-9, String(by.x));
});

test("a wall's middle catches what stands at it, not only the room's", () => {
  const l = [vec(0, 0), vec(6, 0), vec(6, 2), vec(2, 2), vec(2, 5), vec(0, 5)];
  const { by } = snapped(piece(1.03, 4.75), l, [], 0.05);
  assert.ok(Math.abs(by.x + 0.03) < 1e-9, String(by.x));
});
