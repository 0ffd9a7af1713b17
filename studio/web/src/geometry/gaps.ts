// SPDX-License-Identifier: GPL-3.0-or-later
// How far it is from a box to the walls west and south of it: in an L to the wall that is there, not to the room's end.
import { boxOf, edgesOf, type Box } from "./polygon";
import type { Vec } from "./vec";

// A wall that the box's side merely touches the end of is beside it.
const kGrazing = 0.005;

type Axis = "x" | "y";

const other = (axis: Axis): Axis => (axis === "x" ? "y" : "x");

// The farthest that the wall reaches along the axis beside the box's side; undefined when it is elsewhere.
function reach(a: Vec, b: Vec, { min, max }: Box, axis: Axis): number | undefined {
  const across = other(axis);
  const low = Math.max(Math.min(a[across], b[across]), min[across] + kGrazing);
  const high = Math.min(Math.max(a[across], b[across]), max[across] - kGrazing);
  if (low > high || a[across] === b[across]) return undefined;
  const at = (where: number) => a[axis] + ((b[axis] - a[axis]) * (where - a[across])) / (b[across] - a[across]);
  return Math.max(at(low), at(high));
}

function gapAlong(box: Box, floor: readonly Vec[], axis: Axis): number {
  const middle = (box.min[axis] + box.max[axis]) / 2;
  const walls = edgesOf(floor).filter(({ inward }) => inward[axis] > 1e-6)
    .flatMap(({ a, b }) => reach(a, b, box, axis) ?? []).filter((where) => where < middle);
  return box.min[axis] - (walls.length > 0 ? Math.max(...walls) : boxOf(floor).min[axis]);
}

// Negative where the box is in the wall.
export function gapsOf(box: Box, floor: readonly Vec[]): Vec {
  return { x: gapAlong(box, floor, "x"), y: gapAlong(box, floor, "y") };
}
