// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { OutcomeStatus, SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { changedSince, isSame, variantsOf } from "./layouts";

const outcome = (status: OutcomeStatus) => ({ edgeId: "e1", status });

test("runner-ups that are not complete cannot be taken and do not count", () => {
  const layout = create(SolvedLayoutSchema, {
    graph: { edges: [{ id: "e1" }] },
    placements: [{ objectId: "bed", xM: 1 }],
    edgeOutcomes: [outcome(OutcomeStatus.SATISFIED)],
    runnerUps: [
      { placements: [{ objectId: "bed", xM: 9 }] },
      { placements: [{ objectId: "bed", xM: 2 }], edgeOutcomes: [outcome(OutcomeStatus.VIOLATED)] },
    ],
  });
  const { list } = variantsOf("id", layout);
  assert.deepEqual(
    list.map(({ index, held, asked }) => [index, held, asked]),
    [
      [-1, 1, 1],
      [0, 0, 1],
    ],
  );
  assert.equal(list[1]!.placements[0]!.xM, 2);
  assert.ok(isSame(layout.placements, list[0]!.placements));
  assert.ok(!isSame(layout.placements, list[1]!.placements));
});

test("what has changed since they were found is known", () => {
  const room = (width: number) => ({ floor: { vertices: [{ xM: 0 }, { xM: width }] } });
  const layout = (width: number, ...ids: string[]) =>
    create(SolvedLayoutSchema, { graph: { room: room(width), objectList: { objects: ids.map((id) => ({ id })) } } });
  const found = variantsOf("id", layout(4, "bed", "desk"));
  assert.equal(changedSince(found, layout(4, "desk", "bed")), "");
  assert.equal(changedSince(found, layout(4, "bed")), "pieces");
  assert.equal(changedSince(found, layout(5, "bed", "desk")), "walls");
});
