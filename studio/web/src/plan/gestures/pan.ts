// SPDX-License-Identifier: GPL-3.0-or-later
import type { PlanController } from "../controller";
import type { Gesture } from "../gesture";
import { panned } from "../view";

// Moves the view with the pointer.
export function panGesture(plan: PlanController, start: PointerEvent): Gesture {
  const before = plan.view.peek();
  return {
    cursor: "grabbing",
    move(event) {
      plan.setView(panned(before, { x: event.clientX - start.clientX, y: event.clientY - start.clientY }));
    },
    end() {},
    cancel() { plan.view.value = before; },
  };
}
