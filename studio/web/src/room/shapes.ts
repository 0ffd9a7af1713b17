// SPDX-License-Identifier: GPL-3.0-or-later
// Doors, windows and sockets as a plan draws them, in room coordinates.
import { add, sub, times, turned, type Vec } from "../geometry/vec";
import type { Door, Fixture, WallLine } from "./sketch";

// As thick as walls are drawn; nothing is made of it.
export const kWallThickness = 0.14;

const kArcSteps = 14;

export interface Span {
  readonly start: Vec;
  readonly end: Vec;
  // The gap in the wall.
  readonly gap: readonly Vec[];
}

export function spanOf(fixture: Exclude<Fixture, { kind: "socket" }>, wall: WallLine): Span {
  const start = add(wall.a, times(wall.along, fixture.offset)),
    end = add(start, times(wall.along, fixture.width));
  const out = times(wall.inward, -kWallThickness);
  return { start, end, gap: [start, end, add(end, out), add(start, out)] };
}

// The open leaf and the way of its free end; undefined for doors that do not swing.
export function leafOf(door: Door, wall: WallLine): { hinge: Vec; tip: Vec; arc: readonly Vec[] } | undefined {
  if (door.swing !== "inward" && door.swing !== "outward") return undefined;
  const { start, end } = spanOf(door, wall);
  const isAtStart = door.hinge === "start";
  const hinge = isAtStart ? start : end,
    closed = isAtStart ? sub(end, start) : sub(start, end);
  const side = door.swing === "inward" ? wall.inward : times(wall.inward, -1);
  // Towards that side, whichever way the wall runs.
  const sign = closed.x * side.y - closed.y * side.x > 0 ? 1 : -1;
  const arc = Array.from({ length: kArcSteps + 1 }, (_, i) =>
    add(hinge, turned(closed, (sign * door.angle * i) / kArcSteps)),
  );
  return { hinge, tip: arc.at(-1)!, arc };
}
