// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the room editor: everything that the pointer does can be done with them and the panel's fields.
import { useMemo } from "preact/hooks";
import { parseLength } from "../app/units";
import { vec, type Vec } from "../geometry/vec";
import { zoom } from "../plan/view";
import { nudge, removeSelected } from "./acts";
import type { RoomDrawing, Tool } from "./controller";

const arrows: Record<string, Vec> = {
  ArrowUp: vec(0, 1),
  ArrowDown: vec(0, -1),
  ArrowLeft: vec(-1, 0),
  ArrowRight: vec(1, 0),
};
const tools: Record<string, Tool> = { v: "select", d: "door", w: "window", e: "socket" };
const isOfLength = /^[0-9.,'"′″ ]$/;

function isField(target: EventTarget | null): boolean {
  return /^(INPUT|TEXTAREA|SELECT)$/.test((target as HTMLElement | null)?.tagName ?? "");
}

function onPen(drawing: RoomDrawing, event: KeyboardEvent): boolean {
  const typed = drawing.typed.peek(),
    { corners } = drawing.sketch.peek();
  const direction = arrows[event.key];
  if (direction && corners.length > 0) {
    drawing.direct(direction);
    return true;
  }
  if (event.key === "Enter") {
    const metres = parseLength(typed, drawing.studio.settings.units.peek());
    if (typed && metres !== undefined) drawing.addTypedCorner(metres);
    else if (!typed && corners.length === 0) drawing.addCorner({ at: vec(0, 0), inLine: [], closes: false });
    else if (!typed) drawing.close();
    return true;
  }
  if (event.key === "Backspace") {
    if (typed) drawing.typed.value = typed.slice(0, -1);
    else drawing.undo();
    return true;
  }
  if (event.key === "Escape" && typed) {
    drawing.typed.value = "";
    return true;
  }
  // A unit may follow the figure: "90 cm".
  const isUnit = typed !== "" && /^[cmftin]$/.test(event.key);
  if (
    corners.length === 0 ||
    !drawing.pen.peek() ||
    (!isOfLength.test(event.key) && !isUnit) ||
    (event.key === " " && !typed)
  )
    return false;
  drawing.typed.value = typed + event.key;
  return true;
}

function onEscape(drawing: RoomDrawing): void {
  const gesture = drawing.gesture.peek();
  if (gesture) {
    drawing.gesture.value = undefined;
    gesture.cancel();
  } else if (drawing.scaling.peek()) {
    drawing.scaling.value = undefined;
  } else if (drawing.tool.peek() !== "select") {
    drawing.take("select");
  } else {
    drawing.select(undefined);
  }
}

function onPlain(drawing: RoomDrawing, event: KeyboardEvent): boolean {
  const by = arrows[event.key],
    tool = tools[event.key];
  if (by && drawing.selection.peek()) {
    const step = event.shiftKey ? 0.1 : 0.01;
    nudge(drawing, vec(by.x * step, by.y * step));
  } else if (tool && drawing.sketch.peek().isClosed) {
    drawing.take(tool);
  } else if (event.key === "Delete" || event.key === "Backspace") {
    removeSelected(drawing);
  } else if (event.key === "+" || event.key === "=") {
    zoom(drawing, 1.25);
  } else if (event.key === "-") {
    zoom(drawing, 0.8);
  } else if (event.key === "0") {
    drawing.fit();
  } else {
    return false;
  }
  return true;
}

function onCommand(drawing: RoomDrawing, event: KeyboardEvent): boolean {
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return false;
  if (key === "y" || event.shiftKey) drawing.redo();
  else drawing.undo();
  return true;
}

export function useDrawingKeys(drawing: RoomDrawing) {
  return useMemo(
    () => ({
      onKeyDown(event: KeyboardEvent) {
        if (isField(event.target)) return;
        const isOnButton = (event.target as HTMLElement).tagName === "BUTTON";
        if (isOnButton && (event.key === "Enter" || event.key === " ")) return;
        let isTaken = false;
        if (event.ctrlKey || event.metaKey) isTaken = onCommand(drawing, event);
        else if (drawing.mode.peek() === "pen" && onPen(drawing, event)) isTaken = true;
        else if (event.key === "Escape") (onEscape(drawing), (isTaken = true));
        else if (event.key === " ") drawing.isSpaceDown.value = isTaken = true;
        else if (!event.altKey) isTaken = onPlain(drawing, event);
        if (!isTaken) return;
        event.preventDefault();
        event.stopPropagation();
      },
      onKeyUp(event: KeyboardEvent) {
        if (event.key === " ") drawing.isSpaceDown.value = false;
      },
    }),
    [drawing],
  );
}
