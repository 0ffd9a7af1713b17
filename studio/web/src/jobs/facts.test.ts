// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ArtifactKind } from "../gen/flair/v1/artifact_pb";
import { SentenceOrigin } from "../gen/flair/v1/constraint_list_pb";
import { JobSchema } from "../gen/flair/v1/job_pb";
import { ObjectRole } from "../gen/flair/v1/object_list_pb";
import { Severity } from "../gen/flair/v1/provenance_pb";
import { OutcomeStatus, SolvedLayoutSchema } from "../gen/flair/v1/solved_layout_pb";
import { DocumentSchema } from "../gen/flair/v1/studio_service_pb";
import { factsOf } from "./facts";
import { editedRoomOf } from "./open";

test("what stands in the room is told once by its name, what was not done as it is explained", () => {
  const layout = create(SolvedLayoutSchema, {
    graph: {
      objectList: {
        objects: [
          { id: "lamp", name: "lamp", role: ObjectRole.TERTIARY },
          { id: "stand_1", name: "nightstand", role: ObjectRole.SECONDARY },
          { id: "stand_2", name: "nightstand", role: ObjectRole.SECONDARY },
          { id: "bed", name: "bed", role: ObjectRole.PRIMARY },
          { id: "desk", name: "desk", role: ObjectRole.SECONDARY, requested: true },
          { id: "gone", name: "piano", role: ObjectRole.SECONDARY },
        ],
        omissions: [{ name: "grand piano", reason: "it is too large", requested: true }, { name: "plant", reason: "no room" }],
        diagnostics: [
          { severity: Severity.WARNING, message: "a throne is not known" },
          { severity: Severity.NOTE, message: "a note" },
        ],
      },
      constraintList: {
        sentences: [
          { id: "s1", origin: SentenceOrigin.BRIEF, reason: "you want the desk at the window" },
          { id: "s2", reason: "the designer's" },
        ],
      },
      edges: [{ id: "e1", sentenceId: "s1" }, { id: "e2", sentenceId: "s2" }],
    },
    edgeOutcomes: [
      { edgeId: "e1", status: OutcomeStatus.VIOLATED, reason: "it is 2 m away" },
      { edgeId: "e2", status: OutcomeStatus.VIOLATED },
    ],
    placements: ["lamp", "stand_1", "stand_2", "bed", "desk"].map((objectId) => ({ objectId })),
  });
  const { count, pieces, notDone } = factsOf(layout);
  assert.equal(count, 5);
  assert.deepEqual(pieces, ["desk", "bed", "nightstand (2)", "lamp"]);
  assert.deepEqual(notDone, ["a throne is not known", "grand piano is left out: it is too large",
    "you want the desk at the window; it is 2 m away"]);
});

test("a job's room is another one as soon as it shows something else", () => {
  const job = create(JobSchema, { id: "j", artifacts: [{ id: "result", kind: ArtifactKind.SOLVED_LAYOUT }] });
  const room = (layoutId: string) => create(DocumentSchema, { id: "d", jobId: "j", layoutId });
  assert.equal(editedRoomOf([room("result")], job), undefined);
  assert.equal(editedRoomOf([room("")], job), undefined);
  assert.equal(editedRoomOf([room("other")], job)?.id, "d");
});
