// SPDX-License-Identifier: GPL-3.0-or-later
// Where a piece stands and which floor it covers. In its own frame O, x is its right and y its front; a heading of 0
// turns the front north, and headings grow counter-clockwise.
import { add, turned, vec, type Vec } from "./vec";

export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly theta: number;
}

export interface Size {
  readonly width: number;
  readonly depth: number;
}

export const sides = ["front", "left", "back", "right"] as const;
export type Side = (typeof sides)[number];

// Points from frame O to the side, of length 1.
const outward: Record<Side, Vec> = {
  front: vec(0, 1), left: vec(-1, 0), back: vec(0, -1), right: vec(1, 0),
};

export const center = (pose: Pose): Vec => vec(pose.x, pose.y);

export function toRoom(pose: Pose, inObject: Vec): Vec {
  return add(center(pose), turned(inObject, pose.theta));
}

export function toObject(pose: Pose, inRoom: Vec): Vec {
  return turned(vec(inRoom.x - pose.x, inRoom.y - pose.y), -pose.theta);
}

// Front left, back left, back right, front right: counter-clockwise.
export function corners(pose: Pose, size: Size): Vec[] {
  const w = size.width / 2, d = size.depth / 2;
  return [vec(-w, d), vec(-w, -d), vec(w, -d), vec(w, d)].map((corner) => toRoom(pose, corner));
}

// Away from the piece, in frame R.
export function normalOf(pose: Pose, side: Side): Vec {
  return turned(outward[side], pose.theta);
}

export function middleOf(pose: Pose, size: Size, side: Side): Vec {
  const n = outward[side];
  return toRoom(pose, vec((n.x * size.width) / 2, (n.y * size.depth) / 2));
}

export function reach(size: Size, side: Side): number {
  return side === "front" || side === "back" ? size.depth / 2 : size.width / 2;
}

// How long the side itself is.
export function extent(size: Size, side: Side): number {
  return side === "front" || side === "back" ? size.width : size.depth;
}

export function moved(pose: Pose, by: Vec): Pose {
  return { x: pose.x + by.x, y: pose.y + by.y, theta: pose.theta };
}

export function contains(pose: Pose, size: Size, point: Vec): boolean {
  const p = toObject(pose, point);
  return Math.abs(p.x) <= size.width / 2 && Math.abs(p.y) <= size.depth / 2;
}
