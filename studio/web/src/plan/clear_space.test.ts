// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ConstraintEdgeSchema } from "../gen/flair/v1/layout_graph_pb";
import { boxOf } from "../geometry/polygon";
import { clearSpaceOf, stripBeside } from "./clear_space";

const accessible = create(ConstraintEdgeSchema, {
  id: "e3", type: "accessible", arguments: [
    { name: "object", value: { value: { case: "text", value: "bed" } } },
    { name: "sides", value: { value: { case: "texts", value: { items: ["left", "right"] } } } },
    { name: "min_clearance_m", value: { value: { case: "number", value: 0.6 } } },
  ],
});

test("an edge that asks for free floor says where", () => {
  assert.deepEqual(clearSpaceOf(accessible), { objectId: "bed", sides: ["left", "right"], metres: 0.6 });
  assert.equal(clearSpaceOf(create(ConstraintEdgeSchema, { type: "near" })), undefined);
});

test("the strip lies beyond the side, in the room's frame", () => {
  // Its front faces west, so its left faces south.
  const { min, max } = boxOf(stripBeside({ x: 3, y: 2, theta: Math.PI / 2 }, { width: 1.5, depth: 2 }, "left", 0.6));
  assert.ok(Math.abs(max.y - 1.25) < 1e-9 && Math.abs(min.y - 0.65) < 1e-9);
  assert.ok(Math.abs(min.x - 2) < 1e-9 && Math.abs(max.x - 4) < 1e-9);
});
