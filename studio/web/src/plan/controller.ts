// SPDX-License-Identifier: GPL-3.0-or-later
// What the plan shows beside the room itself: the view, guides, marquee, and the gesture that runs.
import { computed, signal } from "@preact/signals";
import type { Box } from "../geometry/polygon";
import type { Guide } from "../geometry/snap";
import { vec, type Vec } from "../geometry/vec";
import type { OpenRoom } from "../state/open_room";
import type { Piece, Poses } from "../state/pieces";
import { standAt } from "../state/commands";
import { placementOf, withGuests } from "../state/pieces";
import type { Studio } from "../state/studio";
import type { Gesture } from "./gesture";
import { fitted, toRoom, type View } from "./view";

// Walls, and how long they are beside them.
const kLeastMargin = 46;
// The scale bar and the buttons at the foot, pixels.
const kFoot = 30;

export class PlanController {
  readonly view = signal<View>({ scale: 80, left: 0, top: 0 });
  readonly width = signal(0);
  readonly height = signal(0);
  readonly guides = signal<readonly Guide[]>([]);
  // In pixels.
  readonly marquee = signal<Box | undefined>(undefined);
  readonly gesture = signal<Gesture | undefined>(undefined);
  readonly isSpaceDown = signal(false);
  // Where the last click on a piece was, in pixels; undefined after anything else.
  lastClick: Vec | undefined;
  // The pieces that are selected, in the layout's order.
  readonly chosen = computed<Piece[]>(() => {
    const selection = this.room.selection.value;
    return [...this.room.pieces.value.values()].filter((piece) => selection.has(piece.id));
  });
  // Whether the user has panned or zoomed since the room was fitted.
  isViewOwn = false;

  constructor(readonly room: OpenRoom, readonly studio: Studio) {}

  // Of an event, relative to the plan's corner.
  pixelOf(event: { clientX: number; clientY: number; currentTarget?: EventTarget | null }): Vec {
    const box = this.element!.getBoundingClientRect();
    return vec(event.clientX - box.left, event.clientY - box.top);
  }

  element: SVGSVGElement | null = null;

  pointOf(event: { clientX: number; clientY: number }): Vec {
    return toRoom(this.view.peek(), this.pixelOf(event));
  }

  fit(): void {
    const floor = this.room.floor.peek();
    if (floor.length === 0 || this.width.peek() === 0) return;
    const narrow = Math.min(this.width.peek(), this.height.peek());
    this.view.value = fitted(floor, this.width.peek(), this.height.peek() - kFoot, Math.min(72, Math.max(kLeastMargin, narrow * 0.09)));
    this.isViewOwn = false;
  }

  setView(view: View): void {
    this.view.value = view;
    this.isViewOwn = true;
  }

  // Shows the pieces there, with what stands on them, and asks for verdicts.
  preview(poses: Poses): void {
    const all = withGuests(this.room.pieces.peek(), poses);
    this.room.draft.value = all;
    const pieces = this.room.pieces.peek();
    this.room.judging.ask([...all].map(([id, pose]) => placementOf(pieces.get(id)!, pose)));
  }

  // Lets them stand there: one act.
  async drop(poses: Poses): Promise<void> {
    this.guides.value = [];
    await standAt(this.room, poses);
  }

  abandon(): void {
    this.guides.value = [];
    this.room.draft.value = new Map();
    this.room.judging.end();
  }
}
