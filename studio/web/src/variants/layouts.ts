// SPDX-License-Identifier: GPL-3.0-or-later
// The layouts of one room that can be taken: the first, and its complete runner-ups in TakeVariant's order.
import { equals } from "@bufbuild/protobuf";
import { RoomSchema } from "../gen/flair/v1/room_pb";
import type { Placement } from "../gen/flair/v1/placement_pb";
import type { SolvedLayout } from "../gen/flair/v1/solved_layout_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";
import type { Clients } from "../api/clients";
import { turnBetween } from "../geometry/vec";
import { countOfOutcomes } from "../inspector/wish_list";

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

export function variantsOf(layoutId: string, layout: SolvedLayout): Variants {
  const complete = layout.runnerUps.filter(({ edgeOutcomes }) => edgeOutcomes.length > 0);
  const list = [layout, ...complete].map((one, i): Variant => ({
    index: i - 1,
    placements: one.placements,
    ...countOfOutcomes(layout, one.edgeOutcomes),
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

// What of the room has changed since, so that a variant does not have it; empty when nothing has.
export function changedSince({ layout }: Variants, shown: SolvedLayout | undefined): "" | "walls" | "pieces" {
  const before = layout.graph?.room, now = shown?.graph?.room;
  if (before && now && !equals(RoomSchema, before, now)) return "walls";
  const sizes = (of: SolvedLayout | undefined) => (of?.graph?.objectList?.objects ?? [])
    .map(({ id, widthM, depthM }) => `${id} ${widthM} ${depthM}`).sort().join("\n");
  return sizes(layout) === sizes(shown) ? "" : "pieces";
}

export async function fetchVariants(clients: Clients, document: Document): Promise<Variants | undefined> {
  const { id: documentId, variantsLayoutId: layoutId } = document;
  const { layout } = await clients.studio.getDocument({ documentId, layoutId });
  return layout && layout.runnerUps.length > 0 ? variantsOf(layoutId, layout) : undefined;
}
