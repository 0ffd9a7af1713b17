// SPDX-License-Identifier: GPL-3.0-or-later
import { clearances, type Clearance } from "../geometry/clearance";
import { footprintOf, guestsOf, isOnFloor, isSolid, type Piece } from "../state/pieces";
import type { PlanController } from "./controller";

// Of the one piece that is selected, where it is seen; none for several and for what does not stand on the floor.
export function shownClearances(plan: PlanController): { piece: Piece; list: Clearance[] } | undefined {
  const [piece, ...others] = plan.chosen.value;
  if (!piece || others.length > 0 || !isOnFloor(piece)) return undefined;
  const { room } = plan;
  const pieces = room.pieces.value;
  const own = new Set([piece.id, ...guestsOf(pieces, [piece.id])]);
  const obstacles = [...pieces.values()].filter((one) => isSolid(one) && !own.has(one.id))
    .map((one) => ({ id: one.id, polygon: footprintOf(one, room.poseOf(one.id)) }));
  const pose = room.poseOf(piece.id) ?? piece.pose;
  return { piece, list: clearances(pose, piece.size, room.floor.value, obstacles) };
}
