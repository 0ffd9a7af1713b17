// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { OutcomeStatus, SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { isSame, variantsOf } from "./layouts";

const outcome = (status: OutcomeStatus) => ({ edgeId: "e1", status });

test("runner-ups that are not complete cannot be taken and do not count", () => {
  const layout = create(SolvedLayoutSchema, {
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
