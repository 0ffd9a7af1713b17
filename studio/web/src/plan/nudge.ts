// SPDX-License-Identifier: GPL-3.0-or-later
// Arrow keys: pieces go on while a key is down and stand when it is up, as one act.
import { moved } from "../geometry/footprint";
import { add, vec, type Vec } from "../geometry/vec";
import type { Piece, Poses } from "../state/pieces";
import type { PlanController } from "./controller";

const directions: Record<string, Vec> = {
  ArrowLeft: vec(-1, 0), ArrowRight: vec(1, 0), ArrowUp: vec(0, 1), ArrowDown: vec(0, -1),
};

const kSmall = 0.01;
const kLarge = 0.1;
const kTogether_ms = 400;

export class Nudge {
  private by: Vec | undefined;
  private pieces: readonly Piece[] = [];
  private poses: Poses = new Map();
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly plan: PlanController) {}

  // Any other key is about pieces that stand.
  endBefore(event: KeyboardEvent): void {
    if (!directions[event.key] && event.key !== "Shift") this.finish();
  }

  // Whether the key was for it.
  down(event: KeyboardEvent): boolean {
    const direction = directions[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return false;
    if (!this.by) this.pieces = this.plan.chosen.peek().filter((piece) => !piece.pinned);
    if (this.pieces.length === 0) return false;
    clearTimeout(this.timer);
    this.plan.room.isHeld.value = true;
    const step = event.shiftKey ? kLarge : kSmall;
    this.by = add(this.by ?? vec(0, 0), vec(direction.x * step, direction.y * step));
    const by = this.by;
    this.poses = new Map(this.pieces.map((piece) => [piece.id, moved(piece.pose, by)]));
    this.plan.preview(this.poses);
    return true;
  }

  // Presses that follow soon are the same act.
  up(event: KeyboardEvent): void {
    if (directions[event.key] && this.by) this.timer = setTimeout(() => this.finish(), kTogether_ms);
  }

  finish(): void {
    clearTimeout(this.timer);
    if (!this.by) return;
    this.by = undefined;
    void this.plan.drop(this.poses);
    this.plan.room.isHeld.value = false;
  }
}
