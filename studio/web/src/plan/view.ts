// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of the room is on the screen: pixel = (x * scale + left, -y * scale + top).
import type { Signal } from "@preact/signals";
import { boxOf } from "../geometry/polygon";
import { vec, type Vec } from "../geometry/vec";

export interface View {
  // Pixels a metre.
  readonly scale: number;
  // Where the room's origin is, pixels.
  readonly left: number;
  readonly top: number;
}

// What is looked at through a view: the plan, the editor of a room.
export interface Viewed {
  readonly view: Signal<View>;
  readonly width: Signal<number>;
  readonly height: Signal<number>;
  setView(view: View): void;
  fit(): void;
}

export const kMinScale = 8;
export const kMaxScale = 1200;

export const toScreen = (view: View, p: Vec): Vec => vec(p.x * view.scale + view.left, -p.y * view.scale + view.top);
export const toRoom = (view: View, p: Vec): Vec =>
  vec((p.x - view.left) / view.scale, (view.top - p.y) / view.scale);

export const panned = (view: View, by: Vec): View => ({ ...view, left: view.left + by.x, top: view.top + by.y });

// Scales by `factor` and keeps what is under the pixel there.
export function zoomedAt(view: View, pixel: Vec, factor: number): View {
  const scale = Math.min(kMaxScale, Math.max(kMinScale, view.scale * factor));
  const k = scale / view.scale;
  return { scale, left: pixel.x - (pixel.x - view.left) * k, top: pixel.y - (pixel.y - view.top) * k };
}

// In or out at the middle of what is shown.
export function zoom(of: Viewed, factor: number): void {
  of.setView(zoomedAt(of.view.peek(), vec(of.width.peek() / 2, of.height.peek() / 2), factor));
}

// The whole of the points, with a margin in pixels on each side.
export function fitted(points: readonly Vec[], width: number, height: number, margin: number): View {
  const box = boxOf(points);
  const w = Math.max(box.max.x - box.min.x, 0.1), h = Math.max(box.max.y - box.min.y, 0.1);
  const free = (side: number) => Math.max(side - 2 * margin, side * 0.4, 1);
  const scale = Math.min(kMaxScale, Math.max(kMinScale, Math.min(free(width) / w, free(height) / h)));
  const x = (box.min.x + box.max.x) / 2, y = (box.min.y + box.max.y) / 2;
  return { scale, left: width / 2 - x * scale, top: height / 2 + y * scale };
}
