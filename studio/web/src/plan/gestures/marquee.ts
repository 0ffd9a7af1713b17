// SPDX-License-Identifier: GPL-3.0-or-later
import { boxesMeet, boxOf } from "../../geometry/polygon";
import { footprintOf, isSolid } from "../../state/pieces";
import type { PlanController } from "../controller";
import { kDragStart, type Gesture } from "../gesture";
import { toRoom } from "../view";

// Selects what the rectangle touches; a click on nothing selects nothing. Shift adds to what is selected.
export function marqueeGesture(plan: PlanController, start: PointerEvent): Gesture {
  const from = plan.pixelOf(start);
  const before = start.shiftKey ? plan.room.selection.peek() : new Set<string>();
  return {
    cursor: "crosshair",
    move(event) {
      const to = plan.pixelOf(event);
      if (!plan.marquee.peek() && Math.hypot(to.x - from.x, to.y - from.y) < kDragStart) return;
      const box = boxOf([from, to]);
      plan.marquee.value = box;
      const view = plan.view.peek();
      const inRoom = boxOf([toRoom(view, box.min), toRoom(view, box.max)]);
      const touched = [...plan.room.pieces.peek().values()]
        .filter((piece) => isSolid(piece) && boxesMeet(inRoom, boxOf(footprintOf(piece)))).map((piece) => piece.id);
      plan.room.select([...before, ...touched]);
    },
    end() {
      if (!plan.marquee.peek() && !start.shiftKey) plan.room.select([]);
      plan.marquee.value = undefined;
    },
    cancel() {
      plan.marquee.value = undefined;
      plan.room.select(before);
    },
  };
}
