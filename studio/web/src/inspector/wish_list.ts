// SPDX-License-Identifier: GPL-3.0-or-later
// The wishes of a room, each once. Whatever says how many there are and how many hold counts these.
import { OutcomeStatus, type EdgeOutcome, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import type { Demand, Note } from "./note";

export interface Wish {
  readonly demand: Demand;
  // The first piece that it is about; empty for one of the room.
  readonly objectId: string;
}

export interface Count {
  readonly held: number;
  readonly asked: number;
}

export const keyOf = ({ demand, objectId }: Wish): string =>
  demand.sentence_id || demand.edge_ids?.join(" ") || `${objectId} ${demand.about_it}`;

export function wishesOf(note: Note): Wish[] {
  const wishes = (note.zones ?? []).flatMap(({ objects = [] }) =>
    objects.flatMap(({ id: objectId, demands = [] }) => demands.map((demand): Wish => ({ demand, objectId }))));
  const ofNone = (note.demands_of_no_object ?? []).map((demand): Wish => ({ demand, objectId: "" }));
  return [...new Map([...wishes, ...ofNone].reverse().map((wish) => [keyOf(wish), wish])).values()].reverse();
}

// What was dropped or not understood does not hold either.
export const isMet = ({ demand }: Wish): boolean => demand.fate === "holds";

export function countOf(note: Note): Count {
  const wishes = wishesOf(note);
  return { held: wishes.filter(isMet).length, asked: wishes.length };
}

// The same of other outcomes of a layout's constraints, of which nothing is told in words.
export function countOfOutcomes({ graph }: SolvedLayout, outcomes: readonly EdgeOutcome[]): Count {
  const missed = new Set(outcomes.filter(({ status }) => status !== OutcomeStatus.SATISFIED).map(({ edgeId }) => edgeId));
  // Each wish with its constraints: a sentence, or a constraint of no sentence.
  const edgesOf = new Map((graph?.constraintList?.sentences ?? []).map(({ id }): [string, string[]] => [id, []]));
  for (const { id, sentenceId } of graph?.edges ?? []) {
    const key = edgesOf.has(sentenceId) ? sentenceId : `edge ${id}`;
    edgesOf.set(key, [...(edgesOf.get(key) ?? []), id]);
  }
  const held = [...edgesOf.values()].filter((edges) => edges.length > 0 && !edges.some((id) => missed.has(id)));
  return { held: held.length, asked: edgesOf.size };
}
