// SPDX-License-Identifier: GPL-3.0-or-later
// Where something that has its back to a wall goes: along the wall that is meant, with its back to it.
import { edgesOf, type Edge } from "./polygon";
import { add, cross, dot, length, sub, times, turned, unit, vec, type Vec } from "./vec";
import { corners, type Pose, type Size } from "./footprint";
import type { Guide, Target } from "./snap";

export interface Mounted {
  readonly pose: Pose;
  readonly guides: readonly Guide[];
}

// What stands so near to a wall has something hung above it, in line with its middle.
const kBelow = 0.8;

// Where middles are caught along a wall: its own, and of what stands before it.
function marksOn({ a, b, inward }: Edge, targets: readonly Target[]): number[] {
  const along = unit(sub(b, a)), long = dot(sub(b, a), along);
  const below = targets.flatMap(({ polygon }) => {
    const spots = polygon.map((p) => dot(sub(p, a), along)), away = polygon.map((p) => dot(sub(p, a), inward));
    const middle = (Math.min(...spots) + Math.max(...spots)) / 2;
    return Math.min(...away) < kBelow && Math.max(...away) > 0 && middle > 0 && middle < long ? [middle] : [];
  });
  return [...below, long / 2];
}

const thetaAt = (inward: Vec): number => Math.atan2(-inward.x, inward.y);

// `at` is where the pointer wants its middle. On a wall that is shorter than the piece it hangs in the middle; within
// `within` of the middle of what stands below, it hangs in line with that.
export function mounted(
  at: Vec,
  { width, depth }: Size,
  floor: readonly Vec[],
  targets: readonly Target[] = [],
  within = 0,
): Mounted | undefined {
  let nearest: { away: number; foot: Vec; edge: Edge } | undefined;
  for (const edge of edgesOf(floor)) {
    const { a, b } = edge, along = unit(sub(b, a)), long = length(sub(b, a)), half = Math.min(width, long) / 2;
    const spot = dot(sub(at, a), along);
    const mark = marksOn(edge, targets).find((one) => Math.abs(one - spot) <= within) ?? spot;
    const footAt = (where: number) => add(a, times(along, Math.min(Math.max(where, half), long - half)));
    const away = length(sub(at, footAt(spot)));
    if (!nearest || away < nearest.away) nearest = { away, foot: footAt(mark), edge };
  }
  if (!nearest) return undefined;
  const { foot, edge: { a, b, inward } } = nearest;
  const { x, y } = add(foot, times(inward, depth / 2));
  const spot = dot(sub(foot, a), unit(sub(b, a)));
  const isInLine = within > 0 && marksOn(nearest.edge, targets).some((one) => Math.abs(one - spot) < 1e-6);
  const middle: Guide = { a: foot, b: add(foot, times(inward, kBelow + depth)), kind: "piece" };
  return {
    pose: { x, y, theta: thetaAt(inward) },
    guides: [{ a, b, kind: "wall" }, ...(isInLine ? [middle] : [])],
  };
}

// Nearer than this and as parallel as that, a back is at its wall.
const kAtWall = 0.15;
const kParallel = Math.sin((5 * Math.PI) / 180);
// How far into a wall something may be pushed and still be meant to stand at it.
const kStopped = 0.5;

const isBackTo = (theta: number, { inward }: Edge): boolean => {
  const front = turned(vec(0, 1), theta);
  return dot(front, inward) > 0 && Math.abs(cross(front, inward)) < kParallel;
};

// How far it is from a wall, if it is beside it at all.
function gapTo({ a, b, inward }: Edge, polygon: readonly Vec[], at: Vec): number | undefined {
  const along = unit(sub(b, a)), spot = dot(sub(at, a), along);
  return spot > 0 && spot < dot(sub(b, a), along) ? Math.min(...polygon.map((p) => dot(sub(p, a), inward))) : undefined;
}

// Whether its back is at a wall.
export function isBacked(pose: Pose, size: Size, floor: readonly Vec[]): boolean {
  return edgesOf(floor).some((edge) => {
    const gap = gapTo(edge, corners(pose, size), pose);
    return isBackTo(pose.theta, edge) && gap !== undefined && Math.abs(gap) < kAtWall;
  });
}

// The same piece out of the walls that it has been turned into.
export function heldInside(pose: Pose, size: Size, floor: readonly Vec[]): Pose {
  const reach = Math.max(size.width, size.depth);
  return edgesOf(floor).reduce((at, edge) => {
    const gap = gapTo(edge, corners(at, size), at);
    return gap !== undefined && gap < 0 && gap > -reach ? { ...at, ...add(at, times(edge.inward, -gap)) } : at;
  }, pose);
}

// The same piece with its back to the wall that it has been brought to; as it is where its back is at a wall already, or
// where there is none within reach.
export function turnedToWall(pose: Pose, size: Size, floor: readonly Vec[], within: number): Pose {
  const polygon = corners(pose, size);
  const reached = edgesOf(floor).flatMap((edge) => {
    const gap = gapTo(edge, polygon, pose);
    return gap !== undefined && gap <= within && gap >= -Math.max(kStopped, size.width / 2) ? [{ edge, gap }] : [];
  });
  if (reached.length === 0 || reached.some(({ edge }) => isBackTo(pose.theta, edge))) return pose;
  const { edge: { a, inward } } = reached.reduce((best, one) => (one.gap < best.gap ? one : best));
  const shift = size.depth / 2 - dot(sub(pose, a), inward);
  return { ...add(pose, times(inward, shift)), theta: thetaAt(inward) };
}
