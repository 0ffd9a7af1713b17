// SPDX-License-Identifier: GPL-3.0-or-later
// Where the next corner comes while walls are drawn.
import { add, cross, distance, dot, left, sub, times, unit, vec, type Vec } from "../geometry/vec";

export interface PenPoint {
  readonly at: Vec;
  // Corners that it is in line with.
  readonly inLine: readonly Vec[];
  // It is the first corner: the walls close.
  readonly closes: boolean;
}

export interface PenOptions {
  // Catch of corners and lines, metres.
  readonly within: number;
  // No right angles, no steps.
  readonly isFree: boolean;
  // Lengths are whole multiples of it.
  readonly step: number;
}

const kAxes = [vec(1, 0), vec(0, 1), vec(-1, 0), vec(0, -1)];

// Along the axes, and along and across the last wall.
export function directionsAt(corners: readonly Vec[]): Vec[] {
  if (corners.length < 2) return kAxes;
  const d = unit(sub(corners.at(-1)!, corners.at(-2)!));
  const isUpright = Math.min(Math.abs(d.x), Math.abs(d.y)) < 1e-6;
  return isUpright ? kAxes : [...kAxes, d, left(d), times(d, -1), times(left(d), -1)];
}

export function nearestDirection(corners: readonly Vec[], wanted: Vec): Vec {
  return directionsAt(corners).reduce((best, d) => (dot(unit(wanted), d) > dot(unit(wanted), best) ? d : best));
}

const rounded = (metres: number, step: number) => Math.round(metres / step) * step;

export function penAt(corners: readonly Vec[], pointer: Vec, { within, isFree, step }: PenOptions): PenPoint {
  const first = corners[0],
    last = corners.at(-1);
  if (first && corners.length >= 3 && distance(pointer, first) < within * 1.5)
    return { at: first, inLine: [], closes: true };
  if (isFree) return { at: pointer, inLine: [], closes: false };
  if (!last) return { at: vec(rounded(pointer.x, step), rounded(pointer.y, step)), inLine: [], closes: false };
  const d = nearestDirection(corners, sub(pointer, last));
  const wanted = dot(sub(pointer, last), d);
  // In line with another corner across the wall under way.
  const lines = corners
    .slice(0, -1)
    .map((c) => ({ c, t: dot(sub(c, last), d) }))
    .filter(({ t }) => t > within && Math.abs(t - wanted) < within)
    .sort((one, other) => Math.abs(one.t - wanted) - Math.abs(other.t - wanted));
  const t = lines[0]?.t ?? rounded(wanted, step);
  const at = add(last, times(d, t));
  const inLine = lines.filter((one) => Math.abs(one.t - t) < 1e-6).map(({ c }) => c);
  return { at: { x: Math.round(at.x * 1e4) / 1e4, y: Math.round(at.y * 1e4) / 1e4 }, inLine, closes: false };
}

// A corner that is dragged: in line with its neighbours and all others, else on whole multiples of `step`.
export function settledCorner(others: readonly Vec[], pointer: Vec, { within, isFree, step }: PenOptions): PenPoint {
  if (isFree) return { at: pointer, inLine: [], closes: false };
  const nearest = (axis: "x" | "y") =>
    others
      .filter((c) => Math.abs(c[axis] - pointer[axis]) < within)
      .sort((a, b) => Math.abs(a[axis] - pointer[axis]) - Math.abs(b[axis] - pointer[axis]))[0];
  const x = nearest("x"),
    y = nearest("y");
  const at = vec(x?.x ?? rounded(pointer.x, step), y?.y ?? rounded(pointer.y, step));
  return { at, inLine: [x, y].filter((one) => one !== undefined), closes: false };
}

// Whether two segments share a point.
export function segmentsMeet(a: Vec, b: Vec, c: Vec, d: Vec): boolean {
  const side = (p: Vec, q: Vec, r: Vec) => Math.sign(Math.round(cross(sub(q, p), sub(r, p)) * 1e7));
  const within = (p: Vec, q: Vec, r: Vec) => dot(sub(r, p), sub(r, q)) <= 1e-9;
  const s1 = side(a, b, c),
    s2 = side(a, b, d),
    s3 = side(c, d, a),
    s4 = side(c, d, b);
  if (s1 !== s2 && s3 !== s4) return true;
  return (
    (s1 === 0 && within(a, b, c)) ||
    (s2 === 0 && within(a, b, d)) ||
    (s3 === 0 && within(c, d, a)) ||
    (s4 === 0 && within(c, d, b))
  );
}
