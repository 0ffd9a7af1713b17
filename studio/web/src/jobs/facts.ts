// SPDX-License-Identifier: GPL-3.0-or-later
// What came of a job, from its layout: what stands in the room, and what of the brief was not done.
import { SentenceOrigin } from "../gen/flair/v1/constraint_list_pb";
import { Severity, type Diagnostic } from "../gen/flair/v1/provenance_pb";
import { OutcomeStatus, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";

export interface Facts {
  readonly count: number;
  // "double bed", "nightstand (2)": what was asked for first, then what stands on the floor.
  readonly pieces: readonly string[];
  readonly notDone: readonly string[];
}

function piecesOf({ graph, placements }: SolvedLayout): string[] {
  const placed = new Set(placements.map(({ objectId }) => objectId));
  const counts = new Map<string, number>();
  const objects = (graph?.objectList?.objects ?? []).filter(({ id }) => placed.has(id));
  const isAsked = new Set(objects.filter(({ requested }) => requested).map(({ name }) => name));
  const order = [...objects].sort((a, b) => Number(isAsked.has(b.name)) - Number(isAsked.has(a.name)) || a.role - b.role);
  for (const { name } of order) counts.set(name, (counts.get(name) ?? 0) + 1);
  return [...counts].map(([name, count]) => (count > 1 ? `${name} (${count})` : name));
}

// As the explanation of a room says it: warnings, what was asked for and left out, wishes of the brief that do not hold.
function notDoneOf({ graph, edgeOutcomes }: SolvedLayout): string[] {
  const lists: Array<readonly Diagnostic[] | undefined> = [graph?.room?.diagnostics, graph?.zonePlan?.diagnostics,
    graph?.objectList?.diagnostics, graph?.constraintList?.diagnostics];
  const warnings = lists.flatMap((list) => list ?? []).filter(({ severity }) => severity >= Severity.WARNING);
  const omissions = (graph?.objectList?.omissions ?? []).filter(({ requested }) => requested);
  const missed = new Map(edgeOutcomes.filter(({ status }) => status === OutcomeStatus.VIOLATED)
    .map(({ edgeId, reason }) => [edgeId, reason]));
  const broken = new Map((graph?.edges ?? []).filter(({ id }) => missed.has(id))
    .map(({ id, sentenceId }) => [sentenceId, missed.get(id)!]));
  const wishes = (graph?.constraintList?.sentences ?? [])
    .filter(({ id, origin }) => origin === SentenceOrigin.BRIEF && broken.has(id))
    .map(({ id, reason }) => [reason, broken.get(id)].filter(Boolean).join("; "));
  return [...new Set([
    ...warnings.map(({ message }) => message),
    ...omissions.map(({ name, reason }) => `${name} is left out: ${reason}`),
    ...wishes,
  ])];
}

export const factsOf = (layout: SolvedLayout): Facts =>
  ({ count: layout.placements.length, pieces: piecesOf(layout), notDone: notDoneOf(layout) });
