// SPDX-License-Identifier: GPL-3.0-or-later
import type { Vec } from "../../geometry/vec";
import { toScreen, type View } from "../view";

// "x,y x,y" for a polygon of the room, in pixels.
export function pixelPoints(view: View, polygon: readonly Vec[]): string {
  return polygon.map((p) => {
    const at = toScreen(view, p);
    return `${at.x.toFixed(1)},${at.y.toFixed(1)}`;
  }).join(" ");
}
