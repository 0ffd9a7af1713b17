// SPDX-License-Identifier: GPL-3.0-or-later
// The layouts of a design that was made in several variants: the first, and its complete runner-ups in TakeVariant's
// order.
import { ArtifactKind } from "../gen/flair/v1/artifact_pb";
import type { Placement } from "../gen/flair/v1/placement_pb";
import { OutcomeStatus, type EdgeOutcome, type SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";
import type { Clients } from "../api/clients";
import { turnBetween } from "../geometry/vec";

export interface Variant {
  // For TakeVariant; -1 is the first layout, which is none of the others.
  readonly index: number;
  readonly placements: readonly Placement[];
  readonly held: number;
  readonly asked: number;
  // Share of the floor within reach.
  readonly floor?: number;
}

export interface Variants {
  // Of the artifact that has them all.
  readonly layoutId: string;
  readonly layout: SolvedLayout;
  readonly list: readonly Variant[];
}

function counted(outcomes: readonly EdgeOutcome[]): { held: number; asked: number } {
  const held = outcomes.filter(({ status }) => status === OutcomeStatus.SATISFIED).length;
  const missed = outcomes.filter(({ status }) => status === OutcomeStatus.VIOLATED).length;
  return { held, asked: held + missed };
}

export function variantsOf(layoutId: string, layout: SolvedLayout): Variants {
  const complete = layout.runnerUps.filter(({ edgeOutcomes }) => edgeOutcomes.length > 0);
  const list = [layout, ...complete].map((one, i): Variant => ({
    index: i - 1,
    placements: one.placements,
    ...counted(one.edgeOutcomes),
    floor: one.metrics?.reachableFloorShare,
  }));
  return { layoutId, layout, list };
}

// Whether everything stands as there.
export function isSame(a: readonly Placement[], b: readonly Placement[]): boolean {
  const others = new Map(b.map((one) => [one.objectId, one]));
  return (
    a.length === b.length &&
    a.every((one) => {
      const other = others.get(one.objectId);
      if (!other) return false;
      const turn = turnBetween(one.thetaRad, other.thetaRad);
      return Math.hypot(one.xM - other.xM, one.yM - other.yM) < 2e-3 && Math.abs(turn) < 2e-3;
    })
  );
}

async function layoutIdOf(clients: Clients, { jobId, layoutId }: Document): Promise<string> {
  if (!jobId) return layoutId;
  const { job } = await clients.orchestrator.getJob({ jobId });
  return job?.artifacts.find(({ kind }) => kind === ArtifactKind.SOLVED_LAYOUT)?.id ?? layoutId;
}

// Undefined when the artifact that has them is not there any more.
export async function fetchVariants(clients: Clients, document: Document): Promise<Variants | undefined> {
  const id = await layoutIdOf(clients, document);
  const content = (await clients.orchestrator.getArtifact({ artifactId: id })).artifact?.content;
  return content?.case === "solvedLayout" && content.value.runnerUps.length > 0
    ? variantsOf(id, content.value)
    : undefined;
}
