// SPDX-License-Identifier: GPL-3.0-or-later
// Where something that hangs on a wall goes: along the wall that is nearest, with its back to it.
import { edgesOf } from "./polygon";
import { add, dot, length, sub, times, unit, type Vec } from "./vec";
import type { Pose } from "./footprint";

export interface Mounted {
  readonly pose: Pose;
  // The wall that it hangs on.
  readonly a: Vec;
  readonly b: Vec;
}

// `at` is where the pointer wants its middle. On a wall that is shorter than the piece it hangs in the middle.
export function mounted(at: Vec, width: number, depth: number, floor: readonly Vec[]): Mounted | undefined {
  let nearest: { away: number; mounted: Mounted } | undefined;
  for (const { a, b, inward } of edgesOf(floor)) {
    const along = unit(sub(b, a)), long = length(sub(b, a));
    const half = Math.min(width, long) / 2;
    const foot = add(a, times(along, Math.min(Math.max(dot(sub(at, a), along), half), long - half)));
    const away = length(sub(at, foot));
    if (nearest && nearest.away <= away) continue;
    const { x, y } = add(foot, times(inward, depth / 2));
    nearest = { away, mounted: { pose: { x, y, theta: Math.atan2(-inward.x, inward.y) }, a, b } };
  }
  return nearest?.mounted;
}
