// SPDX-License-Identifier: GPL-3.0-or-later
// How far it is from each side of a piece straight ahead to the nearest wall or piece.
import { extent, middleOf, normalOf, sides, type Pose, type Side, type Size } from "./footprint";
import { clipped, edgesOf } from "./polygon";
import { add, dot, left, sub, times, type Vec } from "./vec";

export interface Obstacle {
  readonly id: string;
  // Counter-clockwise and convex.
  readonly polygon: readonly Vec[];
}

export interface Clearance {
  readonly side: Side;
  readonly metres: number;
  readonly from: Vec;
  readonly to: Vec;
  // The piece that is met; empty for a wall.
  readonly target: string;
}

// What merely touches the edge of the strip is beside the piece, not before it.
const kGrazing = 0.005;
const kFar = 100;

// The smallest advance along the strip at which it meets the points, or none.
function nearest(points: readonly Vec[], strip: Strip): { metres: number; across: number } | undefined {
  let best: { metres: number; across: number } | undefined;
  for (const p of points) {
    const metres = dot(sub(p, strip.origin), strip.ahead);
    if (!best || metres < best.metres - 1e-9) best = { metres, across: dot(sub(p, strip.origin), strip.across) };
  }
  return best;
}

interface Strip {
  readonly origin: Vec;
  readonly ahead: Vec;
  readonly across: Vec;
  readonly polygon: Vec[];
}

function stripBefore(pose: Pose, size: Size, side: Side): Strip {
  const ahead = normalOf(pose, side);
  const across = left(ahead);
  const origin = middleOf(pose, size, side);
  const half = Math.max(extent(size, side) / 2 - kGrazing, kGrazing);
  const back = add(origin, times(ahead, -kGrazing)), far = add(origin, times(ahead, kFar));
  const at = (end: Vec, shift: number) => add(end, times(across, shift));
  return { origin, ahead, across, polygon: [at(back, half), at(back, -half), at(far, -half), at(far, half)] };
}

// Whether the points may be before the side at all; most are not, and are not cut.
function isBefore(points: readonly Vec[], { origin, ahead, across }: Strip, half: number): boolean {
  const along = (n: Vec) => points.map((p) => dot(sub(p, origin), n));
  const sideways = along(across);
  return Math.max(...along(ahead)) > -kGrazing && Math.min(...sideways) < half && Math.max(...sideways) > -half;
}

// Walls as slivers outside of the floor, so that they are obstacles like any other.
function wallObstacles(floor: readonly Vec[]): Obstacle[] {
  return edgesOf(floor).map(({ a, b, inward }) => {
    const out = times(inward, -0.25);
    return { id: "", polygon: [b, a, add(a, out), add(b, out)] };
  });
}

export function clearances(pose: Pose, size: Size, floor: readonly Vec[], pieces: readonly Obstacle[]): Clearance[] {
  const obstacles = [...wallObstacles(floor), ...pieces];
  return sides.flatMap((side) => {
    const strip = stripBefore(pose, size, side);
    let best: { metres: number; across: number; target: string } | undefined;
    const half = extent(size, side) / 2;
    for (const { id, polygon } of obstacles) {
      if (!isBefore(polygon, strip, half)) continue;
      const hit = nearest(clipped(polygon, strip.polygon), strip);
      if (hit && (!best || hit.metres < best.metres - 1e-9)) best = { ...hit, target: id };
    }
    if (!best) return [];
    const metres = Math.max(best.metres, 0);
    return [
      { side, metres, from: strip.origin, to: add(strip.origin, times(strip.ahead, metres)), target: best.target },
    ];
  });
}

// The pose at which the side has that much clearance.
export function withClearance(pose: Pose, clearance: Clearance, metres: number): Pose {
  const by = times(normalOf(pose, clearance.side), clearance.metres - metres);
  return { x: pose.x + by.x, y: pose.y + by.y, theta: pose.theta };
}

