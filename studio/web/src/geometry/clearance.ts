// SPDX-License-Identifier: GPL-3.0-or-later
// How far it is from each side of a piece straight ahead to the nearest wall or piece. A piece that is parallel to no wall
// is measured as on a drawing: from its outermost corners, square to the room.
import { corners, extent, middleOf, moved, normalOf, sides, type Pose, type Side, type Size } from "./footprint";
import { boxOf, clipped, edgesOf } from "./polygon";
import { add, distance, dot, left, sub, times, turned, type Vec } from "./vec";

export interface Obstacle {
  readonly id: string;
  // Counter-clockwise and convex.
  readonly polygon: readonly Vec[];
}

export interface Clearance {
  // "front", or "north" of a piece that is parallel to no wall.
  readonly side: string;
  // Away from the piece, of length 1.
  readonly ahead: Vec;
  readonly metres: number;
  readonly from: Vec;
  readonly to: Vec;
  // What is met, where that is not straight ahead of `from`: a line from there leads to it.
  readonly met: Vec;
  // The piece that is met; empty for a wall.
  readonly target: string;
}

// What merely touches the edge of the strip is beside the piece, not before it.
const kGrazing = 0.005;
const kFar = 100;

interface Hit {
  readonly metres: number;
  // From where to where it is met, across the strip.
  readonly low: number;
  readonly high: number;
}

// The smallest advance along the strip at which it meets the points, or none.
function nearest(points: readonly Vec[], { origin, ahead, across }: Strip): Hit | undefined {
  if (points.length === 0) return undefined;
  const spots = points.map((p) => ({ metres: dot(sub(p, origin), ahead), across: dot(sub(p, origin), across) }));
  const metres = Math.min(...spots.map((spot) => spot.metres));
  const met = spots.filter((spot) => spot.metres < metres + kGrazing).map((spot) => spot.across);
  return { metres, low: Math.min(...met), high: Math.max(...met) };
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

const kCompass: Record<Side, string> = { front: "north", left: "west", back: "south", right: "east" };

// Headings that differ by less are the same to the eye.
const kParallel = Math.PI / 360;

const offQuarter = (angle: number): number => Math.abs(angle - Math.round(angle / (Math.PI / 2)) * (Math.PI / 2));

// Along which axes a piece is measured: its own where a wall is parallel to it, else those of the room's longest wall.
export function measuredAlong(theta: number, floor: readonly Vec[]): number {
  const walls = edgesOf(floor).map(({ a, b }) => ({ long: distance(a, b), angle: Math.atan2(b.y - a.y, b.x - a.x) }));
  if (walls.length === 0 || walls.some(({ angle }) => offQuarter(theta - angle) < kParallel)) return theta;
  const { angle } = walls.reduce((longest, one) => (one.long > longest.long + 1e-6 ? one : longest));
  return angle - Math.round(angle / (Math.PI / 2)) * (Math.PI / 2);
}

// What is measured from: the sides of the piece, or of the box around it, and the points at which lines begin.
function outlineOf(pose: Pose, size: Size, floor: readonly Vec[]) {
  const theta = measuredAlong(pose.theta, floor);
  if (theta === pose.theta) return { pose, size, nameOf: (side: Side) => side as string, begin: undefined };
  const outline = corners(pose, size);
  const { min, max } = boxOf(outline.map((p) => turned(p, -theta)));
  const box = { width: max.x - min.x, depth: max.y - min.y };
  const begin = (ahead: Vec) => outline.reduce((best, p) => (dot(p, ahead) > dot(best, ahead) + 1e-9 ? p : best));
  return { pose: { ...pose, theta }, size: box, nameOf: (side: Side) => kCompass[side], begin };
}

export function clearances(pose: Pose, size: Size, floor: readonly Vec[], pieces: readonly Obstacle[]): Clearance[] {
  const obstacles = [...wallObstacles(floor), ...pieces];
  const outline = outlineOf(pose, size, floor);
  return sides.flatMap((side) => {
    const strip = stripBefore(outline.pose, outline.size, side);
    let best: (Hit & { target: string }) | undefined;
    const half = extent(outline.size, side) / 2;
    for (const { id, polygon } of obstacles) {
      if (!isBefore(polygon, strip, half)) continue;
      const hit = nearest(clipped(polygon, strip.polygon), strip);
      if (hit && (!best || hit.metres < best.metres - 1e-9)) best = { ...hit, target: id };
    }
    if (!best) return [];
    const { target, low, high } = best, { ahead } = strip, metres = Math.max(best.metres, 0);
    const from = outline.begin?.(ahead) ?? strip.origin;
    const to = add(from, times(ahead, metres));
    const beside = dot(sub(from, strip.origin), strip.across);
    const met = add(to, times(strip.across, Math.min(Math.max(beside, low), high) - beside));
    return [{ side: outline.nameOf(side), ahead, metres, from, to, met, target }];
  });
}

// The pose at which the side has that much clearance.
export function withClearance(pose: Pose, { ahead, metres: now }: Clearance, metres: number): Pose {
  return moved(pose, times(ahead, now - metres));
}
