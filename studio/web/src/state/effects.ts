// SPDX-License-Identifier: GPL-3.0-or-later
// What an act has brought about beside what it was for: what holds since then, and what is worse, the worst first.
import type { Finding } from "../gen/flair/v1/layout_metrics_pb";
import { OutcomeStatus, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";

export interface Change {
  // Empty for what is wrong with the room whatever is wished.
  readonly sentenceId: string;
  readonly text: string;
}

export interface Effect {
  readonly gained: readonly Change[];
  // What does not hold any more.
  readonly lost: readonly Change[];
  // All that is worse, with what did not hold before and is further from it now.
  readonly worse: ReadonlyArray<Change & { how: "fault" | "lost" | "further" }>;
}

interface Verdict {
  readonly holds: boolean;
  readonly weight: number;
  // By how much it is missed at most, where one number says it.
  readonly missedBy: number;
}

// Less is to be seen by nobody.
const kSeen = 0.02, kAll = 1e6;

// By sentence; those of which all constraints are dropped, and constraints of no sentence, are left out.
function verdicts(layout: SolvedLayout): Map<string, Verdict> {
  const edges = new Map(layout.graph?.edges.map((edge) => [edge.id, edge]));
  const found = new Map<string, Verdict>();
  for (const { edgeId, status, missedBy } of layout.edgeOutcomes) {
    const edge = edges.get(edgeId), id = edge?.sentenceId;
    if (!edge || !id || status === OutcomeStatus.DROPPED) continue;
    const other = found.get(id), holds = status === OutcomeStatus.SATISFIED;
    found.set(id, {
      holds: holds && (other?.holds ?? true),
      weight: Math.max(edge.weight, other?.weight ?? 0),
      missedBy: Math.max(holds ? 0 : missedBy ?? 0, other?.missedBy ?? 0),
    });
  }
  return found;
}

// What is wrong whatever is wished, by what and of whom.
function faultsOf(layout: SolvedLayout) {
  const faults = layout.metrics?.findings.filter(({ sentenceId }) => !sentenceId) ?? [];
  return new Map(faults.map((one) => [`${one.kind} ${[one.objectId, one.partnerId].sort().join(" ")}`, one]));
}

export function effectOf(before: SolvedLayout | undefined, after: SolvedLayout): Effect {
  if (!before) return { gained: [], lost: [], worse: [] };
  const texts = new Map(after.graph?.constraintList?.sentences.map((one) => [one.id, one.text]));
  const was = verdicts(before), is = [...verdicts(after)];
  const change = (id: string): Change => ({ sentenceId: id, text: texts.get(id) ?? id });
  const heaviest = (list: typeof is) => list.sort(([, a], [, b]) => b.weight - a.weight || b.missedBy - a.missedBy)
    .map(([id]) => change(id));
  const gained = is.filter(([id, { holds }]) => holds && was.get(id)?.holds === false).map(([id]) => change(id));
  const lost = heaviest(is.filter(([id, { holds }]) => !holds && was.get(id)?.holds === true));
  const further = heaviest(is.filter(([id, { holds, missedBy }]) => {
    const then = was.get(id);
    return !holds && then?.holds === false && missedBy > then.missedBy + kSeen;
  }));
  const known = faultsOf(before);
  // What no number says, as that nobody gets in, is worse than all else.
  const amountOf = (one: Finding | undefined) => (one ? one.amount ?? kAll : 0);
  const faults = [...faultsOf(after)].filter(([key, one]) => amountOf(one) > amountOf(known.get(key)) + kSeen)
    .map(([, one]) => one).sort((a, b) => amountOf(b) - amountOf(a));
  return {
    gained,
    lost,
    worse: [
      ...faults.map(({ message }) => ({ sentenceId: "", text: message, how: "fault" as const })),
      ...lost.map((one) => ({ ...one, how: "lost" as const })),
      ...further.map((one) => ({ ...one, how: "further" as const })),
    ],
  };
}
