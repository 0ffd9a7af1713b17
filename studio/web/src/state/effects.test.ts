// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { FindingKind, LayoutMetricsSchema } from "../gen/flair/v1/layout_metrics_pb";
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
    worse: [{ sentenceId: "s2", text: "Two.", how: "lost" }],
  });
});

test("what is dropped is neither", () => {
  const effect = effectOf(
    layout(SATISFIED, SATISFIED, VIOLATED, SATISFIED),
    layout(SATISFIED, SATISFIED, DROPPED, DROPPED),
  );
  assert.deepEqual(effect, { gained: [], lost: [], worse: [] });
});

test("what got worse is told, the worst first", () => {
  const before = layout(VIOLATED, SATISFIED, SATISFIED, SATISFIED), after = layout(VIOLATED, SATISFIED, VIOLATED, VIOLATED);
  before.edgeOutcomes[0]!.missedBy = 0.3, after.edgeOutcomes[0]!.missedBy = 0.5;
  for (const { graph } of [before, after]) graph!.edges[3]!.weight = 4;
  const overlap = (amount: number) => create(LayoutMetricsSchema, {
    findings: [{ kind: FindingKind.OVERLAP, objectId: "bed", partnerId: "desk", amount, message: `by ${amount} m` }],
  });
  after.metrics = overlap(0.2);
  assert.deepEqual(effectOf(before, after).worse, [
    { sentenceId: "", text: "by 0.2 m", how: "fault" },
    { sentenceId: "s3", text: "Three.", how: "lost" },
    { sentenceId: "s2", text: "Two.", how: "lost" },
    { sentenceId: "s1", text: "One.", how: "further" },
  ]);
  before.metrics = overlap(0.2);
  assert.equal(effectOf(before, after).worse.length, 3);
});

test("that nobody gets in is told before all else, once", () => {
  const before = layout(SATISFIED, SATISFIED, SATISFIED, SATISFIED), after = layout(VIOLATED, SATISFIED, SATISFIED, SATISFIED);
  after.metrics = create(LayoutMetricsSchema, {
    findings: [
      { kind: FindingKind.OVERLAP, objectId: "bed", partnerId: "desk", amount: 0.5, message: "by 0.5 m" },
      { kind: FindingKind.USE_NOT_MET, objectId: "desk", partnerId: "door_1", message: "nobody gets in" },
      { kind: FindingKind.USE_NOT_MET, objectId: "bed", sentenceId: "s1", message: "of a sentence" },
    ],
  });
  assert.deepEqual(effectOf(before, after).worse.map(({ text }) => text), ["nobody gets in", "by 0.5 m", "One."]);
  assert.deepEqual(effectOf(after, after).worse, []);
});
