// SPDX-License-Identifier: GPL-3.0-or-later
// Points and directions of room frame R: x east, y north, metres, angles counter-clockwise.

export interface Vec {
  readonly x: number;
  readonly y: number;
}

export const vec = (x: number, y: number): Vec => ({ x, y });
export const add = (a: Vec, b: Vec): Vec => ({ x: a.x + b.x, y: a.y + b.y });
export const sub = (a: Vec, b: Vec): Vec => ({ x: a.x - b.x, y: a.y - b.y });
export const times = (a: Vec, k: number): Vec => ({ x: a.x * k, y: a.y * k });
export const dot = (a: Vec, b: Vec): number => a.x * b.x + a.y * b.y;
export const cross = (a: Vec, b: Vec): number => a.x * b.y - a.y * b.x;
export const length = (a: Vec): number => Math.hypot(a.x, a.y);
export const distance = (a: Vec, b: Vec): number => Math.hypot(a.x - b.x, a.y - b.y);
export const middle = (a: Vec, b: Vec): Vec => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
// A quarter turn counter-clockwise.
export const left = (a: Vec): Vec => ({ x: -a.y, y: a.x });

export function unit(a: Vec): Vec {
  const size = length(a);
  return size > 0 ? times(a, 1 / size) : a;
}

export function turned(a: Vec, angle: number): Vec {
  const c = Math.cos(angle), s = Math.sin(angle);
  return { x: c * a.x - s * a.y, y: s * a.x + c * a.y };
}

// The same angle in [0, 2 pi).
export function wrapped(angle: number): number {
  const turn = 2 * Math.PI;
  const rest = angle % turn;
  const positive = rest < 0 ? rest + turn : rest;
  return positive >= turn ? 0 : positive;
}

// How far it is from one heading to another, the shorter way around, (-pi, pi].
export const turnBetween = (from: number, to: number): number => wrapped(to - from + Math.PI) - Math.PI;

// The point of segment ab that is nearest to p.
export function nearestOnSegment(p: Vec, a: Vec, b: Vec): Vec {
  const along = sub(b, a);
  const size = dot(along, along);
  const t = size > 0 ? Math.min(1, Math.max(0, dot(sub(p, a), along) / size)) : 0;
  return add(a, times(along, t));
}
