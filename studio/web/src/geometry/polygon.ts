// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons in frame R, counter-clockwise, without a repeated last corner.
import { add, cross, dot, left, sub, times, unit, vec, type Vec } from "./vec";

export interface Box {
  readonly min: Vec;
  readonly max: Vec;
}

export function boxOf(points: readonly Vec[]): Box {
  const xs = points.map((p) => p.x), ys = points.map((p) => p.y);
  return { min: vec(Math.min(...xs), Math.min(...ys)), max: vec(Math.max(...xs), Math.max(...ys)) };
}

export function boxesMeet(a: Box, b: Box): boolean {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

export interface Edge {
  readonly a: Vec;
  readonly b: Vec;
  // Into the polygon.
  readonly inward: Vec;
}

export function edgesOf(polygon: readonly Vec[]): Edge[] {
  return polygon.map((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    return { a, b, inward: left(unit(sub(b, a))) };
  });
}

export function area(polygon: readonly Vec[]): number {
  return polygon.reduce((sum, a, i) => sum + cross(a, polygon[(i + 1) % polygon.length]!), 0) / 2;
}

export function inside(polygon: readonly Vec[], p: Vec): boolean {
  let odd = false;
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    if (a.y > p.y !== b.y > p.y && p.x < a.x + ((p.y - a.y) / (b.y - a.y)) * (b.x - a.x)) odd = !odd;
  });
  return odd;
}

// How far two convex polygons reach into each other, along the edge across which that is least; 0 or less when apart.
export function depthOf(a: readonly Vec[], b: readonly Vec[]): number {
  const across = (one: readonly Vec[], other: readonly Vec[]) => edgesOf(one).map(({ a: from, inward }) =>
    Math.max(...other.map((p) => dot(sub(p, from), inward))));
  return Math.min(...across(a, b), ...across(b, a));
}

// The part of `subject` that lies in the convex polygon `window`; empty when they do not meet.
export function clipped(subject: readonly Vec[], window: readonly Vec[]): Vec[] {
  let rest = [...subject];
  for (const { a, inward } of edgesOf(window)) {
    const depth = (p: Vec) => dot(sub(p, a), inward);
    const kept: Vec[] = [];
    rest.forEach((p, i) => {
      const q = rest[(i + 1) % rest.length]!;
      const dp = depth(p), dq = depth(q);
      if (dp >= 0) kept.push(p);
      if (dp >= 0 !== dq >= 0) kept.push(add(p, times(sub(q, p), dp / (dp - dq))));
    });
    rest = kept;
  }
  return rest;
}
