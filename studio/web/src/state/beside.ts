// SPDX-License-Identifier: GPL-3.0-or-later
// Where the copy of pieces has room.
import { moved } from "../geometry/footprint";
import { boxOf, depthOf, inside } from "../geometry/polygon";
import { vec, type Vec } from "../geometry/vec";
import { footprintOf, isSolid, type Piece, type Pieces } from "./pieces";

const kGap = 0.05;
// Less is a touch, and a corner on a wall is in the room.
const kTouch = 0.005;

// The way to the nearest of the four places beside the pieces at which nothing stands; undefined when all are taken, and for
// what may lie or stand anywhere.
export function freeBeside(pieces: Pieces, copied: readonly Piece[], floor: readonly Vec[]): Vec | undefined {
  const solid = copied.filter(isSolid);
  if (solid.length === 0) return undefined;
  const { min, max } = boxOf(solid.flatMap((piece) => footprintOf(piece)));
  const x = max.x - min.x + kGap, y = max.y - min.y + kGap;
  const isIn = (p: Vec) => [vec(-kTouch, 0), vec(kTouch, 0), vec(0, -kTouch), vec(0, kTouch)]
    .some((by) => inside(floor, vec(p.x + by.x, p.y + by.y)));
  const isFree = (by: Vec) => solid.every((piece) => {
    const there = footprintOf(piece, moved(piece.pose, by));
    return there.every(isIn) &&
      [...pieces.values()].every((other) => !isSolid(other) || depthOf(there, footprintOf(other)) < kTouch);
  });
  return [vec(x, 0), vec(-x, 0), vec(0, -y), vec(0, y)].sort((a, b) => Math.hypot(a.x, a.y) - Math.hypot(b.x, b.y)).find(isFree);
}
