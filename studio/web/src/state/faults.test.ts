// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { FindingSchema } from "../gen/flair/v1/layout_metrics_pb";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { untoldOverlaps } from "./faults";
import { piecesOf } from "./pieces";

const piece = (id: string, category: string, heightM: number) =>
  ({ id, name: id.replace(/_\d$/, "").replace(/_/g, " "), category, kind: ObjectKind.FLOOR, widthM: 1, depthM: 1, heightM });

const pieces = piecesOf(create(SolvedLayoutSchema, {
  graph: {
    objectList: {
      objects: [piece("desk", "desk", 0.74), piece("bed", "double_bed", 1), piece("chair_1", "chair", 0.9),
        piece("chair_2", "chair", 0.9), { ...piece("rug", "rug", 0.01), walkOver: true }],
    },
  },
  placements: [
    { objectId: "desk", xM: 1, yM: 1 }, { objectId: "bed", xM: 5, yM: 1 }, { objectId: "chair_1", xM: 1, yM: 1.8, thetaRad: Math.PI },
    { objectId: "chair_2", xM: 5, yM: 5 }, { objectId: "rug", xM: 1, yM: 1 },
  ],
}));
const at = (x: number, y: number, theta = 0) => ({ x, y, theta });
const told = (poses: Array<[string, ReturnType<typeof at>]>) =>
  untoldOverlaps(pieces, new Map(poses), []).map(({ objectId, partnerId }) => [objectId, partnerId].sort().join(" "));

test("a chair that is pushed under a desk and a rug below it are no fault", () => {
  assert.deepEqual(told([]), []);
});

test("a chair whose back is in the desk is told", () => {
  assert.deepEqual(told([["chair_1", at(1, 1.8)]]), ["chair_1 desk"]);
});

test("a turned piece that reaches into another one is told, and how far", () => {
  // Its corner is 0.71 m from its middle, and 0.11 m beyond the desk's side.
  const poses = new Map([["bed", at(2.1, 1, Math.PI / 4)]]);
  const [found] = untoldOverlaps(pieces, poses, []);
  assert.equal(found!.message, "the desk and the bed overlap by 0.11 m");
});

test("two chairs in one place are told, though they are as high as tables", () => {
  assert.deepEqual(told([["chair_2", at(1, 2.6)]]), ["chair_1 chair_2"]);
});

test("what the server has told is not told again", () => {
  const known = create(FindingSchema, { objectId: "desk", partnerId: "bed" });
  assert.deepEqual(untoldOverlaps(pieces, new Map([["bed", at(1.9, 0.6)]]), [known]), []);
});
