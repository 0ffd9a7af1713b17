// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lengths of walls are written, outside of the room.
import { edgesOf } from "./polygon";
import { dot, left, sub, type Vec } from "./vec";

const kSame = 1e-3;

// How much farther out than its wall each length goes, metres: where a room goes back behind a corner the length would run
// through the next wall, so that it goes beyond all walls, in line with those of the others, unless one of them is there.
export function sizeShifts(floor: readonly Vec[]): number[] {
  const edges = edgesOf(floor);
  const isInner = edges.map(({ inward }, i) => dot(left(inward), edges[(i + edges.length - 1) % edges.length]!.inward) > kSame);
  return edges.map(({ a, b, inward }, i) => {
    if (!isInner[i] && !isInner[(i + 1) % edges.length]) return 0;
    const depth = (p: Vec) => -dot(sub(p, a), inward), along = (p: Vec) => dot(sub(p, a), sub(b, a));
    const isBefore = (one: { a: Vec; b: Vec; inward: Vec }) => {
      const from = Math.min(along(one.a), along(one.b)), to = Math.max(along(one.a), along(one.b));
      return dot(one.inward, inward) > 0.9 && depth(one.a) > kSame && from < along(b) - kSame && to > kSame;
    };
    return edges.some(isBefore) ? 0 : Math.max(0, ...floor.map(depth));
  });
}
