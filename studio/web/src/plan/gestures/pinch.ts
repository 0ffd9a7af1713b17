// SPDX-License-Identifier: GPL-3.0-or-later
import { distance, middle, sub, type Vec } from "../../geometry/vec";
import { panned, zoomedAt } from "../view";
import type { Viewed } from "../wheel";

// Two fingers on glass: they pan and zoom at once.
export class Pinch {
  private readonly fingers = new Map<number, Vec>();

  constructor(private readonly plan: Viewed) {}

  // Whether two fingers are down from now on.
  down(event: PointerEvent): boolean {
    if (event.pointerType === "touch") this.fingers.set(event.pointerId, this.plan.pixelOf(event));
    return this.fingers.size > 1;
  }

  move(event: PointerEvent): boolean {
    if (!this.fingers.has(event.pointerId)) return false;
    const before = this.pair();
    this.fingers.set(event.pointerId, this.plan.pixelOf(event));
    const after = this.pair();
    if (!before || !after) return false;
    const from = middle(...before), to = middle(...after);
    const factor = distance(...after) / Math.max(distance(...before), 1);
    this.plan.setView(zoomedAt(panned(this.plan.view.peek(), sub(to, from)), to, factor));
    return true;
  }

  up(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
  }

  private pair(): [Vec, Vec] | undefined {
    const [a, b] = [...this.fingers.values()];
    return a && b ? [a, b] : undefined;
  }
}
