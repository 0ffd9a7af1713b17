// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that go from where they were seen to where they now stand.
import { turnBetween } from "../geometry/vec";
import type { Pose } from "../geometry/footprint";
import type { Poses } from "./pieces";

const kMilliseconds = 260;

export const easeOut = (t: number): number => 1 - (1 - t) ** 3;

// The shorter way around.
export function between(from: Pose, to: Pose, t: number): Pose {
  const theta = from.theta + turnBetween(from.theta, to.theta) * t;
  return { x: from.x + (to.x - from.x) * t, y: from.y + (to.y - from.y) * t, theta };
}

export function differs(a: Pose, b: Pose): boolean {
  return [a.x - b.x, a.y - b.y, turnBetween(a.theta, b.theta)].some((by) => Math.abs(by) > 1e-4);
}

function wantsStillness(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

// Calls `show` with poses on the way of all that differs, and `done` when they are there. Returns how to end it.
export function animate(from: Poses, to: Poses, show: (poses: Poses) => void, done: () => void): () => void {
  const moving = [...from].filter(([id, pose]) => to.has(id) && differs(pose, to.get(id)!));
  if (moving.length === 0 || wantsStillness()) {
    done();
    return () => {};
  }
  let frame = 0, start = 0;
  const step = (now: number) => {
    start ||= now;
    const t = Math.min(1, (now - start) / kMilliseconds);
    if (t >= 1) return done();
    show(new Map(moving.map(([id, pose]) => [id, between(pose, to.get(id)!, easeOut(t))])));
    frame = requestAnimationFrame(step);
  };
  show(new Map(moving));
  frame = requestAnimationFrame(step);
  return () => {
    cancelAnimationFrame(frame);
    done();
  };
}
