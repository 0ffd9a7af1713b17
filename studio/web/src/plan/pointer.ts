// SPDX-License-Identifier: GPL-3.0-or-later
// From presses to gestures: what is under the pointer decides which.
import { useMemo } from "preact/hooks";
import { grips } from "../geometry/resize";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { carrierOf } from "../state/pieces";
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

// The piece that is meant: what carries the one under the pointer, unless that one is selected or asked for by ctrl.
function pieceAt(plan: PlanController, event: MouseEvent): string | undefined {
  const above = attributeOf(event, "piece");
  const { selection, pieces } = plan.room, isAskedFor = event.ctrlKey || event.metaKey;
  if (above === undefined || isAskedFor || selection.peek().has(above)) return above;
  const id = belowCeiling(plan, event, above);
  return selection.peek().has(id) ? id : carrierOf(pieces.peek(), id);
}

function gestureFor(plan: PlanController, event: PointerEvent): Gesture | undefined {
  if (event.button === kMiddleButton || (event.button === 0 && plan.isSpaceDown.peek())) return panGesture(plan, event);
  if (event.button !== 0) return undefined;
  if (attributeOf(event, "rotate") !== undefined) return rotateGesture(plan, event);
  const grip = attributeOf(event, "grip");
  const [piece] = plan.chosen.peek();
  if (grip !== undefined && piece) return resizeGesture(plan, piece, grips[Number(grip)]!);
  const pressed = pieceAt(plan, event);
  if (pressed) return moveGesture(plan, event, pressed);
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
      else plan.room.hovered.value = pieceAt(plan, event) ?? "";
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
      const id = below.closest<SVGElement>("[data-piece]")?.dataset.piece;
      if (id !== undefined) plan.room.select([id]);
      else if (attributeOf(event, "field") === undefined) plan.fit();
    },
  };
}

export function usePlanPointer(plan: PlanController) {
  return useMemo(() => handlers(plan), [plan]);
}
