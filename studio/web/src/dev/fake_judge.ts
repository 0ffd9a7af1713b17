// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of the fake server: walls, clearances and overlaps, roughly.
import { create } from "@bufbuild/protobuf";
import { clearances } from "../geometry/clearance";
import type { Side } from "../geometry/footprint";
import { area, clipped } from "../geometry/polygon";
import { distance, vec } from "../geometry/vec";
import type { ConstraintEdge } from "../gen/flair/v1/layout_graph_pb";
import { FindingKind, FindingSchema, type Finding } from "../gen/flair/v1/layout_metrics_pb";
import {
  EdgeOutcomeSchema,
  OutcomeStatus,
  type EdgeOutcome,
  type SolvedLayout,
} from "../gen/flair/v1/solved_layout_pb";
import { floorOf, footprintOf, guestsOf, isSolid, nameOf, piecesOf, type Piece, type Pieces } from "../state/pieces";

function text(edge: ConstraintEdge, name: string): string {
  const value = edge.arguments.find((one) => one.name === name)?.value?.value;
  return value?.case === "text" ? value.value : "";
}

function number(edge: ConstraintEdge, name: string, otherwise: number): number {
  const value = edge.arguments.find((one) => one.name === name)?.value?.value;
  return value?.case === "number" ? value.value : otherwise;
}

// Metres by which it is missed; at most 0 when it holds.
function missedBy(edge: ConstraintEdge, layout: SolvedLayout, pieces: Pieces): number {
  const piece = pieces.get(text(edge, "object")), other = pieces.get(text(edge, "target"));
  if (!piece) return 0;
  const free = (side: Side, among: Piece[]) => clearances(piece.pose, piece.size, floorOf(layout),
    among.map((one) => ({ id: one.id, polygon: footprintOf(one) }))).find((one) => one.side === side)?.metres ?? 0;
  if (edge.type === "against_wall") return free("back", []) - 0.02;
  if (edge.type === "accessible") {
    const solid = [...pieces.values()].filter(
      (one) => one.id !== piece.id && isSolid(one) && one.object.category !== "chair",
    );
    const sides = edge.arguments.find((one) => one.name === "sides")?.value?.value;
    const asked = sides?.case === "texts" ? sides.value.items as Side[] : [];
    return Math.max(0, ...asked.map((side) => number(edge, "min_clearance_m", 0.6) - 0.15 - free(side, solid)));
  }
  if (!other) return 0;
  const apart = distance(vec(piece.pose.x, piece.pose.y), vec(other.pose.x, other.pose.y));
  if (edge.type === "next_to") return apart - (piece.size.width + other.size.width) / 2 - 0.35;
  if (edge.type === "near") return apart - number(edge, "max_distance_m", 2);
  return 0;
}

function overlaps(pieces: Pieces, ids: ReadonlySet<string>): Finding[] {
  const solid = [...pieces.values()].filter((one) => isSolid(one) && one.object.category !== "chair");
  return solid.flatMap((a, i) => solid.slice(i + 1).flatMap((b) => {
    if (!ids.has(a.id) && !ids.has(b.id)) return [];
    const shared = clipped(footprintOf(a), footprintOf(b));
    if (shared.length < 3 || area(shared) < 1e-4) return [];
    return [create(FindingSchema, {
      kind: FindingKind.OVERLAP, objectId: a.id, partnerId: b.id, amount: Math.sqrt(area(shared)), unit: "m",
      message: `The ${nameOf(a.object)} is in the same place as the ${nameOf(b.object)}`,
    })];
  }));
}

export function judge(
  layout: SolvedLayout,
  about: readonly string[],
): { edgeOutcomes: EdgeOutcome[]; findings: Finding[] } {
  const pieces = piecesOf(layout);
  const ids = new Set([...about, ...guestsOf(pieces, about)]);
  const edgeOutcomes = (layout.graph?.edges ?? [])
    .filter((edge) => ids.has(text(edge, "object")) || ids.has(text(edge, "target"))).map((edge) => {
      const missed = missedBy(edge, layout, pieces);
      const status = missed > 1e-6 ? OutcomeStatus.VIOLATED : OutcomeStatus.SATISFIED;
      const by = missed > 1e-6 ? missed : undefined;
      return create(EdgeOutcomeSchema, {
        edgeId: edge.id, status, missedBy: by, unit: "m", reason: by ? `${by.toFixed(2)} m are missing` : "",
      });
    });
  return { edgeOutcomes, findings: overlaps(pieces, ids) };
}
