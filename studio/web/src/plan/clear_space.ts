// SPDX-License-Identifier: GPL-3.0-or-later
// The floor that a constraint wants free before sides of a piece.
import { sides as allSides, toRoom, type Pose, type Side, type Size } from "../geometry/footprint";
import { vec, type Vec } from "../geometry/vec";
import type { ConstraintEdge } from "../gen/flair/v1/layout_graph_pb";

export interface ClearSpace {
  readonly objectId: string;
  readonly sides: readonly Side[];
  readonly metres: number;
}

// What an edge asks for; undefined for edges that ask for no free floor.
export function clearSpaceOf(edge: ConstraintEdge): ClearSpace | undefined {
  let objectId = "", metres = 0, sides: readonly Side[] = [];
  for (const { name, value } of edge.arguments) {
    const one = value?.value;
    if (one?.case === "text" && name === "object") objectId = one.value;
    if (one?.case === "number" && name === "min_clearance_m") metres = one.value;
    if (one?.case === "texts" && name === "sides") sides = allSides.filter((side) => one.value.items.includes(side));
  }
  return objectId && metres > 0 && sides.length > 0 ? { objectId, sides, metres } : undefined;
}

// The strip before a side, that deep.
export function stripBeside(pose: Pose, { width, depth }: Size, side: Side, metres: number): Vec[] {
  const w = width / 2, d = depth / 2;
  const [x0, x1, y0, y1] = {
    front: [-w, w, d, d + metres], back: [-w, w, -d - metres, -d],
    left: [-w - metres, -w, -d, d], right: [w, w + metres, -d, d],
  }[side] as [number, number, number, number];
  return [vec(x0, y0), vec(x1, y0), vec(x1, y1), vec(x0, y1)].map((p) => toRoom(pose, p));
}
