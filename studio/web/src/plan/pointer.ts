// SPDX-License-Identifier: GPL-3.0-or-later
// From presses to gestures: what is under the pointer decides which.
import { useMemo } from "preact/hooks";
import { grips } from "../geometry/resize";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { carrierOf, clicked } from "../state/pieces";
import type { PlanController } from "./controller";
import type { Gesture } from "./gesture";
import { marqueeGesture } from "./gestures/marquee";
import { moveGesture } from "./gestures/move";
import { panGesture } from "./gestures/pan";
import { Pinch } from "./gestures/pinch";
import { resizeGesture } from "./gestures/resize";
import { rotateGesture } from "./gestures/rotate";

const kMiddleButton = 1;

function attributeOf(event: Event, name: string): string | undefined {
  return (event.target as Element).closest<SVGElement>(`[data-${name}]`)?.dataset[name];
}

// What hangs from the ceiling lets through to what stands below it; by its name it is taken everywhere.
function belowCeiling(plan: PlanController, event: MouseEvent, id: string): string {
  const pieces = plan.room.pieces.peek(), isHung = (one: string) => pieces.get(one)?.object.kind === ObjectKind.CEILING;
  if (!isHung(id) || (event.target as Element).closest(".labels")) return id;
  const stack = document.elementsFromPoint(event.clientX, event.clientY);
  const others = stack.flatMap((element) => element.closest<SVGElement>("[data-piece]")?.dataset.piece ?? []);
  return others.find((one) => pieces.has(one) && !isHung(one) && !pieces.get(one)!.object.walkOver) ?? id;
}

interface Meant {
  // What a click selects, and what a drag moves.
  readonly clicked: string;
  readonly dragged: string;
}

// How far from each other two clicks are on the same spot, pixels.
const kSameSpot = 4;

// A click selects the topmost piece under the pointer, the next one on the same spot what carries it. A drag takes along what
// carries the piece, unless that one is selected or asked for by ctrl.
function meantAt(plan: PlanController, event: MouseEvent): Meant | undefined {
  const above = attributeOf(event, "piece");
  if (above === undefined) return undefined;
  const pieces = plan.room.pieces.peek(), selection = plan.room.selection.peek();
  const isAskedFor = event.ctrlKey || event.metaKey;
  const id = isAskedFor || selection.has(above) ? above : belowCeiling(plan, event, above);
  const { lastClick } = plan, at = plan.pixelOf(event);
  const isSameSpot = lastClick !== undefined && Math.hypot(at.x - lastClick.x, at.y - lastClick.y) <= kSameSpot;
  return {
    clicked: clicked(pieces, id, selection, isSameSpot && !isAskedFor && !event.shiftKey),
    dragged: isAskedFor || selection.has(id) ? id : carrierOf(pieces, id),
  };
}

function gestureFor(plan: PlanController, event: PointerEvent): Gesture | undefined {
  if (event.button === kMiddleButton || (event.button === 0 && plan.isSpaceDown.peek())) return panGesture(plan, event);
  if (event.button !== 0) return undefined;
  if (attributeOf(event, "rotate") !== undefined) return rotateGesture(plan, event);
  const grip = attributeOf(event, "grip");
  const [piece] = plan.chosen.peek();
  if (grip !== undefined && piece) return resizeGesture(plan, piece, grips[Number(grip)]!);
  const meant = meantAt(plan, event);
  if (meant) return moveGesture(plan, event, meant);
  return event.pointerType === "touch" ? panGesture(plan, event) : marqueeGesture(plan, event);
}

function cancel(plan: PlanController): void {
  const gesture = plan.gesture.peek();
  plan.gesture.value = undefined;
  gesture?.cancel();
}

function handlers(plan: PlanController) {
  const pinch = new Pinch(plan);
  return {
    onPointerDown(event: PointerEvent) {
      if (pinch.down(event)) return cancel(plan);
      if (plan.gesture.peek() || attributeOf(event, "field") !== undefined) return;
      const gesture = gestureFor(plan, event);
      if (!gesture) return;
      event.preventDefault();
      plan.element?.parentElement?.focus({ preventScroll: true });
      plan.element?.setPointerCapture(event.pointerId);
      plan.room.pointedAt.value = undefined;
      plan.gesture.value = gesture;
    },
    onPointerMove(event: PointerEvent) {
      if (pinch.move(event)) return;
      const gesture = plan.gesture.peek();
      if (gesture) gesture.move(event);
      else plan.room.hovered.value = meantAt(plan, event)?.clicked ?? "";
    },
    onPointerUp(event: PointerEvent) {
      pinch.up(event);
      plan.gesture.peek()?.end(event);
      plan.gesture.value = undefined;
    },
    onPointerCancel(event: PointerEvent) {
      pinch.up(event);
      cancel(plan);
    },
    onPointerLeave() { plan.room.hovered.value = ""; },
    onDblClick(event: MouseEvent) {
      // The pointer was captured: what is below it, not who caught it.
      const below = document.elementFromPoint(event.clientX, event.clientY) ?? (event.target as Element);
      if (!below.closest("[data-piece]") && attributeOf(event, "field") === undefined) plan.fit();
    },
  };
}

export function usePlanPointer(plan: PlanController) {
  return useMemo(() => handlers(plan), [plan]);
}
