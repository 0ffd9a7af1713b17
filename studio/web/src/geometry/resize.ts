// SPDX-License-Identifier: GPL-3.0-or-later
// A piece that is pulled at a side or corner: the opposite one stays.
import { toObject, toRoom, type Pose, type Size } from "./footprint";
import { vec, type Vec } from "./vec";

// Which side is pulled, in frame O: x is -1 for the left one, 1 for the right one; y is 1 for the front, -1 for the
// back.
export interface Grip {
  readonly x: -1 | 0 | 1;
  readonly y: -1 | 0 | 1;
}

export const grips: readonly Grip[] = [
  { x: -1, y: 1 }, { x: 0, y: 1 }, { x: 1, y: 1 }, { x: 1, y: 0 },
  { x: 1, y: -1 }, { x: 0, y: -1 }, { x: -1, y: -1 }, { x: -1, y: 0 },
];

export interface Resized {
  readonly pose: Pose;
  readonly size: Size;
}

export const kSmallest = 0.05;
export const kLargest = 20;

const within = (metres: number) => Math.min(kLargest, Math.max(kSmallest, metres));

export function gripAt(pose: Pose, size: Size, grip: Grip): Vec {
  return toRoom(pose, vec((grip.x * size.width) / 2, (grip.y * size.depth) / 2));
}

// The piece with these sizes, its side or corner opposite of the grip where it was.
export function resizedTo(pose: Pose, size: Size, grip: Grip, to: Size): Resized {
  const shift = vec((grip.x * (to.width - size.width)) / 2, (grip.y * (to.depth - size.depth)) / 2);
  return { pose: { ...toRoom(pose, shift), theta: pose.theta }, size: to };
}

// The grip pulled to a point of the room; sizes to whole multiples of `step` metres.
export function pulled(pose: Pose, size: Size, grip: Grip, to: Vec, step: number): Resized {
  const p = toObject(pose, to);
  const round = (metres: number) => within(Math.round(metres / step) * step);
  const width = grip.x === 0 ? size.width : round(grip.x * p.x + size.width / 2);
  const depth = grip.y === 0 ? size.depth : round(grip.y * p.y + size.depth / 2);
  return resizedTo(pose, size, grip, { width, depth });
}
