// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { OutcomeStatus, SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import type { Note } from "./note";
import { countOf, countOfOutcomes, wishesOf } from "./wish_list";

const note: Note = {
  zones: [{
    objects: [
      { id: "bed", name: "bed", demands: [
        { fate: "holds", sentence_id: "s1", edge_ids: ["e1", "e2"] },
        { fate: "missed", sentence_id: "s2", edge_ids: ["e3"] },
      ] },
      { id: "desk", name: "desk", demands: [
        { fate: "holds", sentence_id: "s1", edge_ids: ["e1", "e2"] },
        { fate: "holds", edge_ids: ["e4"] },
      ] },
    ],
  }],
  demands_of_no_object: [{ fate: "not understood", sentence_id: "s3" }, { fate: "dropped", sentence_id: "s4" }],
};

test("a wish of several pieces is one, and what is dropped or not understood is among those that do not hold", () => {
  assert.equal(wishesOf(note).length, 5);
  assert.deepEqual(countOf(note), { held: 2, asked: 5 });
});

test("outcomes alone give the same count", () => {
  const sentences = ["s1", "s2", "s3", "s4"].map((id) => ({ id }));
  const edges = [["e1", "s1"], ["e2", "s1"], ["e3", "s2"], ["e4", ""]].map(([id, sentenceId]) => ({ id, sentenceId }));
  const outcome = (edgeId: string, status = OutcomeStatus.SATISFIED) => ({ edgeId, status });
  const layout = create(SolvedLayoutSchema, {
    graph: { constraintList: { sentences }, edges },
    edgeOutcomes: [outcome("e1"), outcome("e2"), outcome("e3", OutcomeStatus.VIOLATED), outcome("e4")],
  });
  assert.deepEqual(countOfOutcomes(layout, layout.edgeOutcomes), countOf(note));
});
