// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { corners } from "../geometry/footprint";
import { vec, type Vec } from "../geometry/vec";
import { ConstraintEdgeSchema } from "../gen/flair/v1/layout_graph_pb";
import { isForWall, keptInside, pushedBack } from "./walls";

const floor = [vec(0, 0), vec(4, 0), vec(4, 3), vec(0, 3)];
// The north-east quarter is another room's.
const bent = [vec(0, 0), vec(4, 0), vec(4, 2), vec(2, 2), vec(2, 4), vec(0, 4)];
const bed = { width: 1.6, depth: 2 };
const near = (value: number, wanted: number) => assert.ok(Math.abs(value - wanted) < 1e-5, `${value}, not ${wanted}`);

test("what is dragged into a wall, or through it, stands at it", () => {
  const at = keptInside({ x: 3.9, y: 1.5, theta: 0 }, bed, floor);
  near(at.x, 3.2), near(at.y, 1.5);
  const far = keptInside({ x: 9, y: -3, theta: Math.PI / 2 }, bed, floor);
  near(far.x, 3), near(far.y, 0.8), near(far.theta, Math.PI / 2);
  const free = { x: 2, y: 1.5, theta: 0.3 };
  assert.deepEqual(keptInside(free, bed, floor), free);
});

test("no corner of a turned piece is in a wall", () => {
  for (let theta = 0; theta < 3; theta += 0.4) {
    for (const [x, y] of [[0, 0], [4, 3], [-1, 1], [2, 5]] as const) {
      const at = keptInside({ x, y, theta }, { width: 1, depth: 0.5 }, floor);
      for (const p of corners(at, { width: 1, depth: 0.5 })) {
        assert.ok(p.x > -1e-6 && p.x < 4 + 1e-6 && p.y > -1e-6 && p.y < 3 + 1e-6, `${theta}: ${p.x}, ${p.y}`);
      }
    }
  }
});

test("what meets a corner that reaches into the room goes beside it", () => {
  const at = keptInside({ x: 1.5, y: 2.5, theta: 0 }, bed, bent);
  near(at.x, 1.2), near(at.y, 2.5);
});

test("several are pushed back together", () => {
  const square = (x: number): Vec[] => [vec(x, 1), vec(x + 1, 1), vec(x + 1, 2), vec(x, 2)];
  const by = pushedBack([square(2.5), square(3.75)], floor);
  near(by.x, -0.75), near(by.y, 0);
  assert.deepEqual(pushedBack([square(0), square(3)], floor), vec(0, 0));
});

test("a wish says what has its back at a wall", () => {
  const edge = (side?: string) => create(ConstraintEdgeSchema, {
    type: "against_wall",
    arguments: [["object", "bed"], ...(side ? [["side", side]] : [])].map(([name, text]) => ({
      name: name!, value: { value: { case: "text" as const, value: text! } },
    })),
  });
  assert.ok(isForWall([edge()], "bed"));
  assert.ok(isForWall([edge("back")], "bed"));
  assert.ok(!isForWall([edge("left")], "bed"));
  assert.ok(!isForWall([edge()], "desk"));
});
