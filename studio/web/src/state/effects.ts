// SPDX-License-Identifier: GPL-3.0-or-later
// What an act has brought about beside what it was for: sentences that hold since then, and those that no longer do.
import { OutcomeStatus, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";

export interface Change {
  readonly sentenceId: string;
  readonly text: string;
}

export interface Effect {
  readonly gained: readonly Change[];
  readonly lost: readonly Change[];
}

// Sentence id -> whether all its constraints hold; those that come from no sentence are left out.
function verdicts(layout: SolvedLayout): Map<string, boolean> {
  const sentences = new Map(layout.graph?.edges.map((edge) => [edge.id, edge.sentenceId]));
  const held = new Map<string, boolean>();
  for (const { edgeId, status } of layout.edgeOutcomes) {
    const id = sentences.get(edgeId);
    if (!id || status === OutcomeStatus.DROPPED) continue;
    held.set(id, (held.get(id) ?? true) && status === OutcomeStatus.SATISFIED);
  }
  return held;
}

export function effectOf(before: SolvedLayout | undefined, after: SolvedLayout): Effect {
  if (!before) return { gained: [], lost: [] };
  const texts = new Map(after.graph?.constraintList?.sentences.map((one) => [one.id, one.text]));
  const was = verdicts(before);
  const changed = (to: boolean) => [...verdicts(after)].filter(([id, holds]) => holds === to && was.get(id) === !to)
    .map(([id]): Change => ({ sentenceId: id, text: texts.get(id) ?? id }));
  return { gained: changed(true), lost: changed(false) };
}
