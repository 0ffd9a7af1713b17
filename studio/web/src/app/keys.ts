// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the whole page.
import { useEffect } from "preact/hooks";
import { redo, settle, undo } from "../state/commands";
import type { Studio } from "../state/studio";
import { isShowingKeys } from "./KeysDialog";
import { sidebarTab } from "./Sidebar";

function isTyping(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement;
  return (
    target.isContentEditable ||
    /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName) ||
    document.querySelector("dialog[open]") !== null
  );
}

function onCommand(studio: Studio, event: KeyboardEvent): boolean {
  const room = studio.open.peek();
  const key = event.key.toLowerCase();
  if (!room || (key !== "z" && key !== "y")) return false;
  const { undoLabel, redoLabel } = room.document.peek();
  const isRedo = key === "y" || event.shiftKey;
  if (isRedo && redoLabel) void redo(room);
  if (!isRedo && undoLabel) void undo(room);
  return true;
}

function onPlain(studio: Studio, key: string): boolean {
  const { settings } = studio;
  const room = studio.open.peek();
  switch (key) {
    case "?": isShowingKeys.value = true; return true;
    case "[": settings.turnSidebar(); return true;
    case "u": settings.turnUnits(); return true;
    case "s": if (room) void settle(room); return true;
    case "o": if (room && room.pieces.peek().size > 0) void room.search.start(); return true;
    case "f":
      settings.sidebar.value = "open";
      sidebarTab.value = "furniture";
      return true;
    case "1": settings.panes.value = "plan"; return true;
    case "2": settings.panes.value = "split"; return true;
    case "3": settings.panes.value = "3d"; return true;
    default: return false;
  }
}

export function usePageKeys(studio: Studio): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (isTyping(event) || event.defaultPrevented) return;
      const isCommand = event.ctrlKey || event.metaKey;
      if (isCommand ? onCommand(studio, event) : !event.altKey && onPlain(studio, event.key)) event.preventDefault();
    };
    addEventListener("keydown", onKeyDown);
    return () => removeEventListener("keydown", onKeyDown);
  }, [studio]);
}
