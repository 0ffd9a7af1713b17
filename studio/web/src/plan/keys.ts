// SPDX-License-Identifier: GPL-3.0-or-later
// Keys while the plan has the focus. Those of the whole page are in app/keys.ts.
import { useEffect, useMemo } from "preact/hooks";
import { duplicatePieces, lockPieces, removePieces, turnPieces, withCarried } from "../state/commands";
import { isSolid, type Piece } from "../state/pieces";
import { editedClearance } from "./ClearanceField";
import { shownClearances } from "./clearance_of";
import type { PlanController } from "./controller";
import { Nudge } from "./nudge";
import { zoom } from "./view";

const kOfButtons = /^(Enter| |Tab|Escape|Arrow.*|Home|End)$/;

let copied: readonly Piece[] = [];

const turn = (plan: PlanController, angle: number) => turnPieces(plan.room, plan.chosen.peek(), angle);

// The next piece of the room, as tab does for fields; false at the end, where the focus goes on.
function step(plan: PlanController, by: 1 | -1): boolean {
  const ids = [...plan.room.pieces.peek().values()].filter(isSolid).map((piece) => piece.id);
  const at = ids.findIndex((id) => plan.room.selection.peek().has(id));
  const next = at < 0 ? (by > 0 ? 0 : ids.length - 1) : at + by;
  plan.room.select(ids[next] ? [ids[next]] : []);
  return ids[next] !== undefined;
}

function escape(plan: PlanController): void {
  const gesture = plan.gesture.peek();
  plan.gesture.value = undefined;
  if (gesture) gesture.cancel();
  else plan.room.select([]);
}

// The first distance of the one piece that is selected, to be typed.
function editClearance(plan: PlanController): boolean {
  const shown = shownClearances(plan);
  const first = shown?.list[0];
  if (!shown || !first || shown.piece.pinned) return false;
  editedClearance.value = { pieceId: shown.piece.id, side: first.side };
  return true;
}

function onCommand(plan: PlanController, key: string): boolean {
  const chosen = plan.chosen.peek();
  if (key === "a") plan.room.select(plan.room.pieces.peek().keys());
  else if (key === "c" && getSelection()?.isCollapsed !== false) copied = withCarried(plan.room, chosen);
  else if (key === "v") void duplicatePieces(plan.room, copied);
  else if (key === "d") void duplicatePieces(plan.room, withCarried(plan.room, chosen));
  else return false;
  return true;
}

function onPlain(plan: PlanController, event: KeyboardEvent): boolean {
  const chosen = plan.chosen.peek();
  switch (event.key) {
    case "Escape": escape(plan); return true;
    case "r": turn(plan, -Math.PI / 2); return true;
    case "R": case "t": case "T": turn(plan, Math.PI / 2); return true;
    case "l": case "L": if (chosen.length > 0) void lockPieces(plan.room, chosen); return true;
    case "Delete": case "Backspace":
      if (chosen.length > 0) void removePieces(plan.room, chosen.map((piece) => piece.id));
      return true;
    case "Enter": return editClearance(plan);
    case "0": plan.fit(); return true;
    case "+": case "=": zoom(plan, 1.25); return true;
    case "-": zoom(plan, 1 / 1.25); return true;
    case " ": plan.isSpaceDown.value = true; return true;
    case "Tab": return step(plan, event.shiftKey ? -1 : 1);
    default: return false;
  }
}

export function usePlanKeys(plan: PlanController) {
  const nudge = useMemo(() => new Nudge(plan), [plan]);
  const keys = useMemo(() => ({
    onKeyDown(event: KeyboardEvent) {
      if (event.target instanceof HTMLInputElement) return;
      if (event.target instanceof HTMLButtonElement && kOfButtons.test(event.key)) return;
      const isCommand = event.ctrlKey || event.metaKey;
      nudge.endBefore(event);
      const taken = nudge.down(event)
        || (isCommand ? onCommand(plan, event.key.toLowerCase()) : !event.altKey && onPlain(plan, event));
      if (!taken) return;
      event.preventDefault();
      event.stopPropagation();
    },
    onKeyUp: (event: KeyboardEvent) => nudge.up(event),
    onBlur: () => nudge.finish(),
  }), [plan, nudge]);
  useEffect(() => {
    // With the focus nowhere, keys are for the plan; with it on a button, those that mean nothing to buttons.
    const down = (event: KeyboardEvent) => {
      const target = event.target as HTMLElement;
      const isNowhere = target === document.body && event.key !== "Tab";
      const isOnButton =
        target.closest("button, a") && !target.closest("dialog, [role=menu]") && !kOfButtons.test(event.key);
      if ((isNowhere || isOnButton) && !event.defaultPrevented) keys.onKeyDown(event);
    };
    const up = (event: KeyboardEvent) => {
      if (event.key === " ") plan.isSpaceDown.value = false;
      if (event.target === document.body) keys.onKeyUp(event);
    };
    addEventListener("keydown", down);
    addEventListener("keyup", up);
    return () => {
      removeEventListener("keydown", down);
      removeEventListener("keyup", up);
    };
  }, [plan, keys]);
  return keys;
}
