// SPDX-License-Identifier: GPL-3.0-or-later
// From presses to gestures, by what is under the pointer and the tool in hand.
import { useMemo } from "preact/hooks";
import type { Vec } from "../geometry/vec";
import { kSnapPixels, type Gesture } from "../plan/gesture";
import { Pinch } from "../plan/gestures/pinch";
import { dot, sub } from "../geometry/vec";
import { addCornerOn } from "./acts";
import type { RoomDrawing, Selection, Tool } from "./controller";
import { isInTheWay, newFixture, withFixture } from "./fixtures";
import { dragCorner, dragEnd, dragFixture, dragWall, ghostAt, panGesture } from "./gestures";
import { penAt, type PenPoint } from "./pen";

const kPenStep = 0.05;
const kMiddleButton = 1;

function attribute(event: Event, name: string): string | undefined {
  return (event.target as Element).closest<SVGElement>(`[data-${name}]`)?.dataset[name];
}

function penOf(drawing: RoomDrawing, event: PointerEvent): PenPoint {
  const options = { within: drawing.metresOf(kSnapPixels * 1.25), isFree: event.altKey, step: kPenStep };
  return penAt(drawing.sketch.peek().corners, drawing.pointOf(event), options);
}

// Follows the pointer until it is released: a finger has no hover.
function penGesture(drawing: RoomDrawing, start: PointerEvent): Gesture {
  drawing.pen.value = penOf(drawing, start);
  return {
    cursor: "crosshair",
    move(event) {
      drawing.pen.value = penOf(drawing, event);
    },
    end(event) {
      drawing.addCorner(penOf(drawing, event));
    },
    cancel() {
      drawing.pen.value = undefined;
    },
  };
}

function scaleGesture(drawing: RoomDrawing): Gesture {
  return {
    cursor: "crosshair",
    move() {},
    end(event) {
      const points: readonly Vec[] = drawing.scaling.peek() ?? [];
      drawing.scaling.value = points.length >= 2 ? [drawing.pointOf(event)] : [...points, drawing.pointOf(event)];
    },
    cancel() {},
  };
}

function placeGesture(drawing: RoomDrawing, start: PointerEvent, kind: Exclude<Tool, "select">): Gesture {
  const show = (event: PointerEvent) => {
    drawing.ghost.value = ghostAt(drawing, newFixture(drawing.sketch.peek(), kind, "", 0), event);
  };
  show(start);
  return {
    cursor: "copy",
    move: show,
    end() {
      const placed = drawing.ghost.peek();
      if (!placed) return drawing.studio.toasts.note("Put it on a wall.");
      drawing.ghost.value = undefined;
      drawing.commit(withFixture(drawing.sketch.peek(), placed), `add a ${kind}`);
      drawing.select({ kind: "fixture", id: placed.id });
    },
    cancel() {
      drawing.ghost.value = undefined;
    },
  };
}

// What is there already where the tool in hand would put another: it is taken instead.
function takenAt(drawing: RoomDrawing, tool: Exclude<Tool, "select">, id: string | undefined): string | undefined {
  const fixture = drawing.sketch.peek().fixtures.find((one) => one.id === id);
  return fixture && isInTheWay(tool, fixture) ? fixture.id : undefined;
}

function gestureFor(drawing: RoomDrawing, event: PointerEvent): Gesture | undefined {
  if (event.button === kMiddleButton || (event.button === 0 && drawing.isSpaceDown.peek()))
    return panGesture(drawing, event);
  if (event.button !== 0) return undefined;
  const mode = drawing.mode.peek();
  if (mode === "scale") return scaleGesture(drawing);
  if (mode === "pen") return penGesture(drawing, event);
  const one = drawing.selection.peek(),
    end = attribute(event, "end");
  if (one?.kind === "fixture" && (end === "start" || end === "end")) return dragEnd(drawing, event, one.id, end);
  const corner = attribute(event, "corner"),
    fixture = attribute(event, "fixture"),
    wall = attribute(event, "wall");
  const taken = mode === "select" ? fixture : takenAt(drawing, mode, fixture);
  if (taken) {
    drawing.ghost.value = undefined;
    return dragFixture(drawing, event, taken);
  }
  if (mode !== "select") return placeGesture(drawing, event, mode);
  if (corner) return dragCorner(drawing, event, corner);
  if (wall) return dragWall(drawing, event, wall);
  return panGesture(drawing, event, () => drawing.select(undefined));
}

function under(event: PointerEvent): Selection | undefined {
  const corner = attribute(event, "corner"),
    fixture = attribute(event, "fixture"),
    wall = attribute(event, "wall");
  if (corner) return { kind: "corner", key: corner };
  if (fixture) return { kind: "fixture", id: fixture };
  return wall ? { kind: "wall", key: wall } : undefined;
}

function hover(drawing: RoomDrawing, event: PointerEvent): void {
  const mode = drawing.mode.peek();
  if (mode === "pen" && !drawing.typed.peek()) drawing.pen.value = penOf(drawing, event);
  if (mode === "door" || mode === "window" || mode === "socket") {
    const taken = takenAt(drawing, mode, attribute(event, "fixture"));
    drawing.ghost.value = taken ? undefined : ghostAt(drawing, newFixture(drawing.sketch.peek(), mode, "", 0), event);
    drawing.hovered.value = taken ? { kind: "fixture", id: taken } : undefined;
    return;
  }
  drawing.hovered.value = mode === "select" ? under(event) : undefined;
}

function cancel(drawing: RoomDrawing): void {
  const gesture = drawing.gesture.peek();
  drawing.gesture.value = undefined;
  gesture?.cancel();
}

function handlers(drawing: RoomDrawing) {
  const pinch = new Pinch(drawing);
  return {
    onPointerDown(event: PointerEvent) {
      if (pinch.down(event)) return cancel(drawing);
      if (drawing.gesture.peek() || attribute(event, "field") !== undefined) return;
      const gesture = gestureFor(drawing, event);
      if (!gesture) return;
      event.preventDefault();
      drawing.element?.parentElement?.focus({ preventScroll: true });
      drawing.element?.setPointerCapture(event.pointerId);
      drawing.gesture.value = gesture;
    },
    onPointerMove(event: PointerEvent) {
      if (pinch.move(event)) return;
      const gesture = drawing.gesture.peek();
      if (gesture) gesture.move(event);
      else hover(drawing, event);
    },
    onPointerUp(event: PointerEvent) {
      pinch.up(event);
      const gesture = drawing.gesture.peek();
      drawing.gesture.value = undefined;
      gesture?.end(event);
    },
    onPointerCancel(event: PointerEvent) {
      pinch.up(event);
      cancel(drawing);
    },
    onPointerLeave() {
      drawing.hovered.value = undefined;
      drawing.ghost.value = undefined;
      if (!drawing.typed.peek()) drawing.pen.value = undefined;
    },
    onDblClick(event: MouseEvent) {
      const key = drawing.mode.peek() === "select" ? attribute(event, "wall") : undefined;
      const wall = drawing.walls.peek().find((one) => one.key === key);
      if (!wall || attribute(event, "field") !== undefined) return;
      const along = dot(sub(drawing.pointOf(event), wall.a), wall.along);
      addCornerOn(drawing, wall.index, Math.round(along / kPenStep) * kPenStep);
    },
  };
}

export function useDrawingPointer(drawing: RoomDrawing) {
  return useMemo(() => handlers(drawing), [drawing]);
}
