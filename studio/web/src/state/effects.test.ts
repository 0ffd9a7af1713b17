// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { OutcomeStatus, SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { effectOf } from "./effects";

const { SATISFIED, VIOLATED, DROPPED } = OutcomeStatus;

// Sentence s1 has two constraints, s2 and s3 one each.
function layout(...statuses: OutcomeStatus[]) {
  return create(SolvedLayoutSchema, {
    graph: {
      edges: [
        ["e1", "s1"],
        ["e2", "s1"],
        ["e3", "s2"],
        ["e4", "s3"],
      ].map(([id, sentenceId]) => ({ id: id!, sentenceId: sentenceId! })),
      constraintList: {
        sentences: [
          { id: "s1", text: "One." },
          { id: "s2", text: "Two." },
          { id: "s3", text: "Three." },
        ],
      },
    },
    edgeOutcomes: statuses.map((status, i) => ({ edgeId: `e${i + 1}`, status })),
  });
}

test("sentences that came to hold and that ceased to are told apart", () => {
  const effect = effectOf(
    layout(SATISFIED, VIOLATED, SATISFIED, SATISFIED),
    layout(SATISFIED, SATISFIED, VIOLATED, SATISFIED),
  );
  assert.deepEqual(effect, {
    gained: [{ sentenceId: "s1", text: "One." }],
    lost: [{ sentenceId: "s2", text: "Two." }],
  });
});

test("what is dropped is neither", () => {
  const effect = effectOf(
    layout(SATISFIED, SATISFIED, VIOLATED, SATISFIED),
    layout(SATISFIED, SATISFIED, DROPPED, DROPPED),
  );
  assert.deepEqual(effect, { gained: [], lost: [] });
});
