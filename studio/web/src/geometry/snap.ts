// SPDX-License-Identifier: GPL-3.0-or-later
// Where something that is dragged comes to rest: at walls, in line with other pieces, on the room's axes.
//
// A candidate asks for an advance d along a direction n. The nearest one is taken, then the nearest in another
// direction, and both are met exactly: corners need no case of their own, nor do walls at an angle.
import { boxesMeet, boxOf, edgesOf } from "./polygon";
import { add, cross, dot, left, length, sub, times, turned, unit, vec, type Vec } from "./vec";

export interface Guide {
  readonly a: Vec;
  readonly b: Vec;
  readonly kind: "wall" | "piece" | "axis";
}

export interface Snap {
  readonly by: Vec;
  readonly guides: readonly Guide[];
}

export interface Moving {
  // Its corners where the pointer wants them.
  readonly polygon: readonly Vec[];
  // Heading of its sides, in line with which others are looked for.
  readonly theta: number;
}

export interface Target {
  readonly id: string;
  readonly polygon: readonly Vec[];
  readonly theta: number;
}

interface Candidate {
  readonly n: Vec;
  readonly d: number;
  // Smaller is preferred: the advance, and a little more for what is less of a reason to stop.
  readonly rank: number;
  guide(at: readonly Vec[]): Guide;
}

// How far into a wall something is pushed before it goes through.
const kStopped = 0.5;
const kTouch = 1e-6;

const kParallel = Math.cos((88.5 * Math.PI) / 180);

function wallCandidates(moving: Moving, floor: readonly Vec[], within: number): Candidate[] {
  return edgesOf(floor).flatMap(({ a, b, inward }) => {
    const d = -Math.min(...moving.polygon.map((p) => dot(sub(p, a), inward)));
    // Walls stop what is pushed into them.
    if (d < -within || d > Math.max(within, kStopped)) return [];
    const along = unit(sub(b, a));
    const spots = moving.polygon.map((p) => dot(sub(p, a), along));
    const long = dot(sub(b, a), along);
    const beside = Math.min(...spots) < long && Math.max(...spots) > 0;
    if (!beside) return [];
    // What is in a wall comes out of it before all else.
    const wall = { n: inward, d, rank: d > kTouch ? -d : Math.abs(d) * 0.8, guide: () => ({ a, b, kind: "wall" as const }) };
    // At a wall, its middle is a place of its own.
    const middle = dot(a, along) + long / 2, toMiddle = middle - spanAlong(moving.polygon, along).mid;
    return Math.abs(toMiddle) > within ? [wall] : [wall, {
      n: along, d: toMiddle, rank: Math.abs(toMiddle) * 0.9,
      guide: (at: readonly Vec[]) => guideAlong(along, middle, at, "axis"),
    }];
  });
}

function spanAlong(points: readonly Vec[], n: Vec): { low: number; mid: number; high: number } {
  const offsets = points.map((p) => dot(p, n));
  const low = Math.min(...offsets), high = Math.max(...offsets);
  return { low, mid: (low + high) / 2, high };
}

// A line along which both lie, from the one to the other and a little beyond.
function guideAlong(n: Vec, offset: number, of: readonly Vec[], kind: Guide["kind"]): Guide {
  const along = left(n);
  const { low, high } = spanAlong(of, along);
  const at = (s: number) => add(times(n, offset), times(along, s));
  return { a: at(low), b: at(high), kind };
}

// Whoever lines things up looks at what is near.
const kNear = 1.2;

function isNear(a: readonly Vec[], b: readonly Vec[]): boolean {
  const { min, max } = boxOf(a);
  return boxesMeet({ min: vec(min.x - kNear, min.y - kNear), max: vec(max.x + kNear, max.y + kNear) }, boxOf(b));
}

function pieceCandidates(moving: Moving, target: Target, within: number): Candidate[] {
  if (!isNear(moving.polygon, target.polygon)) return [];
  const quarter = Math.abs(Math.sin(2 * (moving.theta - target.theta)));
  if (quarter > 2 * kParallel) return [];
  return [turned(vec(1, 0), moving.theta), turned(vec(0, 1), moving.theta)].flatMap((n) => {
    const own = spanAlong(moving.polygon, n), other = spanAlong(target.polygon, n);
    const pairs: Array<[number, number]> = [
      [own.low, other.low], [own.low, other.high], [own.high, other.low], [own.high, other.high], [own.mid, other.mid],
    ];
    return pairs.filter(([from, to]) => Math.abs(to - from) <= within).map(([from, to]) => ({
      n, d: to - from, rank: Math.abs(to - from),
      guide: (at: readonly Vec[]) => guideAlong(n, to, [...at, ...target.polygon], "piece"),
    }));
  });
}

function axisCandidates(moving: Moving, floor: readonly Vec[], within: number): Candidate[] {
  const box = boxOf(floor);
  return [vec(1, 0), vec(0, 1)].flatMap((n) => {
    const to = (dot(box.min, n) + dot(box.max, n)) / 2;
    const d = to - spanAlong(moving.polygon, n).mid;
    if (Math.abs(d) > within) return [];
    return [{ n, d, rank: Math.abs(d) * 1.1, guide: () => guideAlong(n, to, floor, "axis") }];
  });
}

const byRank = (a: Candidate, b: Candidate) => a.rank - b.rank;

// How far to move beyond where the pointer wants it, and why. `within` is the catch, in metres.
export function snapped(moving: Moving, floor: readonly Vec[], targets: readonly Target[], within: number): Snap {
  const candidates = [
    ...wallCandidates(moving, floor, within),
    ...targets.flatMap((target) => pieceCandidates(moving, target, within)),
    ...axisCandidates(moving, floor, within),
  ].sort(byRank);
  const first = candidates[0];
  if (!first) return { by: vec(0, 0), guides: [] };
  const second = candidates.find((one) => Math.abs(cross(first.n, one.n)) > 0.3);
  const by = second ? meeting(first, second) : times(first.n, first.d);
  const taken = second && length(by) <= 2 * within ? [first, second] : [first];
  const shift = taken.length === 2 ? by : times(first.n, first.d);
  const rest = moving.polygon.map((p) => add(p, shift));
  return { by: shift, guides: taken.map((one) => one.guide(rest)) };
}

// The t with n1.t = d1 and n2.t = d2.
function meeting(one: Candidate, other: Candidate): Vec {
  const det = cross(one.n, other.n);
  return vec((one.d * other.n.y - other.d * one.n.y) / det, (other.d * one.n.x - one.d * other.n.x) / det);
}

// The nearest multiple of `step` when it is nearer than `within`, else the angle itself.
export function snappedAngle(angle: number, step: number, within: number): number {
  const nearest = Math.round(angle / step) * step;
  return Math.abs(nearest - angle) <= within ? nearest : angle;
}
