// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { vec } from "../geometry/vec";
import { freeBeside } from "./beside";
import { piecesOf } from "./pieces";

const floor = [vec(0, 0), vec(4, 0), vec(4, 1), vec(0, 1)];

function besideChair(at: number, ...others: number[]) {
  const ids = [at, ...others].map((xM, i) => ({ objectId: `chair_${i + 1}`, xM, yM: 0.5 }));
  const objects = ids.map(({ objectId: id }) => ({ id, kind: ObjectKind.FLOOR, widthM: 0.5, depthM: 0.5, heightM: 0.9 }));
  const pieces = piecesOf(create(SolvedLayoutSchema, { graph: { objectList: { objects } }, placements: ids }));
  return freeBeside(pieces, [pieces.get("chair_1")!], floor);
}

test("a copy stands beside what it is a copy of, where nothing stands and within the room", () => {
  assert.deepEqual(besideChair(1), vec(0.55, 0));
  assert.deepEqual(besideChair(1, 1.6), vec(-0.55, 0));
  assert.equal(besideChair(0.25, 0.9), undefined);
});
